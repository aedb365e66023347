#include "gi_module/techniques/emc/maps/reserved_centres.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lanthorn::gi {

namespace {

constexpr double kLeastShare = 0.0005;  // of the picture's rays
constexpr double kGain = 1.5;           // of what is shown, when one centre takes another's place
constexpr float kCluster = 0.06f;       // of the diagonal: places as near as that are seen together
constexpr float kNearerTrial = 0.02f;   // of the diagonal: how far off its place the nearer of two trials is

// Rays whose places some of the centres see.
double shown(const UnseenSurvey& survey, const std::vector<std::vector<bool>>& seen,
             const std::vector<int>& centres) {
    double rays = 0;
    for (std::size_t p = 0; p < survey.places.size(); ++p) {
        const bool any =
            std::ranges::any_of(centres, [&](int c) { return seen[static_cast<std::size_t>(c)][p]; });
        rays += any ? static_cast<double>(survey.places[p].rays) : 0;
    }
    return rays;
}

}  // namespace

bool lacks_maps(const UnseenSurvey& survey) {
    return survey.unseen > kLeastShare * survey.rays;
}

std::vector<vec3> trial_centres(const UnseenSurvey& survey, float diagonal, int count) {
    const std::vector<UnseenPlace>& places = survey.places;
    std::vector<bool> left(places.size(), true);
    std::vector<vec3> centres;
    while (static_cast<int>(centres.size()) + 1 < count) {
        std::size_t best = places.size();
        double most = 0;
        for (std::size_t i = 0; i < places.size(); ++i) {
            double around = 0;
            for (std::size_t j = 0; j < places.size() && left[i]; ++j) {
                const double d = static_cast<double>(glm::distance(places[i].place, places[j].place) /
                                                     (kCluster * diagonal));
                around += left[j] ? static_cast<double>(places[j].rays) * std::exp2(-d * d) : 0;
            }
            if (around > most) {
                most = around;
                best = i;
            }
        }
        if (best == places.size()) {
            break;
        }
        const UnseenPlace& ray = places[best];
        const vec3 back = ray.start - ray.place;
        const float half = 0.5f * glm::length(back);
        centres.push_back(ray.place + 0.5f * back);
        if (half > kNearerTrial * diagonal) {
            centres.push_back(ray.place + back * (kNearerTrial * diagonal / (2 * half)));
        }
        for (std::size_t j = 0; j < places.size(); ++j) {
            left[j] = left[j] && glm::distance(ray.place, places[j].place) > 0.5f * kCluster * diagonal;
        }
    }
    return centres;
}

Reservation reservation(const UnseenSurvey& survey, const std::vector<std::vector<bool>>& seen, int in_use,
                        int most) {
    std::vector<int> now(static_cast<std::size_t>(in_use));
    std::iota(now.begin(), now.end(), 0);
    const double before = shown(survey, seen, now);
    const double least = kLeastShare * survey.rays;
    Reservation result;
    double best = in_use < most ? before + least : std::max(kGain * before, before + least);
    for (int trial = in_use; trial < static_cast<int>(seen.size()); ++trial) {
        for (int replaced = in_use < most ? -1 : 0; replaced < (in_use < most ? 0 : in_use); ++replaced) {
            std::vector<int> next = now;
            if (replaced < 0) {
                next.push_back(trial);
            } else {
                next[static_cast<std::size_t>(replaced)] = trial;
            }
            const double rays = shown(survey, seen, next);
            if (rays > best) {
                best = rays;
                result = {trial, replaced};
            }
        }
    }
    return result;
}

}  // namespace lanthorn::gi

// Centres that are reserved for places which no other map shows.
#include <algorithm>
#include <utility>

#include "gi_module/techniques/emc/maps/map_centres.h"
#include "gi_module/techniques/emc/maps/reserved_centres.h"
#include "lanthorn/emc/emc_settings.h"

namespace lanthorn::gi {

namespace {

constexpr int kTrialLook = 10;         // LayeredMaps::update; those before are the shares'
constexpr double kClearance = 0.0015;  // of the diagonal: they may stand in narrow gaps

}  // namespace

MapCentres::Reserved MapCentres::reserve(const FrameScene& scene, const render::GpuScene& gpu_scene,
                                         const GiSettings& settings, const UnseenSurvey& survey) {
    const int most = std::min(settings.of<EmcSettings>().reserved, kMostReserved);
    if (most == 0 || survey.places.empty() || selected_.empty()) {
        return {};
    }
    const int ordinary = static_cast<int>(candidates_.size());
    std::vector<int> viewers;
    for (std::size_t r = 0; r < reserved_.size(); ++r) {
        viewers.push_back(ordinary + static_cast<int>(r));
    }
    const std::vector<vec3> trials = trial_centres(survey, bulk_.diagonal(), kTrials);
    for (std::size_t t = 0; t < trials.size(); ++t) {
        viewers.push_back(ordinary + kMostReserved + static_cast<int>(t));
        meter_.move(viewers.back(), trials[t]);
    }
    meter_.draw(scene, gpu_scene, viewers, kTrialLook);
    std::vector<std::vector<bool>> seen = meter_.sees(viewers, survey.places);
    const std::vector<Coverage> coverage = meter_.measure(viewers, {});
    for (std::size_t v = 0; v < viewers.size(); ++v) {
        if (!in_the_open(coverage[v], bulk_.diagonal(), kClearance)) {
            seen[v].assign(survey.places.size(), false);
        }
    }
    std::vector<vec3> centres = reserved_;
    centres.insert(centres.end(), trials.begin(), trials.end());
    std::size_t in_use = reserved_.size();
    int replaced = -1;
    Reservation chosen = reservation(survey, seen, static_cast<int>(in_use), most);
    const std::size_t before = in_use;
    while (chosen.trial >= 0) {
        replaced = chosen.replaced;
        const std::size_t at = replaced < 0 ? in_use++ : static_cast<std::size_t>(replaced);
        std::swap(centres[at], centres[static_cast<std::size_t>(chosen.trial)]);
        std::swap(seen[at], seen[static_cast<std::size_t>(chosen.trial)]);
        const bool more = static_cast<int>(in_use) < most;
        chosen = more ? reservation(survey, seen, static_cast<int>(in_use), most) : Reservation{};
    }
    if (replaced < 0 && in_use == before) {
        return {};
    }
    reserved_.assign(centres.begin(), centres.begin() + static_cast<std::ptrdiff_t>(in_use));
    viewers.resize(in_use);
    for (std::size_t r = 0; r < in_use; ++r) {
        viewers[r] = ordinary + static_cast<int>(r);
        meter_.move(viewers[r], reserved_[r]);
    }
    meter_.draw(scene, gpu_scene, viewers, kTrialLook);
    ++statistics_.updates;
    if (replaced >= 0) {
        const auto at = std::ranges::find(selected_, ordinary + replaced);
        return {static_cast<int>(at - selected_.begin()), 0};
    }
    selected_.insert(selected_.end(), viewers.begin() + static_cast<std::ptrdiff_t>(before), viewers.end());
    return {-1, static_cast<int>(in_use - before)};
}

}  // namespace lanthorn::gi

#include "tools/lanthorn/replay/pictures/light_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

namespace lanthorn::tools {

namespace {

constexpr double kMargin = 0.01;

// Numbers of seeds after which is looked whether they tell.
constexpr std::size_t kLooks[] = {4, 8, kMostSeeds};

// Student's t, two-sided, of 1 to 15 degrees of freedom, at 5 % over the number of looks.
static_assert(std::size(kLooks) == 3);
constexpr std::array kStudent = {38.188, 7.649, 4.857, 3.961, 3.534, 3.287, 3.128, 3.016,
                                 2.933,  2.870, 2.820, 2.779, 2.746, 2.718, 2.694};
constexpr double kNormal = 2.394;

double average(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

bool within(const Interval& i) {
    return i.low >= -kMargin && i.high <= kMargin;
}

}  // namespace

LightError light_error(const ImageF& indirect, const workbench::ReferencePair& truth) {
    double image = 0, reference = 0, square = 0;
    const std::vector<float>&l = indirect.pixels, &a = truth.a.pixels, &b = truth.b.pixels;
    for (std::size_t i = 0; i < l.size(); ++i) {
        image += l[i];
        reference += 0.5 * (static_cast<double>(a[i]) + b[i]);
        square += (static_cast<double>(l[i]) - a[i]) * (static_cast<double>(l[i]) - b[i]);
    }
    if (reference <= 0) {
        return {0, image > 0 ? std::numeric_limits<double>::infinity() : 1};
    }
    const double count = static_cast<double>(l.size());
    return {std::sqrt(std::max(square / count, 0.0)) / (reference / count), image / reference};
}

Interval interval_of(const std::vector<double>& differences) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (differences.empty()) {
        return {0, -kInfinity, kInfinity};
    }
    const double mean = average(differences);
    const std::size_t n = differences.size();
    if (n == 1) {
        return {mean, -kInfinity, kInfinity};
    }
    double square = 0;
    for (const double d : differences) {
        square += (d - mean) * (d - mean);
    }
    const double t = n - 2 < kStudent.size() ? kStudent[n - 2] : kNormal;
    const double reach = t * std::sqrt(square / static_cast<double>(n * (n - 1)));
    return {mean, mean - reach, mean + reach};
}

LightComparison compare_light(const std::vector<LightError>& before, const std::vector<LightError>& now) {
    LightComparison c;
    std::vector<double> relrmse, off_flux;
    const std::size_t n = std::min(before.size(), now.size());
    for (std::size_t i = 0; i < n; ++i) {
        relrmse.push_back(now[i].relrmse - before[i].relrmse);
        off_flux.push_back(std::abs(now[i].flux - 1) - std::abs(before[i].flux - 1));
        const double share = 1 / static_cast<double>(n);
        c.before += share * before[i].relrmse;
        c.now += share * now[i].relrmse;
        c.flux_before += share * before[i].flux;
        c.flux_now += share * now[i].flux;
    }
    c.seeds = n;
    c.relrmse = interval_of(relrmse);
    c.off_flux = interval_of(off_flux);
    if (c.relrmse.low > kMargin || c.off_flux.low > kMargin) {
        c.verdict = LightVerdict::worse;
    } else if (within(c.relrmse) && within(c.off_flux)) {
        c.verdict = LightVerdict::same;
    } else if ((c.relrmse.high < -kMargin || c.off_flux.high < -kMargin) &&
               std::max(c.relrmse.high, c.off_flux.high) <= kMargin) {
        c.verdict = LightVerdict::better;
    }
    return c;
}

LightComparison compare_until_sure(const std::vector<LightError>& before,
                                   const std::function<LightError()>& next) {
    std::vector<LightError> now;
    LightComparison comparison;
    for (const std::size_t look : kLooks) {
        while (now.size() < std::min(look, before.size())) {
            now.push_back(next());
        }
        comparison = compare_light(before, now);
        if (comparison.verdict != LightVerdict::undecided) {
            break;
        }
    }
    return comparison;
}

const char* verdict_word(LightVerdict verdict) {
    constexpr std::array kWords = {"same", "better", "worse", "undecided"};
    return kWords.at(static_cast<std::size_t>(verdict));
}

std::string light_words(const LightComparison& c) {
    return fmt::format(
        "relRMSE to path {:.3f} -> {:.3f}: {:+.3f} [{:+.3f}, {:+.3f}], flux {:.3f} -> {:.3f}, {} seeds, "
        "margin {:.3f}",
        c.before, c.now, c.relrmse.mean, c.relrmse.low, c.relrmse.high, c.flux_before, c.flux_now, c.seeds,
        kMargin);
}

}  // namespace lanthorn::tools

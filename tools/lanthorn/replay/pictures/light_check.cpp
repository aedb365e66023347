#include "tools/lanthorn/replay/pictures/light_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace lanthorn::tools {

namespace {

constexpr double kMargin = 0.01;

// Student's t, two-sided 95 %, of 1 to 15 degrees of freedom.
constexpr std::array kStudent = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306,
                                 2.262,  2.228, 2.201, 2.179, 2.160, 2.145, 2.131};
constexpr double kNormal = 1.960;

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
    c.relrmse = interval_of(relrmse);
    c.off_flux = interval_of(off_flux);
    if (c.relrmse.low > kMargin || c.off_flux.low > kMargin) {
        c.verdict = LightVerdict::worse;
    } else if (within(c.relrmse) && within(c.off_flux)) {
        c.verdict = LightVerdict::same;
    } else if (c.relrmse.high <= kMargin && c.off_flux.high <= kMargin) {
        c.verdict = LightVerdict::better;
    }
    return c;
}

const char* verdict_word(LightVerdict verdict) {
    constexpr std::array kWords = {"same", "better", "worse", "undecided"};
    return kWords.at(static_cast<std::size_t>(verdict));
}

std::string light_words(const LightComparison& c, std::size_t seeds) {
    return fmt::format(
        "relRMSE to path {:.3f} -> {:.3f}: {:+.3f} [{:+.3f}, {:+.3f}], flux {:.3f} -> {:.3f}, {} seeds, "
        "margin {:.3f}",
        c.before, c.now, c.relrmse.mean, c.relrmse.low, c.relrmse.high, c.flux_before, c.flux_now, seeds,
        kMargin);
}

}  // namespace lanthorn::tools

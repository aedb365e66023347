#include "tests/extremes/truth.h"

#include <cmath>
#include <limits>

#include "lanthorn/reference/path_tracer.h"

namespace lanthorn::extremes {

Truth constant_truth(double lux, ivec2 size) {
    const auto values = 3 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    return {std::vector<float>(values, static_cast<float>(lux)), 0};
}

Truth traced_truth(const FrameScene& scene, ivec2 size, int bounces, int spp) {
    reference::PathSettings settings;
    settings.spp = spp;
    settings.bounces = bounces;
    reference::PathTracer tracer(scene, size, settings, {.indirect = true});
    tracer.render({});
    return {tracer.image(reference::PathAov::indirect), tracer.noise(reference::PathAov::indirect)};
}

Truth brighter(Truth truth, double gain) {
    for (float& lux : truth.lux) lux = static_cast<float>(lux * gain);
    return truth;
}

Difference difference(const std::vector<float>& lux, const Truth& truth) {
    double sum = 0;
    double true_sum = 0;
    double squares = 0;
    double leaked = 0;
    double dark = 0;
    for (std::size_t i = 0; i < lux.size(); ++i) {
        const double value = static_cast<double>(lux[i]);
        const double right = static_cast<double>(truth.lux.at(i));
        sum += value;
        true_sum += right;
        squares += (value - right) * (value - right);
        if (right == 0) {
            leaked += value;
            ++dark;
        }
    }
    const auto n = static_cast<double>(lux.size());
    Difference result;
    result.dark = dark / n;
    if (true_sum == 0) {
        const bool black = squares == 0;
        result.rel_rmse = black ? 0 : std::numeric_limits<double>::infinity();
        result.flux_ratio = black ? 1 : std::numeric_limits<double>::infinity();
        return result;
    }
    const double mean = true_sum / n;
    const double measured = std::sqrt(squares / n) / mean;
    const double lit = 1 - result.dark;
    result.rel_rmse = std::sqrt(std::max(measured * measured - truth.noise * truth.noise, 0.0) * lit);
    result.flux_ratio = sum / true_sum;
    result.leak = dark > 0 ? leaked / dark / mean : 0;
    return result;
}

}  // namespace lanthorn::extremes

#include "tools/workbench/measure/caustic_peak.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace lanthorn::workbench {

namespace {

// Along rows, or along columns; both values and weights.
using Weighted = std::vector<glm::dvec2>;

Weighted blurred(const Weighted& from, ivec2 size, ivec2 along, double deviation) {
    const int reach = static_cast<int>(std::ceil(3 * deviation));
    Weighted to(from.size(), glm::dvec2(0));
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            glm::dvec2& sum = to[static_cast<std::size_t>(y * size.x + x)];
            for (int i = -reach; i <= reach; ++i) {
                const ivec2 q = ivec2(x, y) + i * along;
                if (q.x >= 0 && q.y >= 0 && q.x < size.x && q.y < size.y) {
                    sum += from[static_cast<std::size_t>(q.y * size.x + q.x)] *
                           std::exp(-0.5 * i * i / (deviation * deviation));
                }
            }
        }
    }
    return to;
}

}  // namespace

std::optional<dvec3> brightest_place(std::span<const double> lux, std::span<const std::optional<vec3>> places,
                                     ivec2 size) {
    Weighted values(lux.size(), glm::dvec2(0));
    for (std::size_t p = 0; p < lux.size(); ++p) {
        values[p] = places[p] ? glm::dvec2(lux[p], 1) : glm::dvec2(0);
    }
    const double deviation = size.x / 64.0;
    values = blurred(blurred(values, size, {1, 0}, deviation), size, {0, 1}, deviation);
    std::vector<std::size_t> pixels;
    for (std::size_t p = 0; p < lux.size(); ++p) {
        values[p].x = places[p] ? values[p].x / values[p].y : 0;
        if (values[p].x > 0) {
            pixels.push_back(p);
        }
    }
    std::ranges::sort(pixels, [&](std::size_t a, std::size_t b) {
        return values[a].x != values[b].x ? values[a].x > values[b].x : a < b;
    });
    pixels.resize(std::min(pixels.size(), std::max<std::size_t>(lux.size() / 100, 1)));
    dvec3 sum(0);
    double light = 0;
    for (const std::size_t p : pixels) {
        sum += values[p].x * dvec3(*places[p]);
        light += values[p].x;
    }
    return light > 0 ? std::optional(sum / light) : std::nullopt;
}

}  // namespace lanthorn::workbench

#include "gi_module/techniques/emc/maps/candidates.h"

namespace lanthorn::gi {

std::vector<vec3> candidate_points(const Aabb& bounds, int first, int count, std::uint32_t seed) {
    // g is the real root of x^4 = x + 1; the increments are 1/g, 1/g^2, 1/g^3.
    constexpr double kG = 1.22074408460575947536;
    constexpr dvec3 kStep(1.0 / kG, 1.0 / (kG * kG), 1.0 / (kG * kG * kG));
    const dvec3 start = 0.5 + dvec3(seed) * dvec3(0.754877666, 0.569840296, 0.362069);
    const vec3 size = glm::max(bounds.size(), vec3(1e-3f * bounds.diagonal()));
    const vec3 lower = bounds.centre() - 0.5f * size;
    std::vector<vec3> points;
    points.reserve(static_cast<std::size_t>(count));
    for (int i = first; i < first + count; ++i) {
        points.push_back(lower + size * vec3(glm::fract(start + kStep * static_cast<double>(i + 1))));
    }
    return points;
}

}  // namespace lanthorn::gi

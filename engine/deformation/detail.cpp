#include "engine/deformation/detail.h"

#include <algorithm>
#include <cmath>

namespace lanthorn::deform {
namespace {

// Halvings of the longest edge that someone at `eye` asks for.
double halvings(const Extent& extent, const dvec3& eye, double samples_per_radian) {
    const double distance = glm::length(eye - glm::clamp(eye, extent.lower, extent.upper));
    const double samples = extent.longest_edge * samples_per_radian / distance;
    return std::log2(samples / kSamplesPerEdge);  // infinite in the box
}

}  // namespace

std::uint32_t level_for(const DetailHints& hints, const Extent& extent, std::uint32_t finest,
                        std::uint32_t current) {
    double asked = 0;
    if (hints.pixels_per_radian > 0)
        asked = std::max(asked, halvings(extent, hints.camera, hints.pixels_per_radian));
    if (hints.map_texel_angle > 0) {
        for (const dvec3& map : hints.maps)
            asked = std::max(asked, halvings(extent, map, 1 / hints.map_texel_angle));
    }
    const double now = current;
    const double level = asked < now && asked > now - 1.25 ? now : std::ceil(asked);
    return static_cast<std::uint32_t>(std::clamp(level, 1.0, double(finest)));
}

}  // namespace lanthorn::deform

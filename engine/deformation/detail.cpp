#include "lanthorn/deformation/detail.h"

#include <algorithm>
#include <cmath>

namespace lanthorn::deform {
namespace {

// Halvings of an edge that is so many samples long, until it is short enough.
double halvings(double samples) {
    return std::log2(samples / kSamplesPerEdge);
}

}  // namespace

std::uint32_t level_for(const DetailHints& hints, const Extent& extent, std::uint32_t finest,
                        std::uint32_t current) {
    double asked = std::max(0.0, halvings(extent.longest_edge * hints.samples_per_metre));
    for (const DetailHints::Eye& eye : hints.eyes) {
        const double distance = glm::length(eye.at - glm::clamp(eye.at, extent.lower, extent.upper));
        // Infinite in the box.
        asked = std::max(asked, halvings(extent.longest_edge * eye.samples_per_radian / distance));
    }
    const double now = current;
    const double level = asked < now && asked > now - 1.25 ? now : std::ceil(asked);
    return static_cast<std::uint32_t>(std::clamp(level, 1.0, double(finest)));
}

}  // namespace lanthorn::deform

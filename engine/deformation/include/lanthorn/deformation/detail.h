// How finely a subdivision surface has to be refined for those who look at it.
#pragma once

#include <cstdint>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn {

// Who looks. One refinement of a mesh serves all: the finest that any of them asks for.
struct DetailHints {
    // A camera, or the centre of an environment or shadow map. A map's texel is wider than a pixel, so it
    // asks for less.
    struct Eye {
        dvec3 at{0};                    // world
        double samples_per_radian = 0;  // pixels or texels
    };
    std::vector<Eye> eyes;
    double samples_per_metre = 0;  // of who sees parallel (orthographic cameras, the sun's map): the most
};

namespace deform {

// Pixels or texels that an edge of the refined surface may be long. Normals are the limit surface's at any
// level; what this bounds is the silhouette.
inline constexpr double kSamplesPerEdge = 8;

// What stands where: the world's box around a mesh, and its cage's longest edge there, metres.
struct Extent {
    dvec3 lower{0}, upper{0};
    double longest_edge = 0;
};

// The level, 1 .. finest, at which no edge is longer than kSamplesPerEdge for any viewer; `finest` if any
// viewer is inside the box. One below `current` (0: none) is only taken once a quarter of a level is to
// spare, so that nothing flickers between two. O(eyes).
std::uint32_t level_for(const DetailHints& hints, const Extent& extent, std::uint32_t finest,
                        std::uint32_t current);

}  // namespace deform
}  // namespace lanthorn

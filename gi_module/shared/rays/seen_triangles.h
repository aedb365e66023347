// Which triangles the texels of a cube map show, asked by rays: a map of a scene of millions is drawn of the
// few that it shows.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::gi {

// A face of a cube map (engine/render/cube.glsl) of resolution^2 texels.
struct CubeFace {
    vec3 centre{0};  // render space
    int face = 0;
    int resolution = 0;
};

struct SeenTriangle {
    std::uint32_t instance = 0;   // index into FrameScene::instances
    std::uint32_t primitive = 0;  // of its own triangles
    auto operator<=>(const SeenTriangle&) const = default;
};

// Of each face what a rasteriser needs to draw it as if it had drawn all of the scene: what a ray through the
// middle of each texel meets, or nearly does where an edge passes close by, and the front of a sheet of two.
// Sorted, each once. `stands`, by instance: 1 hides what lies behind, 0 is looked through. What is blended is
// seen, and what lies behind it.
class TriangleSight {
  public:
    virtual ~TriangleSight() = default;
    // Of the frame that was followed last. About 1 us a texel; the same with any number of threads.
    virtual std::vector<std::vector<SeenTriangle>> see(std::span<const CubeFace> faces,
                                                       std::span<const std::uint8_t> stands) = 0;
    // Whether rays meet the instance's own triangles as they stand, not coarser ones, and not deformed ones.
    virtual bool whole(std::uint32_t instance) const = 0;
};

}  // namespace lanthorn::gi

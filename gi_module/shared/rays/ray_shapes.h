// The coarser shapes that rays of indirect light meet in place of what moves or deforms: what Embree has to
// be told of it each frame is a tenth. The levels are those that maps draw (engine/render/coarse_shapes.h).
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <tuple>
#include <utility>

#include "gi_module/reference/reduced_shape.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::render {
struct CoarseLevel;
}  // namespace lanthorn::render

namespace lanthorn::gi {

// A level of a shape with the vertices that it uses alone. O(n log n).
std::shared_ptr<const reference::ReducedShape> reduced_shape(const render::CoarseLevel& level);

class RayShapes {
  public:
    // How far a shape may lie off, a share of the scene's diagonal.
    static constexpr float kErrorOfScene = 0.0004f;
    // The same of its own box's, for the sake of what is small in a large scene.
    static constexpr float kError = 0.03f;

    // Those of a frame: the coarsest within both, of what deforms and of what has been seen to move. What
    // stands still keeps its own triangles. The first time that a shape is met: about 2 us a triangle.
    reference::ReducedShapes follow(const FrameScene& scene);

  private:
    // RefinedTopology::serial, 0: the mesh's own triangles, of the slot and version that follow.
    using Topology = std::tuple<std::uint64_t, std::uint32_t, std::uint64_t>;
    struct Levels {
        std::vector<std::shared_ptr<const reference::ReducedShape>> finer_first;
        bool used = false;
    };
    const Levels& levels_of(const FrameScene& scene, const Instance& instance);

    std::map<Topology, Levels> levels_;
    std::set<std::pair<std::uint32_t, std::uint32_t>> moved_;  // rigid ones: id and mesh
};

}  // namespace lanthorn::gi

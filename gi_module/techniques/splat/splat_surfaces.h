// All surfaces of a frame's scene: which triangles are one, and where they lie.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "gi_module/reference/tile_workers.h"
#include "gi_module/techniques/splat/surface_parts.h"
#include "gi_module/techniques/splat/surface_tree.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

// A surface has two sides, which are lit apart: 2 * surface of its front, and 1 more of its back.
using SurfaceSide = std::uint32_t;

class SplatSurfaces {
  public:
    // Becomes this frame's scene. What neither moved nor changed its shape is kept. O(instances + triangles
    // that moved, times their logarithm).
    void follow(const FrameScene& scene, reference::TileWorkers& workers);

    std::size_t count() const { return count_; }
    SurfaceSide side(std::uint32_t instance, std::uint32_t primitive, bool front) const {
        const Placed& p = placed_[instance];
        return 2 * (p.first + p.parts->of_triangle[primitive]) + (front ? 0 : 1);
    }
    const SurfaceTree& tree(SurfaceSide side) const {
        const Place& place = places_[side / 2];
        return placed_[place.instance].trees[place.part];
    }

  private:
    // The mesh's slot and version, RefinedTopology::serial.
    using Topology = std::tuple<std::uint32_t, std::uint64_t, std::uint64_t>;
    struct Placed {
        std::uint32_t id = 0;
        Topology topology;
        std::uint64_t version = 0;
        mat4 transform{1};
        std::shared_ptr<const SurfaceParts> parts;
        std::uint32_t first = 0;  // surface
        std::vector<SurfaceTree> trees;
    };
    struct Place {
        std::uint32_t instance, part;
    };
    std::shared_ptr<const SurfaceParts> parts_of(const FrameScene& scene, const Instance& instance);
    static void place(const FrameScene& scene, const Instance& instance, Placed& placed);

    std::map<Topology, std::weak_ptr<const SurfaceParts>> parts_;
    std::vector<Placed> placed_;  // by instance
    std::vector<Place> places_;   // by surface
    std::size_t count_ = 0;
};

}  // namespace lanthorn::gi

// The scene as Embree has it, kept from frame to frame: refitted where things move.
#pragma once

#include <optional>

#include "engine/scene/kept_emissive_pieces.h"
#include "gi_module/reference/material_table.h"
#include "gi_module/reference/trace_scene.h"
#include "gi_module/shared/rays/exact_rays.h"
#include "gi_module/shared/rays/ray_shapes.h"

namespace lanthorn::gi {

class FollowedScene {
  public:
    // Forgets it: the next follow() builds it whole.
    void clear();
    // Becomes this frame's scene: refits what moved, builds what came, takes out what went. `scene` must stay
    // as it is until the last use of the frame. `detail`: of what moves or deforms. Whether surfaces or
    // materials differ from before. O(what changed); O(triangles log triangles) when built.
    bool follow(const FrameScene& scene, RayDetail detail = RayDetail::full);
    // The same with these shapes, by instance, in the place of their own.
    bool follow(const FrameScene& scene, const reference::ReducedShapes& reduced);

    reference::TraceScene& scene() { return *scene_; }
    const reference::TraceScene& scene() const { return *scene_; }
    const reference::MaterialTable& materials() const { return *materials_; }
    KeptEmissivePieces& pieces() { return pieces_; }  // of what glows
    std::uint64_t builds() const { return builds_; }  // of the whole scene so far

  private:
    std::optional<reference::MaterialTable> materials_;
    std::optional<reference::TraceScene> scene_;
    KeptEmissivePieces pieces_;
    RayShapes shapes_;
    std::uint64_t builds_ = 0;
};

}  // namespace lanthorn::gi

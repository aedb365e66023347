// What `lanthorn measure` measures: a scene with settings, and how a photon meets its surfaces by exact rays.
#pragma once

#include <cstdint>
#include <optional>

#include "gi_module/reference/material_table.h"
#include "gi_module/reference/trace_scene.h"

namespace lanthorn::workbench {

// Where a photon's flight ends.
struct PhotonArrival {
    reference::SurfaceHit hit;
    bool receives = false;  // a surface that photons are stored on: no back of a single-sided one, not unlit
};

// A frame's surfaces for exact rays (Embree). `frame` must outlive it. O(triangles log triangles) to build.
class ExactSurfaces {
  public:
    explicit ExactSurfaces(const FrameScene& frame) : materials(*frame.assets), scene(frame, materials) {}

    // The first surface a photon meets more than 1e-4 of the scene's diagonal away from `origin`: nearer, an
    // origin that lies a texel's error behind its own surface would meet that. See-through (blended) surfaces
    // take no part, as in `emc`.
    std::optional<PhotonArrival> arrival(const vec3& origin, const vec3& direction) const;
    // Whether photons are stored on that side of an instance.
    bool receives(std::uint32_t instance, bool front) const;

    reference::MaterialTable materials;
    reference::TraceScene scene;
};

}  // namespace lanthorn::workbench

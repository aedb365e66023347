// Cube maps that pay for change alone: each keeps what stands still as a layer of its own; what moves is
// drawn over it, in the faces that see it.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/scene/frame_scene.h"
#include "engine/scene/scene_motion.h"
#include "gi_module/emc/map_renderer.h"

namespace lanthorn::gi {

class LayeredMaps {
  public:
    LayeredMaps(MapUse use, int slots, int resolution);

    // The slot's map has another centre (render space): it is drawn anew at the next update.
    void place(int slot, const vec3& centre);

    // Brings the maps of `slots` up to date with the frame, whatever happened since the last call. Others are
    // drawn anew when they are asked for again.
    //
    // Cost: faces that moving instances touch or touched, a copy each, and the movers' triangles; for
    // instances that begin to move, all that stands still in the faces that saw them, once. What moves:
    // SceneMotion.
    void update(const FrameScene& scene, const render::GpuScene& gpu_scene, const std::vector<int>& slots);

    const CubeMaps& maps() const { return maps_; }
    std::size_t bytes() const { return maps_.bytes() + still_.bytes(); }
    // Faces that the last update drew or copied into.
    int faces_touched() const { return faces_touched_; }

  private:
    struct Face {
        bool still_valid = false;  // `still_` shows all that stands still
        bool has_movers = false;   // `maps_` shows more than `still_`
    };

    void forget_other_slots(const std::vector<int>& slots);

    CubeMaps maps_;
    CubeMaps still_;
    MapRenderer renderer_;
    std::vector<vec3> centres_;  // by slot
    std::vector<Face> faces_;    // by layer
    SceneMotion motion_;
    int faces_touched_ = 0;
};

}  // namespace lanthorn::gi

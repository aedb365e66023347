// Cube maps that pay for change alone: each keeps what stands still as a layer of its own; what moves is
// drawn over it, in the faces that see it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "gi_module/shared/rays/seen_triangles.h"
#include "gi_module/techniques/emc/maps/map_renderer.h"
#include "lanthorn/core/frustum.h"
#include "lanthorn/scene/frame_scene.h"
#include "lanthorn/scene/scene_motion.h"

namespace lanthorn::gi {

class LayeredMaps {
  public:
    LayeredMaps(MapUse use, int slots, int resolution);

    // The slot's map has another centre (render space): it is drawn anew at the next update.
    void place(int slot, const vec3& centre);

    // Brings the maps of `slots` up to date with the frame, whatever happened since the last call with the
    // same `look`. Other slots of that look are drawn anew when they are asked for again. Slots that are
    // brought up to date in different frames are of different looks (0, 1, ..), each with its own memory of
    // the scene.
    //
    // Cost: faces that moving instances touch or touched, a copy each, and the movers' triangles; for
    // instances that begin to move, or for tracing are painted, all that stands still in the faces that see
    // them, once. What moves: SceneMotion. Where that would be many more triangles than the faces have
    // texels, `sight` (may be null), which has followed the frame, tells which of them are seen, and those
    // alone are drawn.
    void update(const FrameScene& scene, const render::GpuScene& gpu_scene, const std::vector<int>& slots,
                int look = 0, TriangleSight* sight = nullptr);

    const vec3& centre(int slot) const { return centres_[static_cast<std::size_t>(slot)]; }

    // What stands still in the slot's map, as of the last update; nothing if it has not been drawn.
    std::optional<CubeMaps> still(int slot) const;
    // Right after place(): what still() gave for this centre serves instead of drawing, and nothing that it
    // shows has moved since.
    void restore(int slot, const CubeMaps& still);

    const CubeMaps& maps() const { return maps_; }
    std::size_t bytes() const { return maps_.bytes() + still_.bytes(); }
    // Faces that the last update drew or copied into.
    int faces_touched() const { return faces_touched_; }

  private:
    struct Face {
        bool still_valid = false;  // `still_` shows all that stands still
        bool has_movers = false;   // `maps_` shows more than `still_`
    };

    struct Work {
        int layer;
        vec3 centre;
        Frustum frustum;
        bool redraw;  // what stands still
    };
    // What of a layer's faces has to be drawn.
    struct Drawing {
        std::uint32_t instance, level;
        const Work* work;
        bool moving;
    };
    std::vector<Work> work_on(const std::vector<int>& slots, const SceneMotion& motion);
    std::vector<Drawing> drawings(const render::GpuScene& gpu_scene, const SceneMotion& motion,
                                  const std::vector<Work>& work) const;
    // Takes out of `drawings` what rays have seen for, and lists what they saw of it.
    LayerList seen_alone(const FrameScene& scene, const render::GpuScene& gpu_scene, TriangleSight& sight,
                         const SceneMotion& motion, const std::vector<Work>& work,
                         std::vector<Drawing>& drawings) const;

    // Those that are not of the look, and those of the look that are not asked for.
    void forget_strangers(const std::vector<int>& slots, int look);
    void forget(int slot) { std::fill_n(faces_.begin() + 6 * slot, 6, Face{}); }

    MapUse use_;
    CubeMaps maps_;
    CubeMaps still_;
    MapRenderer renderer_;
    std::vector<vec3> centres_;         // by slot
    std::vector<Face> faces_;           // by layer
    std::vector<int> look_of_;          // by slot
    std::vector<SceneMotion> motions_;  // by look
    int faces_touched_ = 0;
};

}  // namespace lanthorn::gi

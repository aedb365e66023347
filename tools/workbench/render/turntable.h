// A scene from all sides: the camera goes once round it.
#pragma once

#include <functional>

#include "lanthorn/core/image.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/scene/frame_scene.h"
#include "lanthorn/scene/scene_data.h"
#include "lanthorn/workbench/load_scene.h"

namespace lanthorn::workbench {

struct TurntableJob {
    ivec2 size{512, 512};  // pixels
    SceneView view;        // `time` is the moment that all pictures show; default: 1/60 s
    int pictures = 48;     // of the whole turn, at least 1
    int warmup = 0;        // frames that are drawn before each picture's own, from the same place
};

// `view` turned by so many radians about the upright through `pivot` (render space), counter-clockwise as
// seen from above.
CameraView turned(const CameraView& view, const vec3& pivot, double radians);

// What a camera that sees everything frames: all that is there, or, where that stands on floors that reach
// far beyond it, what stands there. Render space. O(instances).
Aabb framed_box(const FrameScene& scene);

// `start`, as much further off that `box` stays in all of so many pictures, in which the camera goes round
// the box's middle. `start` itself where it does not see all of the box, or nothing near does. `aspect`:
// width / height; `diagonal`: the scene's. O(pictures).
CameraView stepped_back(const CameraView& start, const Aabb& box, int pictures, float aspect, float diagonal);

// Pictures of a scene that stands still while the camera goes round the middle of framed_box(),
// stepped_back(), display-encoded as render::Aov::final has them. If it does not step back, the first is what
// render_scene() shows of the same scene, size and moment by one frame after as many of warm-up; light stays
// where it is, and exposure what it is. `done` is given each picture, in order. Throws what render_scene()
// does, Stopped after the frame in which a StopSignal notes a signal, and what `done` throws.
void render_turntable(SceneData scene, const Settings& settings, const TurntableJob& job,
                      const std::function<void(const ImageF&)>& done);

}  // namespace lanthorn::workbench

// How much indirect light changes from frame to frame while something moves slowly, against what it should.
#pragma once

#include <functional>
#include <vector>

#include "lanthorn/core/settings.h"
#include "lanthorn/workbench/load_scene.h"

namespace lanthorn::workbench {

// What moves, by FlickerJob::step a frame.
enum class FlickerMotion {
    light,  // all punctual lights (without any, all emissive meshes) along +X; directional ones turn
    pan,    // the camera turns about its own upright
};

// What is rendered to measure flicker.
struct FlickerJob {
    ivec2 size{256, 256};  // pixels
    SceneView view;        // `time`: of the animation, which stands still; default: 0
    FlickerMotion motion = FlickerMotion::light;
    int frames = 8;       // changes between frames that are measured
    int warmup = 4;       // frames of the same motion before
    double step = 0.002;  // a frame: share of the scene's diagonal, or radians
    int spp = 64;         // samples a pixel of the reference, both halves together
};

// How much a technique's pictures change from frame to frame, beside the reference's.
struct FlickerFigures {
    double change = 0;  // RMS over frames, pixels and channels of a frame's irradiance less that before, lux
    double reference_change = 0;   // the same of the reference, its noise taken out; NaN: lost in its noise
    double reference_error = 0;    // standard error of reference_change
    double reference_mean = 0;     // lux
    double ratio = 0;              // change over reference_change; NaN as that
    std::vector<double> by_frame;  // RMS change of each frame, lux
};

// The reference's change is taken from two independent path tracings a and b of each frame:
// E[(a' - a)(b' - b)] is the square of the true change, whatever their noise. Throws InputError as
// render_scene() does and if there is nothing to move; Error(ExitCode::no_gl) without OpenGL 4.5. `done` is
// told how many of all frames are done. Most of the time goes to the reference.
FlickerFigures measure_flicker(SceneData scene, const Settings& settings, const FlickerJob& job,
                               const std::function<void(std::uint64_t)>& done);

}  // namespace lanthorn::workbench

// What frames of a scene cost while something moves, on the machine at hand: by the clock in a run as a
// window has it, and by pass.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "lanthorn/core/settings.h"
#include "lanthorn/scene/scene_data.h"
#include "lanthorn/workbench/frame_meter.h"
#include "lanthorn/workbench/motions.h"
#include "tools/lanthorn/common/workbench.h"

namespace lanthorn::tools {

struct FramesJob {
    ivec2 size{1920, 1080};
    int frames = 60;  // measured
    int warmup = 30;  // before, in motion too
};

struct FrameTimes {
    Motion motion = Motion::rest;
    std::string lacking;         // why the scene has no such motion; empty: it has
    double median = 0, p95 = 0;  // milliseconds from frame to frame, at most kInFlight on their way
    double gpu = 0;              // milliseconds of all passes together, median
    double processor = 0;  // milliseconds of processor time of the frames that are not timed by pass, mean
    std::map<std::string, double> passes;  // milliseconds a frame of each, without those within it
    std::uint64_t nan_count = 0;
    std::string renderer;

    double fps() const { return 1000 / median; }
};

// Frames that may be on their way to the GPU, as with a window of two buffers.
inline constexpr int kInFlight = 2;

// Two runs of the same frames: one that waits for nothing but its own second to last frame, and one whose
// passes are timed. On a software rasteriser each timed pass waits for its end. Throws Error(ExitCode::no_gl)
// without OpenGL 4.5.
FrameTimes measure_frames(const SceneData& scene, const SceneChoice& choice, Motion motion,
                          const Settings& settings, const FramesJob& job);

}  // namespace lanthorn::tools

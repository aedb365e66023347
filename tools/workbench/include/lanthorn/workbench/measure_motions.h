// How good indirect light is while lamp, camera and things move, for several settings side by side: error,
// flicker and time of each motion (motions.h), all by frames of an App.
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "lanthorn/core/settings.h"
#include "lanthorn/workbench/frame_meter.h"
#include "lanthorn/workbench/image_error.h"
#include "lanthorn/workbench/load_scene.h"
#include "lanthorn/workbench/motions.h"
#include "lanthorn/workbench/reference_pairs.h"

namespace lanthorn::workbench {

// Which motions are measured, and how large and long.
struct MotionJob {
    ivec2 size{512, 512};         // pixels
    int frames = 30;              // of each motion; the last one is compared. At least kChanges + 1
    std::vector<Motion> motions;  // in this order; not box_rest
    int reference_bounces = 0;    // of the references; 0: as many as the settings have
};
inline constexpr int kChanges = 3;  // changes from frame to frame that flicker is taken from: the last ones

// Settings to be measured.
struct MotionCase {
    std::string name;
    Settings settings;
};

// A scene that motions are measured in.
struct MotionScene {
    std::string name;  // of the files that keep its references
    SceneData data;
    SceneView view;
};

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

// Of one motion by one case. What the motion does not tell is kUnknown.
struct MotionFigures {
    Motion motion = Motion::rest;
    std::string lacking;          // why there are no figures; empty: there are
    double reach = 0;             // metres that what moves came from
    ImageError error;             // of the last frame
    ImageError noise;             // of its reference
    double over_rest = kUnknown;  // box: local error within 40 cm of the box over the same while it stands;
                                  // cut: relRMSE over that of `lamp`, whose last frame shows the same
    double flicker = kUnknown;    // lamp, dim, figure: RMS change over the reference's own; unknown: lost in
                                  // its noise
    // RMS change from frame to frame at the points that stay in sight, over the reference's mean; not of
    // rest, cut and box. And the reference's own, which in motions of the camera is what looking between
    // pixels makes; unknown: lost in its noise, and no more than `reference_change_below` by three
    // standard errors.
    double change = kUnknown, reference_change = kUnknown, reference_change_below = kUnknown;
    double worst_rise = kUnknown;  // rest: the largest error of a frame over that of the frame before
    std::vector<double> by_frame;  // rest: relRMSE of each frame
    double seconds = kUnknown;     // rest: of all its frames, by the clock
    std::uint64_t unlit = 0;       // pixels of the last frame without any light
    // Milliseconds, medians of the second half of the frames; cut: of the last frame.
    double gi = 0, gi_cpu = 0, direct = 0, direct_cpu = 0, over_direct = 0, over_direct_cpu = 0;
    std::map<std::string, FrameCost::Pass> gi_passes;  // without those within them
    bool software = true;                              // the rasteriser: the processor draws
    double gpu_mb = 0;  // of the renderer's buffers and textures, after the last frame
    std::uint64_t nan_count = 0;
};

// One entry a motion of the job for each case: result[case][motion]. Throws InputError as load_scene() and
// for a technique that renders no frames; Error(ExitCode::no_gl) without OpenGL 4.5. `done` is told how many
// motions of how many cases are done: size of the result at the end.
std::vector<std::vector<MotionFigures>> measure_motions(const MotionScene& scene,
                                                        const std::vector<MotionCase>& cases,
                                                        const MotionJob& job, ReferencePairs& references,
                                                        const std::function<void()>& done);

}  // namespace lanthorn::workbench

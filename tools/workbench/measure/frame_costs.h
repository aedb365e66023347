// Where the milliseconds of a scene's frames go, pass by pass, and what its plan leaves out of them.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "lanthorn/workbench/measure_motions.h"
#include "tools/workbench/measure/scene_memory.h"

namespace lanthorn::workbench {

struct FrameCostsJob {
    ivec2 size{512, 512};  // pixels
    int warmup = 20;       // frames before, in motion too: more than a picture needs to come to rest
    int frames = 12;       // measured
};

// Milliseconds a frame of a pass, without those within it. What not every frame does counts as often as it is
// done. On a software rasteriser they are processor time of all threads, which other programs hardly alter;
// on a GPU those of its clock.
struct PassCost {
    double ms = 0, mean = 0;  // median and mean
    double clock = 0;         // by the clock, median
    bool gi = false;          // of the indirect light
};

// A line of the plans of all measured frames.
struct PlanLine {
    std::string pass;
    int ran = 0;       // frames in which it was done
    std::string size;  // in the last of them
    std::string why;   // in the last frame that left it out, if any did; else in the last one
};

struct FrameCosts {
    Motion motion = Motion::rest;
    std::string lacking;  // why the scene has no such motion; empty: there are figures
    int frames = 0;       // measured
    std::map<std::string, PassCost> passes;
    // The whole frame until the GPU has done its work, median and mean: processor time on a software
    // rasteriser, else by the clock; and by the clock, median.
    double whole = 0, whole_mean = 0, whole_clock = 0;
    double outside = 0;  // of a frame, outside of all passes: the median of whole less passes
    std::vector<PlanLine> plan;
    SceneMemory memory;  // after the last frame
    bool software = true;
    std::string renderer;
    std::uint64_t nan_count = 0;

    // Sum of the passes' medians, and of their means.
    double passes_ms() const;
    double passes_mean() const;
    // What is left of the whole beside passes_ms(): `outside`, and what medians do not add up by.
    double rest() const { return whole - passes_ms(); }
};

// Throws Error(ExitCode::no_gl) without OpenGL 4.5, and what MovingScene does.
FrameCosts measure_frame_costs(const MotionScene& scene, Motion motion, const Settings& settings,
                               const FrameCostsJob& job);

}  // namespace lanthorn::workbench

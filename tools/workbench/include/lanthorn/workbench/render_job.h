// Rendering a scene's frames without a display: what `lanthorn render` does between reading and writing
// files.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lanthorn/core/error.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/ecs/schedule.h"
#include "lanthorn/gi/statistics.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/gpu/pass_timer.h"
#include "lanthorn/render/frame.h"
#include "lanthorn/scene/scene_data.h"
#include "lanthorn/workbench/load_scene.h"

namespace lanthorn::workbench {

// A time or an error that frames are to keep, and how it is measured.
struct BudgetWish {
    double ms = 0;           // of a frame; 0: any time
    double error = 0;        // indirect relRMSE, as it is estimated; 0: any. Time comes first
    bool processor = false;  // `ms` is of processor time of all threads, which other programs hardly alter
    // By frame, warm-up included: what was decided in a run before, instead of by the clock.
    std::vector<std::pair<std::int64_t, std::size_t>> played;

    // Whether anything is wished for.
    bool any() const { return ms > 0 || error > 0 || !played.empty(); }
};

// What a budget decided.
struct BudgetStep {
    std::int64_t frame = 0;        // the first one that is drawn so, warm-up included
    std::size_t from = 0, to = 0;  // rungs of the ladder
    std::string name;              // of the last one
    double scale = 1;              // of the picture's width and height
    std::string why;               // one line
};
// What a budget has made of a job (docs/budgets.md).
struct BudgetOutcome {
    std::vector<BudgetStep> steps;
    std::vector<std::string> ladder;  // the rungs' names
    std::string verdict;              // one line
    bool holds = true;                // what was wished for; true where frames are too few to tell
};

struct RenderJob {
    ivec2 size{512, 512};  // pixels
    SceneView view;        // `time` is what the last frame shows; default: frames / 60
    int frames = 1;        // measured; the last one is the picture
    int warmup = 0;        // rendered before, not measured
    std::vector<render::Aov> aovs{render::Aov::final};
    std::vector<std::string> debug_views;  // of the technique (gi/technique.h), beside them
    bool timing = false;  // measure passes: costs a wait for the GPU a pass on a software rasteriser
    BudgetWish budget;    // wants `timing`; the picture loses pixels where AOVs are `final` alone
};

// What a frame took, and each of its passes and systems.
struct FrameTiming {
    double start_ms = 0;  // since the first measured frame's start
    double ms = 0;        // whole frame, all GPU work done
    std::vector<gpu::PassTimer::Span> passes;
    std::vector<ecs::Schedule::Report> systems;  // of the frame schedule
    double cpu_ms = 0;                           // processor time of all threads
};

// What rendering a job has given.
struct RenderOutcome {
    std::string technique;
    // One an AOV, in the job's order, then one a debug view: with what is known of it as metadata.
    std::vector<ImageF> images;
    std::vector<FrameTiming> frames;
    gi::GiStatistics gi;
    BudgetOutcome budget;  // where there was one
    std::uint64_t nan_count = 0;
    std::size_t gpu_bytes = 0;
    std::uint64_t triangles = 0;  // of the last frame, over all instances; 0: not known
    gpu::GlInfo gl;
    bool interrupted = false;                 // by a signal: less was done than was asked for
    std::optional<Error> checkpoint_failure;  // why the last one could not be written
};

// Seconds of the animation that the last frame shows, and `frames_before` frames before it (1/60 s each, not
// before the animation's start).
double shown_time(const RenderJob& job, int frames_before = 0);

// Throws InputError if the current OpenGL has no room for a picture's largest buffer, four floats a pixel.
void check_picture_fits(ivec2 size);

// Throws what ShownScene() does before any GL, and InputError if a debug view has nothing to show;
// Error(ExitCode::no_gl) without OpenGL 4.5. `frame_done` is told how many frames are done, warm-up included.
// A signal that a StopSignal notes ends it after the frame, but not before one is measured: the pictures are
// then of an earlier moment, or less settled.
RenderOutcome render_scene(SceneData scene, const Settings& settings, const RenderJob& job,
                           const std::function<void(int)>& frame_done);

}  // namespace lanthorn::workbench

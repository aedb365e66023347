// Rendering a scene's frames without a display: what `lanthorn render` does between reading and writing
// files.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/settings.h"
#include "engine/ecs/world.h"
#include "engine/gpu/context.h"
#include "engine/gpu/pass_timer.h"
#include "engine/render/frame.h"
#include "engine/scene/scene_data.h"
#include "gi_module/statistics.h"

namespace lanthorn::tools {

struct RenderJob {
    ivec2 size{512, 512};  // pixels
    std::string camera;  // a camera node's name or a camera's number; empty: the first; "auto": one that sees
                         // everything
    int frames = 1;      // measured; the last one is the picture
    int warmup = 0;      // rendered before, not measured
    std::string animation;       // as ScenePlayer takes it
    std::optional<double> time;  // seconds of it that the last frame shows; default: frames / 60
    std::vector<render::Aov> aovs{render::Aov::final};
    bool timing = false;  // measure passes: costs a wait for the GPU a pass on a software rasteriser
};

struct FrameTiming {
    double start_ms = 0;  // since the first measured frame's start
    double ms = 0;        // whole frame, all GPU work done
    std::vector<gpu::PassTimer::Span> passes;
};

struct RenderOutcome {
    std::string technique;
    std::vector<render::FloatImage> images;                    // one an AOV, in the job's order
    std::vector<std::map<std::string, std::string>> metadata;  // one an image; empty: nothing to say
    std::vector<FrameTiming> frames;
    gi::GiStatistics gi;
    std::uint64_t nan_count = 0;
    std::size_t gpu_bytes = 0;
    std::uint64_t triangles = 0;  // of the last frame, over all instances; 0: not known
    gpu::GlInfo gl;
    bool interrupted = false;                 // from the keyboard: less was done than was asked for
    std::optional<Error> checkpoint_failure;  // why the last one could not be written
};

// Seconds of the animation that the last frame shows, and `frames_before` frames before it (1/60 s each, not
// before the animation's start).
double shown_time(const RenderJob& job, int frames_before = 0);

// The scene's entities in `world`, as they are before anything plays, its assets taken; the camera's, or the
// null entity for "auto". Throws
// InputError naming `scene.source` if there is no geometry, no light, or no camera of that name.
ecs::Entity spawn_scene(ecs::World& world, SceneData scene, const std::string& camera);

// Throws what spawn_scene() does before any GL; Error(ExitCode::no_gl) without OpenGL 4.5. `frame_done` is
// told how many frames are done, warm-up included.
RenderOutcome render_scene(SceneData scene, const Settings& settings, const RenderJob& job,
                           const std::function<void(int)>& frame_done);

}  // namespace lanthorn::tools

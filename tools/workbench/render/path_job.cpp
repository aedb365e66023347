#include "lanthorn/workbench/path_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>

#include "engine/gpu/memory.h"
#include "engine/render/radiance_picture.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/stop_signal.h"
#include "lanthorn/reference/path_tracer.h"
#include "tools/workbench/scene/stopping.h"

namespace lanthorn::workbench {

namespace {

using reference::PathAov;
using reference::PathTracer;
using render::Aov;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kBetweenCheckpoints(30);

PathAov path_aov(Aov aov) {
    switch (aov) {
        case Aov::indirect:
            return PathAov::indirect;
        case Aov::direct:
            return PathAov::direct;
        case Aov::albedo:
            return PathAov::albedo;
        case Aov::normal:
            return PathAov::normal;
        case Aov::depth:
            return PathAov::depth;
        case Aov::final:
        case Aov::radiance:
            break;
    }
    return PathAov::radiance;
}

// Through the rasteriser's own exposure and tone map.
std::vector<float> displayed(const std::vector<float>& radiance, const std::vector<float>& coverage,
                             ivec2 size, const render::RenderSettings& settings, RenderOutcome& outcome) {
    const auto context = gpu::create_headless_context();
    outcome.gl = context->info();
    check_picture_fits(size);
    render::RadiancePicture picture(radiance, coverage, size);
    std::vector<float> pixels = picture.display(settings).pixels;
    outcome.gpu_bytes = gpu::allocated_bytes();
    return pixels;
}

void save(const PathTracer& tracer, const std::string& checkpoint, RenderOutcome& outcome) {
    try {
        tracer.save(checkpoint);
        outcome.checkpoint_failure.reset();
    } catch (const InputError& error) {
        outcome.checkpoint_failure = error;
    }
}

std::vector<FrameTiming> timing_of(double seconds) {
    return {{0, 1e3 * seconds, {{"path", 0, 1e3 * seconds}}, {}}};
}

void trace(PathTracer& tracer, const std::string& checkpoint, const std::function<void(double)>& progressed,
           RenderOutcome& outcome) {
    Clock::time_point saved = Clock::now();
    reference::PathControl control;
    control.progress = [&](const reference::PathProgress& progress) {
        progressed(progress.share);
        if (!checkpoint.empty() && Clock::now() - saved > kBetweenCheckpoints) {
            const bool failed_before = outcome.checkpoint_failure.has_value();
            save(tracer, checkpoint, outcome);
            if (outcome.checkpoint_failure && !failed_before) {
                fmt::print(stderr, "lanthorn: warning: {}; going on without\n",
                           outcome.checkpoint_failure->what());
            }
            saved = Clock::now();
        }
        return !StopSignal::asked();
    };
    const reference::PathProgress progress = tracer.render(control);
    outcome.interrupted = StopSignal::asked();
    outcome.frames = timing_of(progress.seconds);
}

// The tracer of a job's picture, in the moment that it shows.
class JobTracer {
  public:
    JobTracer(SceneData scene, const Settings& settings, const RenderJob& job)
        : shown_(std::move(scene), job.view) {
        shown_.show_at(shown_time(job));
        const auto wants = [&](PathAov aov) {
            return std::ranges::any_of(job.aovs, [&](Aov a) { return path_aov(a) == aov; });
        };
        tracer_.emplace(
            shown_.frame(), job.size, reference::path_settings(settings),
            reference::PathParts{wants(PathAov::indirect), wants(PathAov::direct), wants(PathAov::radiance)});
    }
    PathTracer& tracer() { return *tracer_; }

  private:
    ShownScene shown_;
    std::optional<PathTracer> tracer_;
};

// The pictures of what was traced, into the outcome.
void take_pictures(const PathTracer& tracer, const Settings& settings, const RenderJob& job,
                   RenderOutcome& outcome) {
    outcome.technique = "path";
    outcome.gi.plan.bounces = settings.get<int>("gi.bounces");
    for (const Aov aov : job.aovs) {
        const PathAov from = path_aov(aov);
        std::vector<float> pixels = tracer.image(from);
        if (aov == Aov::final) {
            pixels =
                displayed(pixels, tracer.coverage(), job.size, render::render_settings(settings), outcome);
        }
        ImageF& image = outcome.images.emplace_back(
            ImageF{job.size.x, job.size.y, from == PathAov::depth ? 1 : 3, std::move(pixels), {}});
        for (const auto& [key, value] : tracer.description(from)) {
            image.metadata[key] = value;
        }
        image.metadata["seconds"] = fmt::format("{:.3f}", outcome.frames.front().ms * 1e-3);
    }
    outcome.nan_count = tracer.nan_count();
}

}  // namespace

RenderOutcome path_trace_scene(SceneData scene, const Settings& settings, const RenderJob& job,
                               const std::string& checkpoint, const std::function<void(double)>& progressed) {
    JobTracer traced(std::move(scene), settings, job);
    PathTracer& tracer = traced.tracer();
    if (!checkpoint.empty() && std::filesystem::exists(checkpoint)) {
        tracer.resume(checkpoint);
    }
    RenderOutcome outcome;
    trace(tracer, checkpoint, progressed, outcome);
    if (tracer.spp() == 0) {
        throw Stopped("path", "before the first sample, nothing is written");
    }
    if (!checkpoint.empty()) {
        save(tracer, checkpoint, outcome);
    }
    take_pictures(tracer, settings, job, outcome);
    return outcome;
}

RenderOutcome path_trace_scene(SceneData scene, const Settings& settings, const RenderJob& job,
                               const std::function<void(PathTracer&)>& trace) {
    JobTracer traced(std::move(scene), settings, job);
    const Clock::time_point start = Clock::now();
    trace(traced.tracer());
    RenderOutcome outcome;
    outcome.frames = timing_of(std::chrono::duration<double>(Clock::now() - start).count());
    take_pictures(traced.tracer(), settings, job, outcome);
    return outcome;
}

void path_trace_piece(SceneData scene, const Settings& settings, const RenderJob& job,
                      const reference::PathPiece& piece, const std::string& file,
                      const std::function<void(double)>& progressed) {
    JobTracer traced(std::move(scene), settings, job);
    const auto go_on = [&](const reference::PathProgress& progress) {
        progressed(progress.share);
        return !StopSignal::asked();
    };
    if (!traced.tracer().trace_piece(piece, file, {go_on})) {
        throw Stopped("path", "no piece is written");
    }
}

}  // namespace lanthorn::workbench

#include "lanthorn/workbench/render_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ctime>

#include "engine/gpu/memory.h"
#include "gi_module/reference/scene_hash.h"
#include "lanthorn/core/stop_signal.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "tools/workbench/render/budget_run.h"

namespace lanthorn::workbench {

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::duration d) {
    return std::chrono::duration<double, std::milli>(d).count();
}

// Rows from the top.
ImageF read_picture(const gpu::Texture& texture) {
    const ivec2 size(texture.size());
    const std::vector<float> upwards = texture.read_floats(3);
    ImageF image{size.x, size.y, 3, {}, {}};
    image.pixels.reserve(upwards.size());
    const auto row = 3 * static_cast<std::ptrdiff_t>(size.x);
    for (std::ptrdiff_t y = size.y; y-- > 0;) {
        image.pixels.insert(image.pixels.end(), upwards.begin() + y * row, upwards.begin() + (y + 1) * row);
    }
    return image;
}

ImageF debug_view(App& app, const std::string& technique, const std::string& name) {
    const Renderer& renderer = app.world().resource<Renderer>();
    const gpu::Texture picture = app.world().resource_mut<gi::ActiveTechnique>().technique->debug_view(
        name, renderer.frame->inputs(app.world().resource<FrameScene>(), *renderer.timer));
    if (!picture) {
        throw InputError(
            fmt::format("--aov: found '{}', which shows nothing in this frame of {} with these settings",
                        name, technique));
    }
    return read_picture(picture);
}

}  // namespace

void check_picture_fits(ivec2 size) {
    glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA32F, size.x, size.y, 0, GL_RGBA, GL_FLOAT, nullptr);
    GLint width = 0;
    glGetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    while (glGetError() != GL_NO_ERROR) {
    }
    if (width != size.x) {
        throw InputError(
            fmt::format("--size: found {}x{}, expected fewer pixels: this OpenGL makes no picture of them",
                        size.x, size.y));
    }
}

double shown_time(const RenderJob& job, int frames_before) {
    const double last = job.view.time.value_or(job.frames / kStepsPerSecond);
    return std::max(last - frames_before / kStepsPerSecond, 0.0);
}

RenderOutcome render_scene(SceneData scene, const Settings& settings, const RenderJob& job,
                           const std::function<void(int)>& frame_done) {
    std::unique_ptr<gpu::Context> context;  // before what draws in it
    ShownScene shown(std::move(scene), job.view);
    App& app = shown.app();

    context = gpu::create_headless_context();
    RenderOutcome outcome;
    outcome.gl = context->info();
    check_picture_fits(job.size);
    outcome.technique = gi::technique_entry(gi::gi_settings(settings).technique).name;
    gi::add_picture_plugins(app, settings, job.timing);
    app.view().size = job.size;

    std::optional<BudgetRun> budget;
    if (job.budget.any()) {
        budget.emplace(
            app, settings, job.size, job.budget,
            std::ranges::all_of(job.aovs, [](render::Aov aov) { return aov == render::Aov::final; }) &&
                job.debug_views.empty());
    }
    Clock::time_point first{};
    for (int i = 0; i < job.warmup + job.frames; ++i) {
        const Clock::time_point start = Clock::now();
        const std::clock_t cpu_start = std::clock();
        if (i == job.warmup) {
            first = start;
        }
        if (budget) {
            budget->begin_frame();
        }
        shown.show_at(shown_time(job, job.warmup + job.frames - 1 - i));
        if (budget) {
            budget->estimate();
        }
        if (!job.timing) {
            glFinish();
        }
        auto passes = app.world().resource<Renderer>().timer->end_frame();
        const double ms = milliseconds(Clock::now() - start);
        const double cpu_ms = 1e3 * static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
        if (budget) {
            budget->end_frame(ms, cpu_ms, passes);
        }
        if (i >= job.warmup) {
            outcome.frames.push_back(
                {milliseconds(start - first), ms, std::move(passes), app.frame_schedule().report(), cpu_ms});
        }
        frame_done(i + 1);
        if (StopSignal::asked() && i + 1 < job.warmup + job.frames) {
            outcome.interrupted = true;
            if (!outcome.frames.empty()) {
                break;
            }
            i = std::max(i, job.warmup - 1);  // no more warming up
        }
    }
    const render::FrameRenderer& renderer = *app.world().resource<Renderer>().frame;
    outcome.triangles = renderer.gpu_scene().triangle_count();
    const std::string scene_number =
        fmt::format("{:016x}", reference::scene_hash(still_scene(shown.world(), shown.camera())));
    for (const render::Aov aov : job.aovs) {
        outcome.images.push_back(renderer.read(aov));
        outcome.images.back().metadata = {{"technique", outcome.technique}, {"scene", scene_number}};
    }
    for (const std::string& view : job.debug_views) {
        outcome.images.push_back(debug_view(app, outcome.technique, view));
        outcome.images.back().metadata = {
            {"technique", outcome.technique}, {"scene", scene_number}, {"view", view}};
    }
    gi::Technique& technique = gi::technique_of(app, ViewId::first);
    outcome.gi = technique.statistics(true);
    if (job.timing) {
        outcome.gi.add(technique.estimate_error());
    }
    if (budget) {
        outcome.budget = budget->outcome();
    }
    outcome.nan_count = renderer.nan_count() + outcome.gi.nan_count;
    outcome.gpu_bytes = gpu::allocated_bytes();
    return outcome;
}

}  // namespace lanthorn::workbench

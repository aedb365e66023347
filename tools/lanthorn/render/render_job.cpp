#include "tools/lanthorn/render/render_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "lanthorn/gi/technique.h"
#include "lanthorn/gpu/memory.h"
#include "lanthorn/reference/scene_hash.h"
#include "lanthorn/render/detail_hints.h"
#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/view.h"

namespace lanthorn::tools {

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::duration d) {
    return std::chrono::duration<double, std::milli>(d).count();
}

// The camera as it is now, and the maps as they were in the frame before.
DetailHints who_looks(const ecs::World& world, ecs::Entity camera, ivec2 size, const FrameScene& before,
                      const render::FrameRenderer& renderer, const gi::Technique& technique) {
    DetailHints hints;
    const CameraView view = camera ? camera_view(world.get<CameraComponent>(camera).camera,
                                                 world.get<WorldTransform>(camera).matrix, before.origin)
                                   : before.camera;
    render::add_camera(hints, view, before.origin, size.y);
    render::add_light_maps(hints, renderer.light_maps(), before.origin);
    technique.add_eyes(hints, before.origin);
    return hints;
}

}  // namespace

double shown_time(const RenderJob& job, int frames_before) {
    constexpr double kFramesPerSecond = 60;
    const double last = job.view.time.value_or(job.frames / kFramesPerSecond);
    return std::max(last - frames_before / kFramesPerSecond, 0.0);
}

RenderOutcome render_scene(SceneData scene, const Settings& settings, const RenderJob& job,
                           const std::function<void(int)>& frame_done) {
    ShownScene shown(std::move(scene), job.view);
    ecs::World& world = shown.world();
    const ecs::Entity camera = shown.camera();
    ScenePlayer& player = shown.player();

    const auto context = gpu::create_headless_context();
    RenderOutcome outcome;
    outcome.gl = context->info();
    const gi::GiSettings gi_settings = gi::gi_settings(settings);
    outcome.technique = gi::technique_name(gi_settings.technique);
    const auto technique = gi::make_technique(gi_settings.technique);
    render::FrameRenderer renderer;
    renderer.settings = render::render_settings(settings);
    gpu::PassTimer timer(job.timing, outcome.gl.software);
    const auto indirect = [&](const render::FrameInputs& inputs) {
        return technique->render(inputs, gi_settings);
    };

    Extractor extractor;
    std::optional<FrameScene> last;
    Clock::time_point first{};
    for (int i = 0; i < job.warmup + job.frames; ++i) {
        const Clock::time_point start = Clock::now();
        if (i == job.warmup) {
            first = start;
        }
        player.pose(shown_time(job, job.warmup + job.frames - 1 - i));
        if (renderer.settings.adaptive_detail && last) {
            const DetailHints hints = who_looks(world, camera, job.size, *last, renderer, *technique);
            player.deform(&hints);
        } else {
            player.deform(nullptr);
        }
        last = extractor.extract(world, camera);
        renderer.render(*last, job.size, indirect, timer);
        if (!job.timing) {
            glFinish();
        }
        auto passes = timer.end_frame();
        if (i >= job.warmup) {
            outcome.frames.push_back(
                {milliseconds(start - first), milliseconds(Clock::now() - start), std::move(passes)});
        }
        frame_done(i + 1);
    }
    outcome.triangles = renderer.gpu_scene().triangle_count();
    // As the reference sees it: at full detail, and with an origin that no frame before has chosen.
    player.show(shown_time(job));
    const std::string scene_number =
        fmt::format("{:016x}", reference::scene_hash(Extractor().extract(world, camera)));
    outcome.metadata.assign(job.aovs.size(), {{"technique", outcome.technique}, {"scene", scene_number}});
    for (const render::Aov aov : job.aovs) {
        outcome.images.push_back(renderer.read(aov));
    }
    outcome.gi = technique->statistics(true);
    outcome.nan_count = renderer.nan_count() + outcome.gi.nan_count;
    outcome.gpu_bytes = gpu::allocated_bytes();
    return outcome;
}

}  // namespace lanthorn::tools

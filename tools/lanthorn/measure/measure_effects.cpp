#include "tools/lanthorn/measure/measure_effects.h"

#include <memory>
#include <optional>

#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/reference/camera_rays.h"
#include "lanthorn/reference/path_tracer.h"
#include "lanthorn/runtime/render_plugin.h"
#include "tools/lanthorn/measure/measured_scene.h"

namespace lanthorn::tools {

namespace {

using reference::PathAov;

// What a pixel shows first.
enum class Shows { nothing, diffuse, metal, glass, emitter };

struct Pictures {
    std::vector<float> indirect, radiance;  // RGB
};

std::vector<Shows> what_is_shown(const FrameScene& frame, ivec2 size) {
    const ExactSurfaces surfaces(frame);
    const reference::CameraRays rays(frame.camera, size);
    std::vector<Shows> result;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const reference::CameraRay ray =
                rays.ray(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            reference::SurfaceHit hit;
            if (!surfaces.scene.intersect(ray.origin, ray.direction, ray.nearest, ray.farthest,
                                          reference::Blended::ignored, hit, reference::Sides::seen)) {
                result.push_back(Shows::nothing);
                continue;
            }
            const reference::TraceInstance& instance = surfaces.scene.instances()[hit.instance];
            const reference::SurfaceMaterial m =
                surfaces.materials.evaluate(instance, hit.primitive, hit.barycentric);
            result.push_back(surfaces.materials[instance.material].emits ? Shows::emitter
                             : m.transmission * (1 - m.metallic) > 0.5f  ? Shows::glass
                             : m.metallic > 0.5f                         ? Shows::metal
                                                                         : Shows::diffuse);
        }
    }
    return result;
}

double luminance(const std::vector<float>& rgb, std::size_t pixel) {
    return glm::dot(dvec3(rgb[3 * pixel], rgb[3 * pixel + 1], rgb[3 * pixel + 2]),
                    dvec3(0.2126, 0.7152, 0.0722));
}

Pictures rendered(SceneData scene, Settings settings, const EffectsJob& job, bool caustics) {
    if (!caustics) {
        settings.set_from_text("gi.caustics.photons=0");
    }
    std::unique_ptr<gpu::Context> context;  // before what draws in it
    ShownScene shown(std::move(scene), job.view);
    context = gpu::create_headless_context();
    gi::add_picture_plugins(shown.app(), settings);
    shown.app().view().size = job.size;
    for (int i = 0; i < job.frames; ++i) {
        shown.show_at(job.view.time.value_or(0));
    }
    const render::FrameRenderer& renderer = *shown.world().resource<Renderer>().frame;
    return {renderer.read(render::Aov::indirect).pixels, renderer.read(render::Aov::radiance).pixels};
}

Pictures traced(const FrameScene& frame, const Settings& settings, const EffectsJob& job, bool caustics) {
    reference::PathSettings path = reference::path_settings(settings);
    path.transport = reference::Transport::full;
    path.caustics = caustics;
    path.spp = job.spp;
    reference::PathTracer tracer(frame, job.size, path, {.indirect = true, .radiance = caustics});
    tracer.render({});
    return {tracer.image(PathAov::indirect),
            caustics ? tracer.image(PathAov::radiance) : std::vector<float>()};
}

// Pictures of the whole, and of what is left without caustics and without a sky.
struct Parts {
    Pictures whole, without_caustics;
    std::optional<Pictures> without_sky;
};

SceneData with_black_skies(SceneData scene) {
    for (Sky& sky : scene.skies) {
        sky.intensity = 0;
    }
    return scene;
}

}  // namespace

std::vector<Effect> measure_effects(const std::function<SceneData()>& scene, const Settings& settings,
                                    const EffectsJob& job, const std::function<void(std::uint64_t)>& done) {
    Parts ours, theirs;
    std::vector<Shows> shows;
    std::uint64_t pictures = 0;
    const auto keep = [&](Pictures made) {
        done(++pictures);
        return made;
    };
    ours.whole = keep(rendered(scene(), settings, job, true));
    ours.without_caustics = keep(rendered(scene(), settings, job, false));
    const auto still = [&](SceneData data) {
        auto shown = std::make_unique<ShownScene>(std::move(data), job.view);
        shown->show_at(job.view.time.value_or(0));
        return shown;
    };
    {
        const auto shown = still(scene());
        shows = what_is_shown(shown->frame(), job.size);
        theirs.whole = keep(traced(shown->frame(), settings, job, true));
        theirs.without_caustics = keep(traced(shown->frame(), settings, job, false));
    }
    if (!scene().skies.empty()) {
        ours.without_sky = keep(rendered(with_black_skies(scene()), settings, job, true));
        theirs.without_sky = keep(traced(still(with_black_skies(scene()))->frame(), settings, job, true));
    }

    std::vector<Effect> effects;
    const auto add = [&](const char* name, const char* unit, std::optional<Shows> where, const auto& value) {
        Effect effect{name, unit};
        double count = 0;
        for (std::size_t p = 0; p < shows.size(); ++p) {
            if (!where || shows[p] == *where) {
                effect.technique += value(ours, p);
                effect.reference += value(theirs, p);
                ++count;
            }
        }
        if (!(effect.reference != 0 || effect.technique != 0)) {
            return;
        }
        effect.technique /= count;
        effect.reference /= count;
        effect.share = count / static_cast<double>(shows.size());
        effects.push_back(effect);
    };
    add("diffuse indirect", "lx", Shows::diffuse,
        [](const Parts& of, std::size_t p) { return luminance(of.without_caustics.indirect, p); });
    add("caustics", "lx", Shows::diffuse, [](const Parts& of, std::size_t p) {
        return luminance(of.whole.indirect, p) - luminance(of.without_caustics.indirect, p);
    });
    if (ours.without_sky) {
        add("of both, the sky", "lx", Shows::diffuse, [](const Parts& of, std::size_t p) {
            return luminance(of.whole.indirect, p) - luminance(of.without_sky->indirect, p);
        });
    }
    const auto shown = [](const Parts& of, std::size_t p) { return luminance(of.whole.radiance, p); };
    add("shown by what scatters light", "nt", Shows::diffuse, shown);
    add("mirrored by metal", "nt", Shows::metal, shown);
    add("through and off glass", "nt", Shows::glass, shown);
    add("emitted", "nt", Shows::emitter, shown);
    add("behind everything", "nt", Shows::nothing, shown);
    add("all", "nt", std::nullopt, shown);
    return effects;
}

}  // namespace lanthorn::tools

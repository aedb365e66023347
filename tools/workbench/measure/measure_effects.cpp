#include "lanthorn/workbench/measure_effects.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "gi_module/reference/camera_rays.h"
#include "lanthorn/core/stop_signal.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/reference/path_tracer.h"
#include "lanthorn/runtime/render_plugin.h"
#include "tools/workbench/measure/caustic_peak.h"
#include "tools/workbench/measure/measured_scene.h"
#include "tools/workbench/scene/stopping.h"

namespace lanthorn::workbench {

namespace {

using reference::PathAov;

// What a pixel shows first.
enum class Shows { nothing, diffuse, metal, glass, emitter };

struct Pictures {
    std::vector<float> indirect, radiance;  // RGB
};

struct FirstSurfaces {
    std::vector<Shows> shows;                   // by pixel
    std::vector<std::optional<vec3>> receives;  // where it shows what scatters light
};

FirstSurfaces what_is_shown(const FrameScene& frame, ivec2 size) {
    const ExactSurfaces surfaces(frame);
    const reference::CameraRays rays(frame.camera, size);
    FirstSurfaces result;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const reference::CameraRay ray =
                rays.ray(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            reference::SurfaceHit hit;
            if (!surfaces.scene.intersect(ray.origin, ray.direction, ray.nearest, ray.farthest,
                                          reference::Blended::solid, hit, reference::Sides::seen)) {
                result.shows.push_back(Shows::nothing);
                result.receives.emplace_back();
                continue;
            }
            const reference::TraceInstance& instance = surfaces.scene.instances()[hit.instance];
            const reference::SurfaceMaterial m =
                surfaces.materials.evaluate(instance, hit.primitive, hit.barycentric);
            result.shows.push_back(surfaces.materials[instance.material].emits ? Shows::emitter
                                   : m.transmission * (1 - m.metallic) > 0.5f  ? Shows::glass
                                   : m.metallic > 0.5f                         ? Shows::metal
                                                                               : Shows::diffuse);
            const bool scatters = result.shows.back() == Shows::diffuse;
            result.receives.push_back(scatters ? std::optional(hit.position) : std::nullopt);
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

// One of two halves of the reference, whose random numbers are others.
Pictures traced(const FrameScene& frame, const Settings& settings, const EffectsJob& job, bool caustics,
                std::uint32_t half) {
    reference::PathSettings path = reference::path_settings(settings);
    path.seed += half;
    path.transport = reference::Transport::full;
    path.caustics = caustics;
    path.spp = (job.spp + 1) / 2;
    reference::PathTracer tracer(frame, job.size, path, {.indirect = true, .radiance = caustics});
    tracer.render({.progress = [](const reference::PathProgress&) { return !StopSignal::asked(); }});
    stop_if_asked("measure", "a part of a reference tells nothing");
    return {tracer.image(PathAov::indirect),
            caustics ? tracer.image(PathAov::radiance) : std::vector<float>()};
}

Pictures mean_of(Pictures a, const Pictures& b) {
    const auto add = [](std::vector<float>& to, const std::vector<float>& from) {
        std::ranges::transform(to, from, to.begin(), [](float x, float y) { return 0.5f * (x + y); });
    };
    add(a.indirect, b.indirect);
    add(a.radiance, b.radiance);
    return a;
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

// All that is compared: the technique's, the path tracer's, and two halves of its samples, each with noise of
// its own.
struct Compared {
    Parts ours, theirs;
    std::array<Parts, 2> halves;
    FirstSurfaces first;
    double diagonal = 1;  // of the scene, metres
};

Compared make_pictures(const std::function<SceneData()>& scene, const Settings& settings,
                       const EffectsJob& job, const std::function<void(std::uint64_t)>& done) {
    Compared all;
    std::uint64_t pictures = 0;
    const auto keep = [&](Pictures made) {
        done(++pictures);
        return made;
    };
    const auto still = [&](SceneData data) {
        auto shown = std::make_unique<ShownScene>(std::move(data), job.view);
        shown->show_at(job.view.time.value_or(0));
        return shown;
    };
    all.ours.whole = keep(rendered(scene(), settings, job, true));
    all.ours.without_caustics = keep(rendered(scene(), settings, job, false));
    {
        const auto shown = still(scene());
        all.first = what_is_shown(shown->frame(), job.size);
        all.diagonal = shown->frame().diagonal();
        for (std::uint32_t h = 0; h < 2; ++h) {
            all.halves[h].whole = keep(traced(shown->frame(), settings, job, true, h));
            all.halves[h].without_caustics = keep(traced(shown->frame(), settings, job, false, h));
        }
        all.theirs.whole = mean_of(all.halves[0].whole, all.halves[1].whole);
        all.theirs.without_caustics = mean_of(all.halves[0].without_caustics, all.halves[1].without_caustics);
    }
    if (!scene().skies.empty()) {
        all.ours.without_sky = keep(rendered(with_black_skies(scene()), settings, job, true));
        const auto dark = still(with_black_skies(scene()));
        const auto half = [&](std::uint32_t h) { return traced(dark->frame(), settings, job, true, h); };
        all.theirs.without_sky = keep(mean_of(half(0), half(1)));
    }
    return all;
}

double caustic(const Parts& of, std::size_t p) {
    return luminance(of.whole.indirect, p) - luminance(of.without_caustics.indirect, p);
}

// The mean of `value` over the pixels that show that, or over all, by both; nothing where both have none.
template <class Value>
std::optional<Effect> effect_of(const char* name, const char* unit, std::optional<Shows> where,
                                const Compared& all, const Value& value) {
    const std::vector<Shows>& shows = all.first.shows;
    Effect effect{name, unit};
    double count = 0;
    for (std::size_t p = 0; p < shows.size(); ++p) {
        if (!where || shows[p] == *where) {
            effect.technique += value(all.ours, p);
            effect.reference += value(all.theirs, p);
            ++count;
        }
    }
    if (!(effect.reference != 0 || effect.technique != 0)) {
        return std::nullopt;
    }
    effect.technique /= count;
    effect.reference /= count;
    effect.share = count / static_cast<double>(shows.size());
    return effect;
}

// How far the brightest caustic is from where the path tracer has it, and how far its halves are apart.
void compare_peaks(const Compared& all, ivec2 size, Effects& effects) {
    const auto peak_of = [&](const Parts& of) {
        std::vector<double> lux;
        for (std::size_t p = 0; p < all.first.shows.size(); ++p) {
            lux.push_back(caustic(of, p));
        }
        return brightest_place(lux, all.first.receives, size);
    };
    const auto ours = peak_of(all.ours), theirs = peak_of(all.theirs);
    const auto a = peak_of(all.halves[0]), b = peak_of(all.halves[1]);
    if (ours && theirs && a && b) {
        effects.peak = {glm::distance(*ours, *theirs) / all.diagonal, glm::distance(*a, *b) / all.diagonal};
    }
}

}  // namespace

Effects measure_effects(const std::function<SceneData()>& scene, const Settings& settings,
                        const EffectsJob& job, const std::function<void(std::uint64_t)>& done) {
    const Compared all = make_pictures(scene, settings, job, done);
    Effects effects;
    const auto add = [&](const char* name, const char* unit, std::optional<Shows> where, const auto& value) {
        if (std::optional<Effect> found = effect_of(name, unit, where, all, value)) {
            effects.parts.push_back(*std::move(found));
        }
    };
    add("diffuse indirect", "lx", Shows::diffuse,
        [](const Parts& of, std::size_t p) { return luminance(of.without_caustics.indirect, p); });
    add("caustics", "lx", Shows::diffuse, caustic);
    compare_peaks(all, job.size, effects);
    if (all.ours.without_sky) {
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

}  // namespace lanthorn::workbench

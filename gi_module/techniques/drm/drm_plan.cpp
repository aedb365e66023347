#include "gi_module/techniques/drm/drm_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/scene/emissive_pieces.h"
#include "gi_module/shared/mirrors/mirror_plan.h"
#include "gi_module/shared/plan_words.h"
#include "gi_module/shared/rays/exact_rays.h"
#include "gi_module/techniques/drm/drm_settings.h"

namespace lanthorn::gi {

namespace {

using Pass = DrmPass;
using Reason = DrmReason;

constexpr float kEvenRoughness = 0.85f;  // of glossy_lobe.glsl

bool any_emissive(const FrameScene& scene) {
    return std::ranges::any_of(
        scene.instances, [&](const Instance& instance) { return gives_light(scene.material(instance)); });
}

bool any_glossy(const FrameScene& scene) {
    return std::ranges::any_of(scene.instances, [&](const Instance& instance) {
        const Material& m = scene.material(instance);
        return (m.roughness < kEvenRoughness || m.metallic_roughness_texture.present()) &&
               (m.metallic > 0 || m.specular > 0) && m.alpha_mode != AlphaMode::blend && !m.unlit;
    });
}

constexpr std::array<std::string_view, kDrmPasses> kNames = {
    "lamp_pictures", "samples", "sample_pictures", "acceleration_structure", "mirrors", "gather", "lobes"};

// Of a pass that runs.
std::string size(Pass pass, const DrmPlan& plan, const DrmSettings& settings, const DrmStatistics& counted) {
    switch (pass) {
        case Pass::lamp_pictures:
            return counted.faces_drawn > 0 ? fmt::format("{} faces", counted.faces_drawn) : std::string();
        case Pass::samples: {
            std::string text = fmt::format("{0} x {0} a light", settings.samples);
            if (counted.pictures > 0) {
                text += fmt::format(", {} lights", counted.pictures);
            }
            if (counted.left_out > 0) {
                text += fmt::format(", {} weaker ones are left out", counted.left_out);
            }
            return text;
        }
        case Pass::sample_pictures:
            return counted.sample_pictures > 0 ? fmt::format("{} samples", counted.sample_pictures)
                                               : std::string();
        case Pass::mirrors:
            return plan.shoot ? "a ray a pixel that mirrors" : "no ray";
        case Pass::gather:
            return counted.samples > 0 ? fmt::format("{} samples a pixel", counted.samples) : "every pixel";
        case Pass::acceleration_structure:
        case Pass::lobes:
            break;
    }
    return {};
}

std::string_view why(Reason reason, const DrmPlan& plan) {
    switch (reason) {
        case Reason::sky_alone:
            return "the sky is the only light: it has no picture to take samples from";
        case Reason::no_emissive_surface:
            return "no surface emits: the light maps are the pictures";
        case Reason::light_or_surfaces_changed:
            return plan.sky ? "light or surfaces changed; the sky has no picture"
                            : "light or surfaces changed";
        case Reason::pictures_hold:
            return "neither geometry nor what emits changed";
        case Reason::other_settings:
            return "other settings";
        case Reason::samples_hold:
            return "neither light nor surfaces changed";
        case Reason::samples_look_nowhere:
            return "nothing hides samples, and light is reflected once";
        case Reason::samples_look:
            return "there are other samples: what each of them sees";
        case Reason::no_exact_rays:
            return "this program has no rays for mirrors";
        case Reason::geometry_changed:
            return "refitted where something moved, rebuilt if something came or went";
        case Reason::structure_holds:
            return "no geometry changed: it holds";
        case Reason::other_light:
            return "there are other samples";
        case Reason::lobes_are_wide:
            return "no surface is glossy: irradiance says all";
        case Reason::mirrors_are_off:
        case Reason::nothing_mirrors:
        case Reason::mirrors_show_more:
        case Reason::mirrors_hold:
            return mirror_words(reason);
        case Reason::no_frame_yet:
        case Reason::no_indirect_light:
        case Reason::first_frame:
        case Reason::other_view:
        case Reason::picture_holds:
            break;
    }
    return plan_words(reason, plan.unlit);
}

void follow_mirrors(DrmPlan& plan, const FrameScene& scene, const GiSettings& settings,
                    const DrmHistory& history, bool view, bool light) {
    std::optional<Reason> without = without_mirrors<Reason>(scene, settings);
    if (!without && !history.can_trace) {
        without = Reason::no_exact_rays;
    }
    plan.mirrors = !without;
    if (without) {
        plan.set(Pass::acceleration_structure, false, *without);
        plan.set(Pass::mirrors, false, *without);
        return;
    }
    const SceneChanges& changes = scene.changes;
    const bool surfaces = changes.geometry || changes.assets || changes.emission ||
                          !changes.painted.empty() || !history.has_mirrors;
    plan.set(Pass::acceleration_structure, surfaces,
             !history.has_mirrors ? Reason::first_frame
             : surfaces           ? Reason::geometry_changed
                                  : Reason::structure_holds);
    plan.shoot = view || surfaces;
    plan_mirrors<Pass, Reason>(plan, plan.shoot || light);
}

}  // namespace

DrmPlan make_drm_plan(const FrameScene& scene, const GiSettings& settings, const DrmHistory& history) {
    DrmPlan plan;
    plan.unlit = light_bounds(scene).unlit;
    plan.sky = scene.sky.has_value();
    const bool emissive = any_emissive(scene);
    if (plan.unlit != Unlit::no || (scene.lights.empty() && !emissive)) {
        plan.steps.fill({false, plan.unlit != Unlit::no ? Reason::no_indirect_light : Reason::sky_alone});
        return plan;
    }
    plan.bounces = 1;
    const SceneChanges& changes = scene.changes;
    const bool lights = changes.geometry || changes.lights || changes.emission || changes.assets ||
                        changes.pattern || !changes.painted.empty() || history.other_light_maps;
    const bool samples = !history.has_samples || !history.same_samples || lights;
    plan.set(Pass::lamp_pictures, emissive && samples,
             !emissive              ? Reason::no_emissive_surface
             : !history.has_samples ? Reason::first_frame
             : lights               ? Reason::light_or_surfaces_changed
             : samples              ? Reason::other_settings
                                    : Reason::pictures_hold);
    plan.set(Pass::samples, samples,
             !history.has_samples ? Reason::first_frame
             : lights             ? Reason::light_or_surfaces_changed
             : samples            ? Reason::other_settings
                                  : Reason::samples_hold);
    const bool look = samples_look(settings.of<DrmSettings>());
    plan.set(Pass::sample_pictures, look && samples,
             !look     ? Reason::samples_look_nowhere
             : samples ? Reason::samples_look
                       : Reason::samples_hold);
    const bool view = !history.has_picture || !history.same_pixels || changes.camera || changes.relief ||
                      changes.geometry || changes.assets;
    follow_mirrors(plan, scene, settings, history, view, samples);
    const bool gather = view || samples || plan.on(Pass::mirrors);
    plan.set(Pass::gather, gather,
             view     ? Reason::other_view
             : gather ? Reason::other_light
                      : Reason::picture_holds);
    plan.lobes = any_glossy(scene);
    plan.set(Pass::lobes, plan.lobes && gather,
             !plan.lobes ? Reason::lobes_are_wide
             : view      ? Reason::other_view
             : gather    ? Reason::other_light
                         : Reason::picture_holds);
    return plan;
}

GiPlan in_words(const DrmPlan& plan, const GiSettings& settings, const DrmStatistics& counted) {
    return steps_in_words(
        plan, plan.bounces, kNames,
        [&](Pass pass) { return size(pass, plan, settings.of<DrmSettings>(), counted); },
        [&](Reason reason) { return why(reason, plan); });
}

GiPlan first_drm_plan(const FrameScene& scene, const GiSettings& settings) {
    return in_words(make_drm_plan(scene, settings, {.can_trace = has_exact_rays()}), settings, {});
}

}  // namespace lanthorn::gi

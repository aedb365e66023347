#include <algorithm>
#include <cmath>

#include "gi_module/techniques/emc/emc_plan.h"
#include "gi_module/techniques/emc/gather/remembered_hits.h"
#include "gi_module/techniques/emc/lit_maps/lit_photons.h"
#include "lanthorn/emc/emc_settings.h"

namespace lanthorn::gi {

namespace {

// Of photons on the lit maps, where light is reflected on and on: what follows is taken for light that falls
// off as the last of them does.
constexpr int kEndlessBounces = 4;

}  // namespace

int gather_stride(const GiSettings& settings, ivec2 size) {
    const double pixels = static_cast<double>(size.x) * size.y;
    return std::clamp(static_cast<int>(std::sqrt(pixels / settings.of<EmcSettings>().gather_points)), 1,
                      settings.of<EmcSettings>().gather_grid);
}

void plan_gather(EmcPlan& plan, const FrameScene& scene, const GiSettings& s, const EmcHistory& history) {
    using Pass = EmcPass;
    using Reason = EmcReason;
    constexpr int kFrames = RememberedHits::kFrames;
    const SceneChanges& changes = scene.changes;
    const bool sensors = !scene.sensors.empty();
    const bool surfaces = plan.on(Pass::environment_maps) || plan.on(Pass::progressive_update) ||
                          !changes.painted.empty() || !history.has_lit;
    const bool light =
        surfaces || changes.lights || changes.emission || history.other_light_maps || history.dark;
    const bool view = !history.has_image || changes.camera || changes.relief;
    plan.list_texels = surfaces;
    plan.light_texels = light;
    const bool photons = s.of<EmcSettings>().gather_source == GatherSource::photons;
    plan.lit_bounces =
        s.of<EmcSettings>().gather_endless ? useful_bounces(plan.albedo, kEndlessBounces) : plan.bounces;
    const bool indirect = plan.lit_bounces > 1 || scene.sky;
    plan.by_photons = photons && indirect && !scene.sky;
    plan.photon_bounces = !plan.by_photons                     ? 0
                          : s.of<EmcSettings>().gather_endless ? plan.lit_bounces
                                                               : plan.bounces - 1;
    plan.light_frames = light || !history.has_lit_photons ? 0 : history.light_frames;
    plan.texel_rays = indirect && !plan.by_photons && (surfaces || history.texel_frames < kFrames);
    plan.list_points = surfaces || view;
    plan.point_rays = plan.list_points || history.point_frames < kFrames;
    // Without maps to reserve it is for the statistics alone, once a still picture has all its rays.
    plan.survey =
        plan.point_rays &&
        (history.point_frames + 1 == kFrames ||
         (s.of<EmcSettings>().reserved > 0 && (plan.on(Pass::selection) || history.survey_in == 0)));
    plan.texel_frames = surfaces ? 0 : history.texel_frames;
    plan.point_frames = plan.list_points ? 0 : history.point_frames;
    const bool trace = sensors && (light || !history.has_photons || history.fading);
    // With endless bounces light still changes a little after its sources have.
    const bool goes_on =
        !plan.by_photons && indirect && s.of<EmcSettings>().gather_endless && history.light_frames < kFrames;
    const bool trace_lit = plan.by_photons && plan.light_frames < LitPhotons::kFrames;
    const bool gather = light || goes_on || trace_lit || plan.texel_rays || plan.point_rays;

    for (const Pass pass : {Pass::emission, Pass::bounces}) {
        plan.set(pass, trace, trace ? Reason::sensors_count_photons : Reason::rays_instead);
    }
    plan.set(Pass::lit_photons, trace_lit,
             !photons                 ? Reason::texels_have_rays
             : scene.sky              ? Reason::sky_by_rays
             : !indirect              ? Reason::one_reflection
             : !trace_lit             ? Reason::photons_are_in
             : plan.light_frames == 0 ? Reason::texels_count_photons
                                      : Reason::more_photons);
    plan.set(Pass::lit_maps, light || goes_on || trace_lit || plan.texel_rays,
             surfaces          ? Reason::surfaces_changed
             : light           ? Reason::lights_shade_anew
             : plan.texel_rays ? Reason::texels_shoot
             : goes_on         ? Reason::light_goes_on
             : trace_lit       ? Reason::more_photons
                               : Reason::lit_maps_hold);
    plan.set(Pass::gather, gather,
             surfaces          ? Reason::surfaces_changed
             : view            ? Reason::another_view
             : plan.point_rays ? Reason::points_shoot
             : gather          ? Reason::hits_are_shaded_anew
                               : Reason::image_holds);
    plan.set(Pass::filter, gather, gather ? Reason::gather_is_noisy : Reason::image_holds);
    plan.set(Pass::splats, false, Reason::rays_instead);
    const bool refine = !gather && history.passes < s.accumulate;
    plan.pass = refine ? history.passes : 0;
    plan.set(Pass::accumulation, refine,
             s.accumulate == 1 ? Reason::one_pass_is_all
             : refine          ? Reason::mean_of_passes
             : gather          ? Reason::rays_first
                               : Reason::all_passes_are_in);
    plan.set(Pass::upsampling, gather, gather ? Reason::from_gather_points : Reason::image_holds);
}

}  // namespace lanthorn::gi

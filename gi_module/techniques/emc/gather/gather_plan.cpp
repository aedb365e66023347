#include <algorithm>
#include <cmath>

#include "gi_module/shared/plan_rules.h"
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

void plan_gather(EmcPlan& plan, const FrameScene& scene, const GiSettings& s, const EmcKept& kept) {
    using Pass = EmcPass;
    using Reason = EmcReason;
    using Input = EmcInput;
    constexpr int kFrames = RememberedHits::kFrames;
    const auto& e = s.of<EmcSettings>();
    const auto& rules = s.of<PlanRules>();
    const EmcStamps::Versions& now = plan.now;
    const bool sensors = !scene.sensors.empty();
    const bool surfaces = kept.lit_texels.due(now);
    const bool colours = kept.lit_colours.due(now);
    plan.lit_bounces =
        e.gather_endless ? planned_bounces(s, plan.carried, kEndlessBounces, kept.lit_bounces) : plan.bounces;
    const bool other_bounces = kept.lit_bounces != 0 && kept.lit_bounces != plan.lit_bounces;
    const bool other_light = surfaces || colours || other_bounces || kept.lit_light.due(now);
    const bool light = other_light || !rules.light;
    const bool view = kept.image.due(now);
    const auto differs = [&](Input input) { return kept.lit_light.differs(input, now); };
    const bool photons = e.gather_source == GatherSource::photons;
    const bool indirect = plan.lit_bounces > 1 || scene.sky;
    // Rays that served nobody for a while have not followed what moved.
    const bool resumed = kept.lit_bounces == 1 && plan.lit_bounces > 1;
    const bool by_photons = photons && plan.lit_bounces > 1 && plan.lamps;
    const bool by_rays = indirect && (!photons || scene.sky);
    const bool new_photons = kept.lit_photons.due(now);
    plan.texel_frames = surfaces || resumed ? 0 : kept.texel_frames;
    plan.light_frames = light || new_photons ? 0 : kept.light_frames;
    const bool trace_lit = by_photons && plan.light_frames < LitPhotons::kFrames;

    LitWork& lit = plan.lit;
    lit.forget = kept.lit_rays.due(now) || resumed;
    lit.from_dark = differs(Input::darkness);
    lit.look = surfaces;
    lit.look_all = lit.forget || kept.maps.differs(Input::pattern, now);
    lit.recolour = colours && !(surfaces && lit.look_all);
    lit.light = light;
    // Where things alone have moved, light falls otherwise near them alone.
    lit.light_all = other_bounces || colours || differs(Input::lights) || differs(Input::emission) ||
                    differs(Input::darkness) || !kept.maps.differs(Input::geometry, now) || !rules.light;
    lit.sky_apart = photons && scene.sky.has_value();
    lit.shoot = by_rays && plan.texel_frames < kFrames;
    lit.photon_bounces = !by_photons ? 0 : e.gather_endless ? plan.lit_bounces : plan.bounces - 1;
    lit.trace = trace_lit;
    lit.other_light = kept.lit_light.due(now) || kept.materials.due(now) || kept.maps.due(now);
    lit.new_photons = new_photons;

    GatherWork& points = plan.gather;
    points.forget = kept.point_rays.due(now);
    points.points = surfaces || view;
    points.other_view = view;
    plan.point_frames = points.points ? 0 : kept.point_frames;
    points.shoot = plan.point_frames < kFrames;
    // Without maps to reserve it is for the statistics alone, once a still picture has all its rays.
    points.survey = points.shoot && (kept.point_frames + 1 == kFrames ||
                                     (e.reserved > 0 && (plan.on(Pass::selection) || kept.survey_in == 0)));

    const bool trace = sensors && kept.photons.due(now);
    // With endless bounces light still changes a little after its sources have.
    const bool goes_on = by_rays && e.gather_endless && kept.light_frames < kFrames;
    const bool other_picture = light || goes_on || trace_lit || lit.shoot || points.shoot;
    const bool gather = other_picture || (!rules.picture && s.accumulate == 1);

    for (const Pass pass : {Pass::emission, Pass::bounces}) {
        plan.set(pass, trace, trace ? Reason::sensors_count_photons : Reason::rays_instead);
    }
    plan.set(Pass::lit_photons, trace_lit,
             !photons                 ? Reason::texels_have_rays
             : !plan.lamps            ? Reason::sky_by_rays
             : !by_photons            ? Reason::one_reflection
             : !trace_lit             ? Reason::photons_are_in
             : plan.light_frames == 0 ? Reason::texels_count_photons
                                      : Reason::more_photons);
    plan.set(Pass::lit_maps, light || goes_on || trace_lit || lit.shoot,
             surfaces      ? Reason::surfaces_changed
             : colours     ? Reason::paint_changed
             : other_light ? Reason::lights_shade_anew
             : lit.shoot   ? Reason::texels_shoot
             : goes_on     ? Reason::light_goes_on
             : trace_lit   ? Reason::more_photons
             : light       ? Reason::rule_is_off
                           : Reason::lit_maps_hold);
    plan.set(Pass::gather, gather,
             surfaces        ? Reason::surfaces_changed
             : view          ? Reason::another_view
             : points.shoot  ? Reason::points_shoot
             : other_picture ? Reason::hits_are_shaded_anew
             : gather        ? Reason::rule_is_off
                             : Reason::image_holds);
    plan.set(Pass::filter, gather, gather ? Reason::gather_is_noisy : Reason::image_holds);
    plan.set(Pass::splats, false, Reason::rays_instead);
    plan.set(Pass::glossy_splats, false, Reason::rays_instead);
    const bool reached =
        s.target_error > 0 && kept.estimated_error && *kept.estimated_error <= s.target_error;
    const bool refine = !gather && kept.passes < s.accumulate && !reached;
    plan.pass = refine ? kept.passes : 0;
    plan.set(Pass::accumulation, refine,
             s.accumulate == 1 ? Reason::one_pass_is_all
             : refine          ? Reason::mean_of_passes
             : gather          ? Reason::rays_first
             : reached         ? Reason::error_is_reached
                               : Reason::all_passes_are_in);
    plan.set(Pass::upsampling, gather, gather ? Reason::from_gather_points : Reason::image_holds);
}

}  // namespace lanthorn::gi

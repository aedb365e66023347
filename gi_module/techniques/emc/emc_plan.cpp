#include "gi_module/techniques/emc/emc_plan.h"

#include <algorithm>

#include "gi_module/shared/plan_rules.h"
#include "lanthorn/emc/emc_settings.h"

namespace lanthorn::gi {

namespace {

using Pass = EmcPass;
using Reason = EmcReason;
using Input = EmcInput;

float box_area(const Aabb& box) {
    const vec3 size = box.upper - box.lower;
    return box.empty() ? 0.0f : 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
}

// Whether a good part of the scene has come to lie where no candidate is: beyond a tenth of the diagonal of
// what the maps were chosen for, and a tenth of the bounding boxes' area.
bool outgrown(const FrameScene& scene, const Aabb& chosen_for) {
    if (scene.changes.arrived.empty() || chosen_for.empty()) {
        return false;
    }
    const vec3 margin(0.1f * chosen_for.diagonal());
    float beyond = 0;
    for (const std::uint32_t i : scene.changes.arrived) {
        const Aabb& box = scene.instances[i].bounds;
        const bool inside = glm::all(glm::greaterThanEqual(box.lower, chosen_for.lower - margin)) &&
                            glm::all(glm::lessThanEqual(box.upper, chosen_for.upper + margin));
        beyond += inside ? 0 : box_area(box);
    }
    float all = 0;
    for (const Instance& instance : scene.instances) {
        all += box_area(instance.bounds);
    }
    return beyond > 0.1f * all;
}

Reason why_selection(const EmcPlan& plan, const EmcKept& kept, bool grown) {
    const auto other = kept.centres.other(plan.now);
    if (other == Input::scene) {
        return Reason::other_scene;
    }
    if (kept.centres.empty() || (other && other != Input::bulk && other != Input::sight)) {
        return Reason::first_frame;
    }
    return grown                   ? Reason::scene_has_grown
           : other == Input::bulk  ? Reason::bulk_is_apart
           : other == Input::sight ? Reason::camera_is_elsewhere
                                   : Reason::maps_are_chosen;
}

void plan_maps(EmcPlan& plan, const FrameScene& scene, const GiSettings& s, const EmcFrame& frame,
               const EmcKept& kept) {
    const auto& e = s.of<EmcSettings>();
    const auto& rules = s.of<PlanRules>();
    const bool geometry = kept.maps.differs(Input::geometry, plan.now);
    const bool pattern = kept.maps.differs(Input::pattern, plan.now);
    const bool grown = outgrown(scene, kept.chosen_for);
    const bool select = kept.centres.due(plan.now) || grown;
    plan.set(Pass::selection, select, why_selection(plan, kept, grown));

    plan.round_due = geometry || kept.round.differs(Input::reach, plan.now) || !rules.rounds;
    if (!select) {
        ProgressiveUpdate of_round = kept.update;
        if (kept.round.differs(Input::round_settings, plan.now)) {
            of_round.restart_round();
        }
        plan.update = of_round.step(plan.round_due, e.update_interval);
    }
    const ProgressiveUpdate::Step& update = plan.update;
    const Reason no_round = select ? Reason::chosen_anew : Reason::geometry_holds;
    plan.set(Pass::coverage, update.share >= 0,
             !update.round       ? no_round
             : update.share >= 0 ? Reason::share_is_due
                                 : Reason::candidates_wait);
    plan.set(Pass::progressive_update, update.exchange,
             update.exchange ? Reason::exchange_is_due
             : !update.round ? no_round
                             : Reason::exchange_waits);
    plan.set(Pass::reserved_map, frame.reserved,
             frame.reserved ? Reason::rays_lack_maps : Reason::rays_meet_maps);
    const bool other_maps = select || geometry || frame.reserved || pattern;
    plan.redraw_all = !rules.maps;
    plan.set(Pass::environment_maps, other_maps || plan.redraw_all,
             select                                           ? Reason::new_centres
             : frame.reserved                                 ? Reason::map_exchanged
             : geometry                                       ? Reason::geometry_changed
             : pattern                                        ? Reason::pattern_changed
             : plan.redraw_all                                ? Reason::rule_is_off
             : kept.materials.differs(Input::paint, plan.now) ? Reason::colours_are_looked_up
                                                              : Reason::maps_hold);
    plan.gather.verify = plan.lit.verify =
        geometry || plan.on(Pass::progressive_update) || plan.on(Pass::reserved_map);

    const auto makes = [&](Input made, bool anew) { version_of(plan.now, made) += anew ? 1 : 0; };
    makes(Input::chosen_maps, select);
    makes(Input::drawn_maps, other_maps);
    makes(Input::exchanged_maps, plan.on(Pass::progressive_update));
    makes(Input::fade, kept.fading);
}

Reason why_photons(const EmcPlan& plan, const EmcKept& kept, bool refine, bool trace, bool rule) {
    if (kept.photons.empty()) {
        return Reason::no_photons_yet;
    }
    const auto other = kept.photons.other(plan.now);
    if (!other) {
        return refine  ? Reason::next_pass
               : !rule ? Reason::rule_is_off
               : trace ? Reason::first_photons_again
                       : Reason::photons_hold;
    }
    switch (*other) {
        case Input::lights:
        case Input::darkness:
            return Reason::light_changed;
        case Input::emission:
            return Reason::emission_changed;
        case Input::paint:
            return Reason::paint_changed;
        case Input::light_maps:
            return Reason::light_maps_changed;
        case Input::photon_settings:
            return Reason::no_photons_yet;
        default:
            return Reason::maps_changed;
    }
}

Reason why_image(const EmcPlan& plan, const EmcKept& kept) {
    const auto other = kept.image.other(plan.now);
    return other == Input::camera        ? Reason::camera_moved
           : other == Input::relief      ? Reason::relief_changed
           : other || kept.image.empty() ? Reason::no_image_yet
                                         : Reason::image_holds;
}

void plan_splats(EmcPlan& plan, const GiSettings& s, bool glossy, const EmcKept& kept) {
    const bool new_photons = kept.photons.due(plan.now);
    const bool new_image = new_photons || kept.image.due(plan.now);
    const bool refine = !new_image && kept.passes < s.accumulate;
    // A picture begins with the first photons: those of a later pass do not serve another view.
    const auto& rules = s.of<PlanRules>();
    const bool trace = new_photons || refine || (new_image && kept.passes > 1) || !rules.light;
    const bool splat = new_image || refine || (!rules.picture && s.accumulate == 1);
    plan.splat_surroundings = kept.splat_surroundings.due(plan.now);
    plan.pass = refine ? kept.passes : 0;
    // Noise averages out over the passes, what is interpolated wrongly does not.
    plan.base = refine ? std::min(s.of<EmcSettings>().splat_base, SplatBase::quarter)
                       : s.of<EmcSettings>().splat_base;

    const Reason photons = why_photons(plan, kept, refine, trace, rules.light);
    plan.set(Pass::emission, trace, photons);
    plan.set(Pass::bounces, trace,
             !trace                     ? photons
             : plan.bounces < s.bounces ? Reason::later_bounces_are_dim
                                        : Reason::every_bounce_matters);
    for (const Pass pass : {Pass::lit_photons, Pass::lit_maps, Pass::gather, Pass::filter}) {
        plan.set(pass, false, Reason::photons_instead);
    }
    plan.set(Pass::splats, splat,
             trace                                   ? Reason::new_photons
             : !new_image && splat && !rules.picture ? Reason::rule_is_off
                                                     : why_image(plan, kept));
    plan.glossy = glossy;
    plan.set(Pass::glossy_splats, splat && glossy,
             glossy                                                      ? plan.why(Pass::splats)
             : s.of<EmcSettings>().splat_glossy == GlossyBandwidth::none ? Reason::glossy_is_off
                                                                         : Reason::nothing_is_glossy);
    plan.set(Pass::accumulation, splat && s.accumulate > 1,
             s.accumulate == 1 ? Reason::one_pass_is_all
             : refine          ? Reason::mean_of_passes
             : splat           ? Reason::first_pass
                               : Reason::all_passes_are_in);
    const bool coarse = plan.base != SplatBase::full;
    plan.set(Pass::upsampling, splat && coarse,
             !splat   ? Reason::image_holds
             : coarse ? Reason::from_low_resolution
                      : Reason::full_resolution);
}

}  // namespace

bool wants_reserved_map(const FrameScene& scene, const GiSettings& s, const EmcFrame& frame,
                        const EmcKept& kept) {
    const auto& e = s.of<EmcSettings>();
    if (!kept.lacks_maps || kept.fading || e.reserved == 0 || e.final_stage != EmcFinal::gather) {
        return false;
    }
    EmcPlan plan;
    plan.now = frame.inputs;
    plan_maps(plan, scene, s, frame, kept);
    return !plan.on(Pass::selection) && !plan.on(Pass::progressive_update);
}

EmcPlan make_emc_plan(const FrameScene& scene, const GiSettings& s, const EmcFrame& frame,
                      const EmcKept& kept) {
    EmcPlan plan;
    plan.now = frame.inputs;
    plan.unlit = frame.light.unlit;
    plan.albedo = frame.light.albedo;
    plan.carried = frame.light.carried;
    plan.lamps = frame.light.lamps;
    if (plan.unlit != Unlit::no) {
        plan.steps.fill({false, Reason::no_indirect_light});
        return plan;
    }
    plan.bounces = planned_bounces(s, frame.light.carried, s.bounces, kept.bounces);
    plan_maps(plan, scene, s, frame, kept);
    if (s.of<EmcSettings>().final_stage == EmcFinal::gather) {
        plan_gather(plan, scene, s, kept);
    } else {
        plan_splats(plan, s, frame.glossy, kept);
    }
    version_of(plan.now, Input::picture) += plan.on(Pass::gather) || plan.on(Pass::splats) ? 1 : 0;
    version_of(plan.now, Input::mean_picture) += plan.on(Pass::accumulation) ? 1 : 0;
    plan_caustics(plan, scene, s, frame.exact_rays, kept);
    plan_specular(plan, s, frame, kept);
    return plan;
}

}  // namespace lanthorn::gi

#include "gi_module/techniques/emc/emc_plan.h"

#include <algorithm>

#include "lanthorn/emc/emc_settings.h"

namespace lanthorn::gi {

namespace {

using Pass = EmcPass;
using Reason = EmcReason;

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

void plan_maps(EmcPlan& plan, const FrameScene& scene, const GiSettings& s, const EmcHistory& history) {
    const SceneChanges& changes = scene.changes;
    const bool geometry = changes.geometry;
    const bool grown = outgrown(scene, history.chosen_for);
    const bool select = !history.has_maps || changes.replaced || grown || history.apart || history.lost;
    plan.set(Pass::selection, select,
             !history.has_maps  ? Reason::first_frame
             : changes.replaced ? Reason::other_scene
             : grown            ? Reason::scene_has_grown
             : history.apart    ? Reason::bulk_is_apart
             : history.lost     ? Reason::camera_is_elsewhere
                                : Reason::maps_are_chosen);

    if (!select) {
        plan.update =
            history.update.step(geometry || history.reach_changed, s.of<EmcSettings>().update_interval);
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
    const bool reserve = history.lacks_maps && s.of<EmcSettings>().reserved > 0 && !select &&
                         !update.exchange && !history.fading &&
                         s.of<EmcSettings>().final_stage == EmcFinal::gather;
    plan.set(Pass::reserved_map, reserve, reserve ? Reason::rays_lack_maps : Reason::rays_meet_maps);
    plan.set(Pass::environment_maps, select || geometry || reserve || changes.pattern,
             select                     ? Reason::new_centres
             : reserve                  ? Reason::map_exchanged
             : geometry                 ? Reason::geometry_changed
             : changes.pattern          ? Reason::pattern_changed
             : !changes.painted.empty() ? Reason::colours_are_looked_up
                                        : Reason::maps_hold);
}

void plan_splats(EmcPlan& plan, const FrameScene& scene, const GiSettings& s, const EmcHistory& history) {
    const SceneChanges& changes = scene.changes;
    const bool maps = plan.on(Pass::environment_maps) || plan.on(Pass::progressive_update) || history.fading;
    const bool new_photons = !history.has_photons || history.other_light_maps || maps || changes.lights ||
                             changes.emission || !changes.painted.empty();
    const bool new_image = new_photons || !history.has_image || changes.camera || changes.relief;
    const bool refine = !new_image && history.passes < s.accumulate;
    // A picture begins with the first photons: those of a later pass do not serve another view.
    const bool trace = new_photons || refine || (new_image && history.passes > 1);
    const bool splat = new_image || refine;
    plan.pass = refine ? history.passes : 0;
    // Noise averages out over the passes, what is interpolated wrongly does not.
    plan.base = refine ? std::min(s.of<EmcSettings>().splat_base, SplatBase::quarter)
                       : s.of<EmcSettings>().splat_base;

    const Reason photons = !history.has_photons       ? Reason::no_photons_yet
                           : refine                   ? Reason::next_pass
                           : changes.lights           ? Reason::light_changed
                           : changes.emission         ? Reason::emission_changed
                           : !changes.painted.empty() ? Reason::paint_changed
                           : history.other_light_maps ? Reason::light_maps_changed
                           : new_photons              ? Reason::maps_changed
                           : trace                    ? Reason::first_photons_again
                                                      : Reason::photons_hold;
    plan.set(Pass::emission, trace, photons);
    plan.set(Pass::bounces, trace,
             !trace                     ? photons
             : plan.bounces < s.bounces ? Reason::later_bounces_are_dim
                                        : Reason::every_bounce_matters);
    for (const Pass pass : {Pass::lit_photons, Pass::lit_maps, Pass::gather, Pass::filter}) {
        plan.set(pass, false, Reason::photons_instead);
    }
    plan.set(Pass::splats, splat,
             trace                ? Reason::new_photons
             : !history.has_image ? Reason::no_image_yet
             : changes.camera     ? Reason::camera_moved
             : changes.relief     ? Reason::relief_changed
                                  : Reason::image_holds);
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

void EmcHistory::forget_outdated(const EmcStamps::Versions& now) {
    const auto keep = [&](EmcStamps& stamps, bool& there) {
        there = there && !stamps.due(now);
        stamps.made(now);
    };
    keep(made.maps, has_maps);
    keep(made.photons, has_photons);
    keep(made.lit, has_lit);
    keep(made.lit_photons, has_lit_photons);
    keep(made.image, has_image);
    keep(made.specular, has_specular);
    keep(made.caustics, has_caustics);
    keep(made.caustic_image, has_caustic_image);
    if (made.round.other(now)) {
        update.restart_round();
    }
    made.round.made(now);
}

void EmcHistory::darken(const SceneChanges& changes) {
    if (changes.geometry || changes.pattern || !changes.painted.empty()) {
        *this = {};
    }
    dark = true;
    has_photons = has_specular = has_caustics = has_caustic_image = false;
    has_image = has_image && !changes.camera && !changes.relief;
    passes = 0;
}

void EmcPlan::give_up() {
    bounces = 0;
    caustics = false;
    list_texels = light_texels = texel_rays = by_photons = list_points = point_rays = false;
    for (std::size_t pass = static_cast<std::size_t>(Pass::emission); pass < kEmcPasses; ++pass) {
        steps[pass] = {false, Reason::no_map};
    }
}

EmcPlan make_emc_plan(const FrameScene& scene, const GiSettings& s, const EmcHistory& history) {
    EmcPlan plan;
    const LightBounds bounds = light_bounds(scene);
    plan.unlit = bounds.unlit;
    plan.albedo = bounds.albedo;
    if (bounds.unlit != Unlit::no) {
        plan.steps.fill({false, Reason::no_indirect_light});
        return plan;
    }
    plan.bounces = useful_bounces(bounds.albedo, s.bounces);
    plan_maps(plan, scene, s, history);
    if (s.of<EmcSettings>().final_stage == EmcFinal::gather) {
        plan_gather(plan, scene, s, history);
    } else {
        plan_splats(plan, scene, s, history);
    }
    plan_specular(plan, scene, s, history);
    plan_caustics(plan, scene, s, history);
    return plan;
}

}  // namespace lanthorn::gi

// What emc's plan says of itself. Nothing here decides anything.
#include <fmt/format.h>

#include "gi_module/shared/rays/exact_rays.h"
#include "gi_module/techniques/emc/emc_plan.h"
#include "gi_module/techniques/emc/gather/remembered_hits.h"
#include "gi_module/techniques/emc/lit_maps/lit_photons.h"
#include "lanthorn/emc/emc_settings.h"

namespace lanthorn::gi {

namespace {

constexpr std::array<std::string_view, kEmcPasses> kNames = {
    "selection", "coverage",        "progressive_update", "reserved_map", "environment_maps", "emission",
    "bounces",   "caustic_photons", "lit_photons",        "lit_maps",     "gather",           "filter",
    "splats",    "glossy_splats",   "accumulation",       "upsampling",   "caustic_splats",   "specular"};

std::string maps_drawn(const EmcResults& results, const GiSettings& s) {
    return results.maps > 0 ? fmt::format("{} faces of {}^2 in {} maps", results.faces,
                                          s.of<EmcSettings>().resolution, results.maps)
                            : fmt::format("at most {} maps x 6 x {}^2", s.of<EmcSettings>().count,
                                          s.of<EmcSettings>().resolution);
}

std::string gathered(const EmcPlan& plan, const EmcResults& results, const GiSettings& s) {
    if (!plan.gather.shoot) {
        return "no ray";
    }
    const char* through = !results.exact_rays   ? ""
                          : *results.exact_rays ? " through triangles"
                                                : " through maps";
    return fmt::format("{} rays a point{}, one point {} x {} pixels", s.of<EmcSettings>().gather_rays,
                       through, s.of<EmcSettings>().gather_grid, s.of<EmcSettings>().gather_grid);
}

std::string splatted(const EmcPlan& plan, const EmcResults& results) {
    std::string words = fmt::format("1/{} of the size", 1 << static_cast<int>(plan.base));
    if (results.splat_kernel && results.splat_binning) {
        words +=
            *results.splat_kernel == SplatKernel::pixels ? ", an invocation a pixel" : ", pixels in batches";
        words += *results.splat_binning == SplatBinning::by_photon ? ", tiles found by photon"
                                                                   : ", photons by tile";
    }
    return words;
}

// What so many reflections and one more carry of the light.
std::string carried(const EmcPlan& plan, int reflections) {
    const auto place = static_cast<std::size_t>(reflections);
    return place < plan.carried.size() ? fmt::format("{:.2g} % of the light", 100 * plan.carried[place])
                                       : std::string("next to nothing");
}

// Of a pass that runs.
std::string size(EmcPass pass, const EmcPlan& plan, const EmcResults& results, const GiSettings& s) {
    switch (pass) {
        case EmcPass::selection:
            return results.maps > 0 ? fmt::format("{} candidates x 6 x 32^2, {} maps",
                                                  s.of<EmcSettings>().candidates, results.maps)
                                    : fmt::format("{} candidates x 6 x 32^2, at most {} maps",
                                                  s.of<EmcSettings>().candidates, s.of<EmcSettings>().count);
        case EmcPass::coverage:
            return fmt::format("share {} of {} of the candidates", plan.update.share + 1, plan.update.shares);
        case EmcPass::progressive_update:
            return "one map exchanged or added at most";
        case EmcPass::reserved_map:
            return "8 centres tried, one map at most";
        case EmcPass::environment_maps:
            return maps_drawn(results, s);
        case EmcPass::emission:
            return fmt::format("{} photons", s.photons);
        case EmcPass::lit_photons:
            return fmt::format("{} photons, {} bounces", s.of<EmcSettings>().gather_photons,
                               plan.lit.photon_bounces);
        case EmcPass::bounces:
            return fmt::format("{} of {}", plan.bounces, s.bounces);
        case EmcPass::lit_maps:
            return s.of<EmcSettings>().gather_endless && plan.lit_bounces > 1
                       ? fmt::format("endless reflections, the second carries {}", carried(plan, 1))
                       : fmt::format("{} of {}, the next would carry {}", plan.lit_bounces,
                                     s.of<EmcSettings>().gather_endless ? 1 : s.bounces,
                                     carried(plan, plan.lit_bounces));
        case EmcPass::gather:
            return gathered(plan, results, s);
        case EmcPass::splats:
            return splatted(plan, results);
        case EmcPass::accumulation:
            return fmt::format("pass {} of {}", plan.pass + 1, s.accumulate);
        case EmcPass::specular:
            return plan.specular_rays ? "a ray a pixel that mirrors or is looked through" : "no ray";
        case EmcPass::caustic_photons:
            return fmt::format("at most {} photons{}{}", s.of<EmcSettings>().caustic_photons,
                               plan.caustics_by_maps ? " through maps" : "",
                               plan.keep_caustics ? ", of lights that have changed" : "");
        case EmcPass::caustic_splats:
            return plan.splat_caustics ? "full size" : "added to the picture";
        case EmcPass::glossy_splats:
            return "full size";
        case EmcPass::filter:
        case EmcPass::upsampling:
            break;
    }
    return {};
}

std::string why(EmcReason reason, const EmcPlan& plan, const GiSettings& s) {
    switch (reason) {
        case EmcReason::no_frame_yet:
            return "no frame yet";
        case EmcReason::no_indirect_light:
            return std::string(words(plan.unlit));
        case EmcReason::no_map:
            return "no candidate sees the front of a surface: there is no map to trace photons in";
        case EmcReason::first_frame:
            return "no maps of these settings yet: choose environment map centres by new coverage area";
        case EmcReason::other_scene:
            return "nothing of the scene before is left: choose all maps anew";
        case EmcReason::scene_has_grown:
            return "what came reaches beyond the scene that maps were chosen for: choose anew";
        case EmcReason::bulk_is_apart:
            return "much of what maps were chosen for has left the rest: choose anew";
        case EmcReason::camera_is_elsewhere:
            return "no map is in sight of the camera any more: choose from the centres around it";
        case EmcReason::maps_are_chosen:
            return "maps are chosen";
        case EmcReason::chosen_anew:
            return "all maps are chosen anew in this frame";
        case EmcReason::geometry_holds:
            return "geometry has not changed since a round found no map to exchange";
        case EmcReason::share_is_due:
            return "geometry, what the camera reaches or a map has changed: candidates are seen anew, a "
                   "share a "
                   "frame, until a round changes nothing";
        case EmcReason::candidates_wait:
            return fmt::format("geometry or a map has changed, but candidates wait {} frames",
                               plan.update.frames_to_look());
        case EmcReason::exchange_is_due:
            return "geometry or a map has changed, and all candidates have been seen anew";
        case EmcReason::exchange_waits:
            return fmt::format("geometry or a map has changed: to be decided in {} frames",
                               plan.update.frames_left + ProgressiveUpdate::kDelay);
        case EmcReason::rays_lack_maps:
            return "rays of the picture have met what no map shows: centres near there are tried";
        case EmcReason::rays_meet_maps:
            return "hardly a ray of the picture has met what no map shows, or none can do better";
        case EmcReason::new_centres:
            return "new centres";
        case EmcReason::geometry_changed:
            return "geometry has changed: faces that see what moves";
        case EmcReason::pattern_changed:
            return "a material has another pattern: faces that see it; the centres hold";
        case EmcReason::map_exchanged:
            return "a map has been exchanged: the new one";
        case EmcReason::colours_are_looked_up:
            return "a material has another colour, which maps look up: they hold";
        case EmcReason::maps_hold:
            return "geometry has not changed: the maps hold";
        case EmcReason::mirrors_show_more:
            return "smooth or transparent surfaces show more than irradiance tells";
        case EmcReason::lobes_are_wide:
            return "no surface is smooth or transparent enough: irradiance tells what they reflect";
        case EmcReason::specular_is_off:
            return "gi.specular.roughness is 0";
        case EmcReason::nothing_is_glossy:
            return "no surface is glossy: irradiance and rays tell what they reflect";
        case EmcReason::glossy_is_off:
            return "gi.emc.splat.glossy is none: irradiance and rays tell what lobes reflect";
        case EmcReason::no_photons_yet:
            return "no photons of these settings yet";
        case EmcReason::next_pass:
            return fmt::format("nothing moves: pass {} of {} joins the mean", plan.pass + 1, s.accumulate);
        case EmcReason::light_changed:
            return "a light has changed";
        case EmcReason::emission_changed:
            return "a material emits otherwise";
        case EmcReason::paint_changed:
            return "a material reflects otherwise";
        case EmcReason::light_maps_changed:
            return "the light maps are drawn otherwise";
        case EmcReason::maps_changed:
            return "what the maps see has changed";
        case EmcReason::first_photons_again:
            return "another view: the picture begins with the first photons";
        case EmcReason::photons_hold:
            return "neither light nor geometry has changed: the photons hold";
        case EmcReason::sensors_count_photons:
            return "light sensors count photons, in frames in which they are read";
        case EmcReason::rays_instead:
            return "gi.emc.final is gather: rays from the picture meet lit maps";
        case EmcReason::photons_instead:
            return "gi.emc.final is splat: photons light the picture";
        case EmcReason::later_bounces_are_dim:
            return fmt::format("reflection {} would carry {}: less than a 500th", plan.bounces + 1,
                               carried(plan, plan.bounces));
        case EmcReason::every_bounce_matters:
            return "every bounce can still matter";
        case EmcReason::rule_is_off:
            return "a rule of the plan is off (gi.plan): it runs as if it had to";
        case EmcReason::no_specular:
            return "no specular or transmissive surface";
        case EmcReason::no_caustics_wanted:
            return "gi.caustics.photons is 0";
        case EmcReason::specular_in_the_dark:
            return "no light shines where a specular or transmissive surface is";
        case EmcReason::no_caustics_yet:
            return "no caustic photons of these settings yet";
        case EmcReason::caustics_hold:
            return "neither light nor geometry nor material has changed: caustics hold";
        case EmcReason::final_stage_changed:
            return "the picture that they are added to has changed";
        case EmcReason::surfaces_changed:
            return "the maps show other surfaces or colours: no ray is remembered";
        case EmcReason::lights_shade_anew:
            return "a light has changed: what their rays have met is shaded again";
        case EmcReason::texels_shoot:
            return fmt::format("nothing moves: frame {} of {} of their rays", plan.texel_frames + 1,
                               RememberedHits::kFrames);
        case EmcReason::texels_count_photons:
            return "gi.gather.source is photons: the lit maps count those that land on them";
        case EmcReason::more_photons:
            return fmt::format("light holds: frame {} of {} of photons joins the mean", plan.light_frames + 1,
                               LitPhotons::kFrames);
        case EmcReason::photons_are_in:
            return "light holds, and all photons of the mean are in";
        case EmcReason::texels_have_rays:
            return "gi.gather.source is rays: what rays from the lit maps meet lights them";
        case EmcReason::one_reflection:
            return "one reflection: no indirect light falls on the lit maps";
        case EmcReason::sky_by_rays:
            return "the sky alone shines: rays from the lit maps find its light";
        case EmcReason::light_goes_on:
            return "light has changed a little while ago, and goes on being reflected";
        case EmcReason::lit_maps_hold:
            return "neither light nor geometry has changed: they hold";
        case EmcReason::another_view:
            return "another view: rays serve the points that see where they start";
        case EmcReason::points_shoot:
            return fmt::format("nothing moves: frame {} of {} of rays", plan.point_frames + 1,
                               RememberedHits::kFrames);
        case EmcReason::hits_are_shaded_anew:
            return "what is remembered is shaded again";
        case EmcReason::gather_is_noisy:
            return "the gather is noisy";
        case EmcReason::from_gather_points:
            return "from the grid of points";
        case EmcReason::rays_first:
            return "the gather's own rays come first";
        case EmcReason::new_photons:
            return "new photons";
        case EmcReason::no_image_yet:
            return "no picture of this size and these settings yet";
        case EmcReason::camera_moved:
            return "the camera has moved";
        case EmcReason::relief_changed:
            return "a material has another normal map";
        case EmcReason::image_holds:
            return "nothing that the picture shows has changed: it holds";
        case EmcReason::mean_of_passes:
            return "nothing moves: the mean of all passes so far is shown";
        case EmcReason::first_pass:
            return "first pass of this picture";
        case EmcReason::one_pass_is_all:
            return "gi.accumulate is 1: a still picture stays as it is";
        case EmcReason::all_passes_are_in:
            return fmt::format("all {} passes are in the picture", s.accumulate);
        case EmcReason::error_is_reached:
            return fmt::format("the picture's error is estimated to be at most gi.target_error, {:.3g}",
                               s.target_error);
        case EmcReason::from_low_resolution:
            return "from the low resolution, discontinuities computed anew";
        case EmcReason::full_resolution:
            return "gi.emc.splat.base is 1: full resolution";
    }
    return {};
}

}  // namespace

GiPlan in_words(const EmcPlan& planned, const EmcResults& results, const GiSettings& settings) {
    EmcPlan plan = planned;
    if (results.exchanged) {
        plan.set(EmcPass::environment_maps, true, EmcReason::map_exchanged);
    }
    if (results.no_map) {
        plan.bounces = 0;
        for (std::size_t pass = static_cast<std::size_t>(EmcPass::emission); pass < kEmcPasses; ++pass) {
            plan.steps[pass] = {false, EmcReason::no_map};
        }
    }
    return steps_in_words(
        plan, plan.bounces, kNames, [&](EmcPass pass) { return size(pass, plan, results, settings); },
        [&](EmcReason reason) { return why(reason, plan, settings); });
}

GiPlan first_emc_plan(const FrameScene& scene, const GiSettings& settings) {
    EmcFrame frame;
    frame.light = light_bounds(scene);
    frame.specular = shows_specular(scene, settings);
    frame.exact_rays = has_exact_rays();
    return in_words(make_emc_plan(scene, settings, frame, {}), {}, settings);
}

}  // namespace lanthorn::gi

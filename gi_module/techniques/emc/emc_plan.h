// The plan of `emc`: which passes run in a frame, and why, decided once and before any work, from versions of
// what each is made from. The technique runs what stands here; what it then finds is in EmcResults; both
// become words only where they are printed (emc_plan_words.cpp).
#pragma once

#include <cstddef>
#include <cstdint>

#include "gi_module/techniques/emc/emc_inputs.h"
#include "gi_module/techniques/emc/emc_kept.h"
#include "gi_module/techniques/emc/emc_results.h"
#include "gi_module/techniques/emc/gather/gather_work.h"
#include "gi_module/techniques/emc/lit_maps/lit_work.h"
#include "gi_module/techniques/emc/maps/progressive_update.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/gi/pass_steps.h"
#include "lanthorn/gi/plan.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

// In the order they run in.
enum class EmcPass : std::uint8_t {
    selection,           // candidates, coverage, greedy choice, refinement
    coverage,            // a share of the candidates is seen anew
    progressive_update,  // all have been seen: one map may be exchanged or join
    reserved_map,        // a map where the picture's rays have met what none shows
    environment_maps,    // maps follow what moved
    emission,
    bounces,
    caustic_photons,
    lit_photons,  // that land on the lit maps
    lit_maps,
    gather,
    filter,
    splats,
    glossy_splats,
    accumulation,
    upsampling,
    caustic_splats,
    specular  // what the picture mirrors and what is seen through it
};
inline constexpr std::size_t kEmcPasses = 18;

// Why a pass runs or does not.
enum class EmcReason : std::uint8_t {
    no_frame_yet,
    no_indirect_light,  // EmcPlan::unlit
    no_map,
    // Of the maps.
    first_frame,
    other_scene,
    scene_has_grown,
    bulk_is_apart,
    camera_is_elsewhere,
    maps_are_chosen,
    chosen_anew,
    geometry_holds,
    share_is_due,
    candidates_wait,
    exchange_is_due,
    exchange_waits,
    rays_lack_maps,
    rays_meet_maps,
    new_centres,
    geometry_changed,
    pattern_changed,
    map_exchanged,
    colours_are_looked_up,
    maps_hold,
    rule_is_off,
    // Of photons.
    no_photons_yet,
    next_pass,
    light_changed,
    emission_changed,
    paint_changed,
    light_maps_changed,
    maps_changed,
    first_photons_again,
    photons_hold,
    sensors_count_photons,
    rays_instead,
    photons_instead,
    later_bounces_are_dim,
    every_bounce_matters,
    // Of caustic photons.
    no_specular,
    no_caustics_wanted,
    specular_in_the_dark,
    no_caustics_yet,
    caustics_hold,
    final_stage_changed,
    // Of lit maps and the gather.
    surfaces_changed,
    lights_shade_anew,
    texels_shoot,
    texels_count_photons,
    more_photons,
    photons_are_in,
    texels_have_rays,
    one_reflection,
    sky_by_rays,
    light_goes_on,
    lit_maps_hold,
    another_view,
    points_shoot,
    hits_are_shaded_anew,
    gather_is_noisy,
    from_gather_points,
    rays_first,
    // Of the picture.
    new_photons,
    no_image_yet,
    camera_moved,
    relief_changed,
    image_holds,
    mean_of_passes,
    first_pass,
    one_pass_is_all,
    all_passes_are_in,
    error_is_reached,
    from_low_resolution,
    full_resolution,
    mirrors_show_more,
    lobes_are_wide,
    specular_is_off,
    nothing_is_glossy,
    glossy_is_off
};

// What a frame's plan is made from beside scene, settings and what is kept.
struct EmcFrame {
    // Of settings, scene and light maps; of what passes make as the frame before left it.
    EmcStamps::Versions inputs{};
    LightBounds light;        // of the scene
    bool glossy = false;      // photons light the lobes of some surface of it, for these settings
    bool specular = false;    // some surface of it mirrors or is looked through, for these settings
    bool exact_rays = false;  // this program has them
    bool reserved = false;    // a map has been, in this frame
};

struct EmcPlan : PassSteps<EmcPass, EmcReason, kEmcPasses> {
    // What things are made from in this frame: EmcFrame::inputs, and the outputs of passes that run in it.
    EmcStamps::Versions now{};

    Unlit unlit = Unlit::no;
    float albedo = 0;        // of the brightest surface
    CarriedLight carried{};  // by each reflection
    bool lamps = false;      // something else than the sky shines
    int bounces = 0;         // that are traced
    int lit_bounces = 0;     // reflections that light on the lit maps is worth; endless ones end at 4 here
    ProgressiveUpdate::Step update;
    bool redraw_all = false;  // of the maps, whatever has moved (gi.plan.maps)
    bool round_due = false;   // of it: geometry, or what the camera reaches, has changed
    int pass = 0;             // passes of a still picture traced before this frame's photons
    // Of gi.emc.final = splat alone.
    SplatBase base = SplatBase::full;
    bool glossy = false;              // the picture has glossy splats
    bool splat_surroundings = false;  // surface points or maps are not those of the frame before
    // Of gi.emc.final = gather alone.
    LitWork lit;
    GatherWork gather;
    int texel_frames = 0;  // of rays that the texels remember at the start of the frame
    int light_frames = 0;  // since light on them changed
    int point_frames = 0;

    bool caustics = false;          // the picture has some
    bool caustics_by_maps = false;  // through maps; else by exact rays
    bool keep_caustics = false;     // those of lights that have not changed
    bool splat_caustics = false;    // they are splatted again, not only added to another picture
    bool caustic_surfaces = false;  // on other surfaces, or as seen from elsewhere
    bool specular_rays = false;     // of EmcPass::specular: they are traced again

    // Photons are the source of indirect light on the lit maps.
    bool by_photons() const { return lit.photon_bounces > 0; }
    // The picture has a specular part, of this frame or of one before.
    bool has_specular() const {
        return on(EmcPass::specular) || why(EmcPass::specular) == EmcReason::image_holds;
    }
};

// Decides from what is given alone. No GL, no memory, O(instances).
EmcPlan make_emc_plan(const FrameScene& scene, const GiSettings& settings, const EmcFrame& frame,
                      const EmcKept& kept);
// Whether a map is to be reserved before the frame is planned: then it is known whether one was worth it.
bool wants_reserved_map(const FrameScene& scene, const GiSettings& settings, const EmcFrame& frame,
                        const EmcKept& kept);

// The passes of gi.emc.final = gather, after those of the maps.
void plan_gather(EmcPlan& plan, const FrameScene& scene, const GiSettings& settings, const EmcKept& kept);
// Caustic photons, after the passes of the final stage.
void plan_caustics(EmcPlan& plan, const FrameScene& scene, const GiSettings& settings, bool exact_rays,
                   const EmcKept& kept);
// EmcPass::specular, after all the others.
void plan_specular(EmcPlan& plan, const GiSettings& settings, const EmcFrame& frame, const EmcKept& kept);

// Pixels between the points of the gather's grid in a picture of `size` (gi.gather.grid, gi.gather.points).
int gather_stride(const GiSettings& settings, ivec2 size);
// Whether photons light the lobes of glossy surfaces (gi.emc.splat.glossy). O(instances).
bool shows_glossy(const FrameScene& scene, const GiSettings& settings);
// Whether mirrors or glass are followed (gi.specular.roughness). O(instances).
bool shows_specular(const FrameScene& scene, const GiSettings& settings);

// The plan in words, and what it turned out to be.
GiPlan in_words(const EmcPlan& plan, const EmcResults& results, const GiSettings& settings);
GiPlan first_emc_plan(const FrameScene& scene, const GiSettings& settings);

}  // namespace lanthorn::gi

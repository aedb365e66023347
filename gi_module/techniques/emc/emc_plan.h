// The plan of `emc`: which passes run in a frame, and why, decided before any work. The technique runs what
// stands here; the words for it are made for whom it is printed (emc_plan_words.cpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "gi_module/techniques/emc/emc_inputs.h"
#include "gi_module/techniques/emc/maps/progressive_update.h"
#include "gi_module/techniques/emc/splat/splat_ways.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gi/gi_settings.h"
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
    accumulation,
    upsampling,
    caustic_splats,
    specular  // what the picture mirrors and what is seen through it
};
inline constexpr std::size_t kEmcPasses = 17;

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
    no_exact_rays,
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
    from_low_resolution,
    full_resolution,
    mirrors_show_more,
    lobes_are_wide,
    specular_is_off
};

// What `emc` remembers from frames before and the plan depends on. Default: the first frame.
struct EmcHistory {
    bool has_maps = false;           // environment maps are there
    bool has_photons = false;        // photons of an unchanged scene are there
    bool has_image = false;          // an irradiance image of an unchanged scene and camera is there
    bool has_specular = false;       // what its pixels mirror and show has been followed
    bool has_caustics = false;       // caustic photons of an unchanged scene are there
    bool has_caustic_image = false;  // and what they add to the picture
    bool exact_rays = false;         // this program has them
    ProgressiveUpdate update;        // of the maps' centres
    bool fading = false;             // a map is being exchanged
    int passes = 0;                  // that the image is the mean of
    bool has_lit = false;            // lit maps of unchanged surfaces are there
    bool has_lit_photons = false;    // photons on them, of the settings as they are
    int texel_frames = 0;            // frames of rays remembered from the lit maps
    int light_frames = 0;            // frames since light on the lit maps changed
    int point_frames = 0;            // frames of rays remembered from the picture
    bool lacks_maps = false;         // the last survey of these rays has found so
    int survey_in = 0;               // frames with rays until the next one
    // EnvironmentMaps::Reach.
    bool reach_changed = false;
    bool lost = false;
    bool apart = false;
    Aabb chosen_for;  // render space: the scene's bounds when maps were chosen
    // The light maps are not those that photons and lit maps were made from.
    bool other_light_maps = false;
    bool dark = false;  // the frame before had no indirect light

    // What those are made from.
    EmcMade made;

    // What is made from other inputs than these is not there.
    void forget_outdated(const EmcStamps::Versions& now);
    // A frame without light: maps, lit texels and remembered rays hold for when it comes back, until surfaces
    // change.
    void darken(const SceneChanges& changes);
};

struct EmcPlan {
    struct Step {
        bool on = false;
        EmcReason why = EmcReason::no_frame_yet;
    };
    std::array<Step, kEmcPasses> steps;  // by EmcPass

    Unlit unlit = Unlit::no;
    float albedo = 0;     // of the brightest surface
    int bounces = 0;      // that are traced
    int lit_bounces = 0;  // reflections that light on the lit maps is worth; endless ones end at 4 here
    ProgressiveUpdate::Step update;
    int pass = 0;                      // passes of a still picture traced before this frame's photons
    SplatBase base = SplatBase::full;  // of the splats
    // Known once the maps have been brought up to date; 0 before.
    int maps = 0;
    int faces = 0;  // of maps that were drawn

    bool caustics = false;        // the picture has some
    bool keep_caustics = false;   // those of lights that have not changed
    bool splat_caustics = false;  // they are splatted anew, not only added to another picture

    // Of gi.emc.final = gather alone.
    bool list_texels = false;    // the maps show other surfaces: which texels are lit
    bool light_texels = false;   // direct light on them anew
    bool texel_rays = false;     // a frame more of rays from them
    bool by_photons = false;     // photons are the source of their indirect light
    int photon_bounces = 0;      // of those
    bool list_points = false;    // another view, or other surfaces: points of the picture anew
    bool point_rays = false;     // a frame more of rays from them
    bool survey = false;         // what they met that no map shows is found
    bool specular_rays = false;  // of EmcPass::specular: followed anew
    // Whether rays travel through triangles instead of maps (gi.emc.rays); known once they have been shot.
    std::optional<bool> exact_rays;
    // How splats are summed, and how photons find their tiles: chosen by measuring; known once splatted.
    std::optional<SplatKernel> splat_kernel;
    std::optional<SplatBinning> splat_binning;
    int texel_frames = 0;  // of rays that the texels remember at the start of the frame
    int light_frames = 0;  // since light on them changed
    int point_frames = 0;

    bool on(EmcPass pass) const { return steps[static_cast<std::size_t>(pass)].on; }
    // The picture has a specular part, of this frame or of one before.
    bool has_specular() const {
        return on(EmcPass::specular) || why(EmcPass::specular) == EmcReason::image_holds;
    }
    EmcReason why(EmcPass pass) const { return steps[static_cast<std::size_t>(pass)].why; }
    void set(EmcPass pass, bool on, EmcReason why) { steps[static_cast<std::size_t>(pass)] = {on, why}; }
    // Nothing is traced or gathered after all: there is no map.
    void give_up();
};

// Decides from the scene, the settings and the history alone. No GL, no memory, O(instances + lights).
EmcPlan make_emc_plan(const FrameScene& scene, const GiSettings& settings, const EmcHistory& history);

// The passes of gi.emc.final = gather, after those of the maps.
void plan_gather(EmcPlan& plan, const FrameScene& scene, const GiSettings& settings,
                 const EmcHistory& history);

// Caustic photons, after the passes of the final stage.
void plan_caustics(EmcPlan& plan, const FrameScene& scene, const GiSettings& settings,
                   const EmcHistory& history);
// EmcPass::specular, after all the others.
void plan_specular(EmcPlan& plan, const FrameScene& scene, const GiSettings& settings,
                   const EmcHistory& history);

// Pixels between the points of the gather's grid in a picture of `size` (gi.gather.grid, gi.gather.points).
int gather_stride(const GiSettings& settings, ivec2 size);

// The plan in words.
GiPlan in_words(const EmcPlan& plan, const GiSettings& settings);
GiPlan first_emc_plan(const FrameScene& scene, const GiSettings& settings);

}  // namespace lanthorn::gi

// What `emc` keeps from frame to frame, by what it was made from: from that, and from what there is now, a
// frame's plan follows.
#pragma once

#include <optional>

#include "gi_module/techniques/emc/emc_inputs.h"
#include "gi_module/techniques/emc/maps/progressive_update.h"
#include "lanthorn/core/math.h"

namespace lanthorn::gi {

struct EmcPlan;
struct EmcResults;

// Default: nothing, before the first frame.
struct EmcKept {
    using Input = EmcInput;

    // The environment maps: where they are, what they show, and the round of their update.
    EmcStamps centres{Input::map_settings, Input::dark_surfaces, Input::scene, Input::bulk, Input::sight};
    EmcStamps maps{Input::geometry, Input::pattern};
    EmcStamps round{Input::round_settings, Input::geometry, Input::reach};
    ProgressiveUpdate update;
    Aabb chosen_for;          // render space: the scene's bounds when centres were chosen
    bool fading = false;      // a map is being exchanged
    bool lacks_maps = false;  // the last survey of the picture's rays has found so
    int survey_in = 0;        // frames with rays until the next one

    // Reflections that were traced, and of light on the lit maps; 0: none yet.
    int bounces = 0;
    int lit_bounces = 0;

    // What materials reflect, of the frame before: maps look colours up.
    EmcStamps materials{Input::paint};

    // Photons on the picture, or for sensors.
    EmcStamps photons{Input::photon_settings, Input::lights,         Input::emission, Input::paint,
                      Input::drawn_maps,      Input::exchanged_maps, Input::fade,     Input::light_maps,
                      Input::darkness};
    // What tells splats where surfaces end.
    EmcStamps splat_surroundings{Input::photon_settings, Input::image_settings, Input::size,
                                 Input::camera,          Input::relief,         Input::drawn_maps,
                                 Input::exchanged_maps,  Input::fade,           Input::darkness};
    // The picture, but for its light.
    EmcStamps image{Input::image_settings, Input::size, Input::camera, Input::relief};
    int passes = 0;  // that it is the mean of
    // Of the mean, relRMSE; none: nobody has asked since it began.
    std::optional<double> estimated_error;

    // Lit maps: which texels are lit, what they reflect, by what light, what their rays have met, and photons
    // on them.
    EmcStamps lit_texels{Input::lit_settings, Input::origin, Input::sky_rays, Input::drawn_maps,
                         Input::exchanged_maps};
    EmcStamps lit_colours{Input::paint};
    EmcStamps lit_light{Input::lights, Input::emission, Input::light_maps, Input::darkness};
    EmcStamps lit_rays{Input::lit_settings, Input::origin, Input::sky_rays, Input::chosen_maps};
    EmcStamps lit_photons{Input::lit_photon_settings};
    int texel_frames = 0;  // of rays
    int light_frames = 0;  // since light on them changed

    // What rays from the picture have met.
    EmcStamps point_rays{Input::point_settings, Input::size,     Input::origin,
                         Input::lit_settings,   Input::sky_rays, Input::chosen_maps};
    int point_frames = 0;  // of rays

    EmcStamps caustics{Input::caustic_settings, Input::origin, Input::darkness,
                       Input::geometry,         Input::assets, Input::paint,
                       Input::relief,           Input::lights, Input::emission};
    // What tells their splats where surfaces end, and the picture with what they add.
    EmcStamps caustic_surfaces{Input::image_settings, Input::size,     Input::darkness,
                               Input::camera,         Input::geometry, Input::assets};
    EmcStamps caustic_image{Input::caustic_photons, Input::image_settings, Input::size,
                            Input::darkness,        Input::camera,         Input::geometry,
                            Input::assets,          Input::picture,        Input::mean_picture};
    // Where rays that mirrors and glass reflect and pass on end, and what they bring.
    EmcStamps specular_rays{Input::specular_settings,
                            Input::image_settings,
                            Input::size,
                            Input::camera,
                            Input::relief,
                            Input::assets,
                            Input::geometry,
                            Input::pattern,
                            Input::paint,
                            Input::chosen_maps,
                            Input::exchanged_maps,
                            Input::darkness};
    EmcStamps specular{Input::picture, Input::caustic_photons, Input::lights, Input::emission,
                       Input::light_maps};

    // A frame has done what was planned; `bounds` of its scene.
    void done(const EmcPlan& plan, const EmcResults& results, const Aabb& bounds);
    // There was no map to do it with.
    void no_map();
    void no_caustics();
};

}  // namespace lanthorn::gi

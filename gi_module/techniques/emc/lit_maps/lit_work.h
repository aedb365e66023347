// What a frame does to the lit maps, by its plan.
#pragma once

namespace lanthorn::gi {

struct LitWork {
    bool forget = false;       // other maps: nothing that is remembered holds
    bool from_dark = false;    // the frame before had no light, whatever B holds
    bool look = false;         // the maps show other surfaces: texels look at them again,
    bool look_all = false;     // all of them, not only those that movers touch
    bool recolour = false;     // of what surfaces show colours have changed
    bool verify = false;       // things have moved, or a map was exchanged: what rays met is verified
    bool light = false;        // light, or what surfaces reflect, has changed: E0 is computed again
    bool light_all = false;    // of all texels, not only of those that movers touch
    bool shoot = false;        // a frame more of rays for E1
    int photon_bounces = 0;    // of photons, from which the lamps' E1 comes; 0: from none
    bool sky_apart = false;    // rays bring the sky's light alone, beside photons
    bool trace = false;        // a frame more of them
    bool other_light = false;  // light, surfaces or colours changed, not maps alone
    bool new_photons = false;  // other ones than before: no photon that is remembered counts
};

}  // namespace lanthorn::gi

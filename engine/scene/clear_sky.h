// The sky of a clear day about a sun, as a component: files say it in a node's extras.
#pragma once

namespace lanthorn {

// Beside a directional light: the clear day's sky about that sun (clear_sky()), wherever it stands, as much
// brighter or darker than that day's as the sun is. A sun that does not shine, or stands below the horizon,
// has none. Shines where no SkyComponent does; of several the one of the lowest entity.
struct ClearSky {
    float turbidity = 3;  // 2 to 10: clear to hazy
    float intensity = 1;  // factor
};

}  // namespace lanthorn

// The night outside every window: stars, a moon, hills at the horizon. It shines like any sky, but for moon
// and stars: the moon's light is a lamp of the level.
#pragma once

#include "lanthorn/scene/sky.h"

namespace lanthorn::game {

// `to_moon`: unit. Zenith 0.05 nits, horizon 0.22, hills 0.004; the
// moon's disc, 2.6 degrees wide (five times the real one: it is the heroine of some levels), some 40 nits.
// Some milliseconds, the first time a tenth of a second.
Sky night_sky(const vec3& to_moon);

}  // namespace lanthorn::game

// Whose map each lamp's shadows come from where there are more lamps than maps.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lanthorn/render/light_data.h"

namespace lanthorn::render {

// Gives the lights layers of maps of `resolution`, `most` in all. Directional lights have their own, and so
// have spots of one layer as long as those take at most half of all. The others share cubes: groups of lamps
// are halved, always the one with the most light times its size squared, until there are as many groups as
// cubes, and the lamp in a group's middle has the map (`shares_map` of the others is 1). So bright and lonely
// lamps have one of their own, and none is far from the one it uses. Lamps that are off or not finite have
// none. Whoever had a map in `before`, the lights as of the last call, keeps it where it may. O(n log n).
void share_maps(std::vector<LightData>& lights, std::span<const LightData> before, std::uint32_t most,
                int resolution);

}  // namespace lanthorn::render

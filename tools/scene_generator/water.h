// Water as a sheet: a height field on which waves travel.
#pragma once

#include <cstdint>
#include <span>

#include "tools/scene_generator/builder.h"

namespace lanthorn::scene_generator {

// amplitude * cos(k . p - omega t), omega such that it comes round `rounds` times in the loop. Metres,
// radians a metre.
struct Wave {
    double amplitude, k_x, k_z;
    int rounds;
};

// A sheet of 2 `half_x` by 2 `half_z` metres about the origin, of `cells_x` by `cells_z` squares; each wave
// is two of its morph targets.
Mesh water_mesh(std::uint32_t material, double half_x, double half_z, int cells_x, int cells_z,
                std::span<const Wave> waves);

// What makes them travel: the weights of the water's node.
AnimationChannel wave_channel(std::uint32_t node, std::span<const Wave> waves, double seconds);
// A thing at `place` that rises and falls with them.
AnimationChannel float_channel(std::uint32_t node, const dvec3& place, std::span<const Wave> waves,
                               double seconds);

}  // namespace lanthorn::scene_generator

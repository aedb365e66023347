// What is seen of a flame: it wavers with the time that a frame shows, in the picture alone. Its light, what
// sensors read and the simulation know nothing of that.
#pragma once

#include <cstdint>

#include "lanthorn/core/math.h"
#include "lanthorn/render/picture_only.h"
#include "lanthorn/scene/light.h"

namespace lanthorn::ecs {
class Registry;
}

namespace lanthorn::game {

// Around the light of its node, upright, while that shines.
struct Flame {
    double height = 0.1;    // metres, as it stands still
    double flicker = 0.06;  // share of its brightness by which it wavers, 0..1
    bool operator==(const Flame&) const = default;
};

// Whether flames waver (resource).
struct Flicker {
    bool on = true;
    double ahead = 0;  // seconds that they are past the moment which the frame shows
};

// The flame at `seconds` of a light at `place`, the same whenever it is asked for; each `seed` wavers by
// itself. Its middle stays within a tenth of its height.
render::Glow flame_at(const Flame& flame, const Light& light, const dvec3& place, std::uint64_t seed,
                      double seconds);
// As it stands without wavering.
render::Glow still_flame(const Flame& flame, const Light& light, const dvec3& place);

void declare_flames(ecs::Registry& registry);

}  // namespace lanthorn::game

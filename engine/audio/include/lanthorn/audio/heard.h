// What is to be heard, from where: what a Speaker plays from one moment to the next.
#pragma once

#include <cstdint>
#include <vector>

#include "lanthorn/core/math.h"
#include "lanthorn/ecs/entity.h"

namespace lanthorn::audio {

// Which effect of a Repertoire: its number, from 0 on.
using Kind = std::uint16_t;

// Something that sounds once, or as long as it goes on.
struct Sound {
    Kind kind = 0;
    dvec3 place{0};                     // world, metres
    bool placed = true;                 // else it comes from nowhere
    float gain = 1;                     // 0..1
    float pitch = 1;                    // 0.5..2
    ecs::Entity of = ecs::kNullEntity;  // whose
};

// Where it is heard from.
struct Ears {
    dvec3 place{0};
    dvec3 ahead{0, 0, -1}, up{0, 1, 0};  // unit
};

struct Heard {
    Ears ears;
    std::vector<Sound> begun;  // since the call before
    std::vector<Sound> going;  // of effects that loop, one an entity and kind at most
};

}  // namespace lanthorn::audio

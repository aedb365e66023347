// What the game tells a character, and what it learns of it. The character itself is described by the node's
// extras (physics_extras.h).
#pragma once

#include "lanthorn/core/math.h"

namespace lanthorn::physics {

// Written by the game before a step; without it the character stands.
struct CharacterInput {
    dvec3 velocity{0};  // m/s over the ground, world space; its Y is not regarded
    bool jump = false;  // takes off if it stands on ground
};

// Added and written by Physics.
struct CharacterState {
    double vertical_speed = 0;  // m/s, upwards
    bool on_ground = false;
    bool operator==(const CharacterState&) const = default;
};

}  // namespace lanthorn::physics

// What the game knows of the level's entities. Nodes of the level have these by their extras; docs/levels.md
// lists them.
//
// Declared field by field in components.cpp: what is declared is hashed, so that a replay is checked by it.
#pragma once

#include <cstdint>

#include "lanthorn/core/math.h"
#include "lanthorn/ecs/entity.h"
#include "lanthorn/scene/light.h"

namespace lanthorn::ecs {
class Registry;
}

namespace lanthorn::game {

struct Player {
    dvec3 velocity{0};       // that she walks at, metres a second
    std::uint32_t held = 0;  // Buttons down in the last step
    bool operator==(const Player&) const = default;

    static constexpr double kSpeed = 2.6;  // metres a second
};

// The camera that the player sees with; its node is below hers.
struct Eyes {
    double yaw = 0;    // radians; 0 looks along -Z, positive to the left
    double pitch = 0;  // radians, up
    bool operator==(const Eyes&) const = default;

    dvec3 facing() const;  // unit, level
};

// A leaf that turns about its node's +Y.
struct Door {
    double open_angle = 1.9;  // radians from where it stands in the file
    double angle = 0;         // radians
    double speed = 0;         // radians a second
    bool open = false;        // where it is going
    quat closed{1, 0, 0, 0};  // the node's rotation at angle 0
    bool operator==(const Door&) const = default;
};

// It can be carried, and hangs from the hand then; its node is below no other.
struct Lantern {
    double handle = 0.22;  // metres from its origin up to where it is held
    bool carried = false;
    bool lit = true;
    double yaw = 0;            // radians
    glm::dvec2 sway{0};        // radians: towards +X and +Z
    glm::dvec2 sway_speed{0};  // radians a second
    dvec3 hand{0};             // what it hangs from, last step
    dvec3 hand_velocity{0};    // metres a second
    ecs::Entity flame;         // the node of its light; null: none
    Light light;               // of the flame when it is lit
    bool operator==(const Lantern&) const = default;

    quat rotation() const;
};

// Reached once the light sensor of the same entity reads enough.
struct Goal {
    double lux = 2;
    bool reached = false;
    bool operator==(const Goal&) const = default;
};

void declare_components(ecs::Registry& registry);

}  // namespace lanthorn::game

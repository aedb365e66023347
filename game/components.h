// State of the game: what a recording's hashes cover.
#pragma once

#include <cstdint>
#include <vector>

#include "game/collision.h"
#include "lanthorn/core/math.h"
#include "lanthorn/replay/recording.h"

namespace lanthorn::game {

inline constexpr double kStep = 1.0 / 60;  // seconds a simulation step

struct Player {
    dvec3 position{0};       // feet, world
    dvec3 velocity{0};       // metres a second
    double yaw = 0;          // radians; 0 looks along -Z, positive to the left
    double pitch = 0;        // radians, up
    std::uint16_t held = 0;  // buttons down in the last step

    static constexpr double kRadius = 0.28;  // metres
    static constexpr double kHeight = 1.75;
    static constexpr double kEye = 1.62;
    static constexpr double kSpeed = 2.6;  // metres a second

    dvec3 eye() const { return position + dvec3(0, kEye, 0); }
    dvec3 facing() const;  // unit, level
    Cylinder body() const { return {position + dvec3(0, 0.05, 0), kRadius, kHeight - 0.05}; }
};

struct Door {
    double angle = 0;   // radians from where it stands in the file
    double speed = 0;   // radians a second
    bool open = false;  // where it is going
};

// Where the door hangs; never changes.
struct DoorFrame {
    dvec3 hinge{0};
    double open_angle = 0;
    std::vector<Box> leaf{};  // relative to the hinge
    dvec3 middle{0};          // of the leaf, relative to the hinge
};

struct Lantern {
    dvec3 position{0};  // of the node's origin, world
    double yaw = 0;
    glm::dvec2 sway{0};        // radians: towards +X and +Z
    glm::dvec2 sway_speed{0};  // radians a second
    dvec3 hand{0};             // what it hangs from, last step
    dvec3 hand_velocity{0};
    bool carried = false;
    bool lit = true;

    quat rotation() const;
};

// How the lantern is made; never changes.
struct LanternShape {
    double handle = 0.22;  // metres from its origin up to where it is held
};

// A thing that blocks the way and never moves.
struct Wall {
    Box box;
};

// What tells whether the far room is lit.
struct FarRoom {
    float lux = 0;     // the sensor's last reading
    bool lit = false;  // has been brighter than kLit once

    static constexpr float kLit = 1;  // lux
};

// What the player wants in this step (resource).
struct StepIntent {
    dvec3 walk{0};              // wished velocity, metres a second
    double yaw = 0, pitch = 0;  // radians to turn
    std::uint16_t pressed = 0;  // buttons that went down in this step
};

// Readings of the light sensors that enter with this step (resource).
struct SensorInput {
    std::vector<replay::SensorReading> readings;
};

// Steps since the beginning (resource).
struct Clock {
    std::uint64_t step = 0;
    std::uint64_t seed = 0;
};

}  // namespace lanthorn::game

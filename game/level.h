// What the game finds in a scene: where to start, what blocks the way, the door, the lantern, the sensor.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "game/collision.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn::game {

struct DoorPlace {
    std::uint32_t node = kNone;
    dvec3 hinge{0};           // world; the door turns about +Y through it
    double open_angle = 1.9;  // radians; extras {"open_angle": A}
    std::vector<Box> leaf{};  // relative to the hinge, as it stands in the file
    dvec3 middle{0};          // of the leaf, relative to the hinge
};

struct LanternPlace {
    std::uint32_t node = kNone;
    std::uint32_t light_node = kNone;  // the node with its light
    dvec3 position{0};                 // world; the node's origin
    double yaw = 0;
    double handle = 0.22;  // metres from the node's origin up to where it is held
};

struct Level {
    dvec3 start{0};        // feet
    double start_yaw = 0;  // radians about +Y; 0 looks along -Z
    std::vector<Box> walls;
    std::optional<DoorPlace> door;
    std::optional<LanternPlace> lantern;
    std::optional<dvec3> far_sensor;
};

// Nodes by name (player_start, door, lantern, lantern-light, far_sensor) and by extras ({"collider": "box"}:
// the box around the node's meshes). Throws InputError if there is no player_start, or extras are not as
// expected.
Level find_level(const SceneData& scene);

}  // namespace lanthorn::game

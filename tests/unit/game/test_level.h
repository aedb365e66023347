// A level small enough to reckon with: a wall along Z at x = 0 with a doorway 1 m wide around z = 0, a door
// in it that opens to +X, a lantern beside the start.
#pragma once

#include "game/level.h"

namespace lanthorn::game {

inline Level test_level() {
    Level level;
    level.start = {-2, 0, 0};
    level.start_yaw = -3.14159265358979323846 / 2;  // towards +X
    level.walls = {{{0, 1.5, 2.5}, {0.1, 1.5, 2}, 0}, {{0, 1.5, -2.5}, {0.1, 1.5, 2}, 0}};
    level.door = DoorPlace{.node = 0, .hinge = {0, 0, -0.5}, .open_angle = 1.9};
    level.door->leaf = {{{0, 1, 0.5}, {0.03, 1, 0.5}, 0}};
    level.door->middle = level.door->leaf.front().centre;
    level.lantern = LanternPlace{.node = 1, .light_node = 2, .position = {-1.2, 0, 0.5}};
    level.far_sensor = dvec3(4, 1, 0);
    return level;
}

}  // namespace lanthorn::game

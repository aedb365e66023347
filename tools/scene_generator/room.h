// The parts that rooms are built of: closed slabs that touch but never overlap, so that no light leaks and no
// two faces fight. +X is along the row of rooms, +Y up; metres.
#pragma once

#include <string>

#include "tools/scene_generator/builder.h"

namespace lanthorn::scene_generator {

inline constexpr double kWallThickness = 0.15;

// One of the six slabs of a closed room.
struct RoomSlab {
    std::string name;
    std::uint32_t material;
};

struct RoomSlabs {
    RoomSlab floor, ceiling, left, right, back, front;  // left: at the least x; back: at the least z
};

// Six nodes around the box from `low` to `high`, in the order of RoomSlabs, each a closed box `thickness`
// thick: floor and ceiling lie under and over the walls, back and front end the walls between them. `extras`:
// of each node, JSON.
void closed_room(Builder& b, const dvec3& low, const dvec3& high, const RoomSlabs& slabs,
                 double thickness = kWallThickness, const std::string& extras = {});

// A wall in the plane x = 0 (its middle) with a doorway that is centred on z = 0.
struct Doorway {
    double width = 0.9;
    double height = 2.0;
};

// Three nodes, NAME-left, NAME-right and NAME-lintel, each a closed box: z from -depth/2 to depth/2, y from 0
// to `height`. The lintel is 5 mm thinner on either side and let 10 mm into the sides: no coplanar faces.
void wall_with_doorway(Builder& b, const std::string& name, double depth, double height, const Doorway& door,
                       std::uint32_t material, const std::string& extras = {});

}  // namespace lanthorn::scene_generator

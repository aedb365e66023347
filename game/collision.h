// Collision of an upright cylinder (the player, the lantern) with upright boxes. Bodies that only stand and
// slide on level ground need no more.
#pragma once

#include <span>

#include "lanthorn/core/math.h"

namespace lanthorn::game {

// A box turned about the vertical alone.
struct Box {
    dvec3 centre{0};  // metres, world
    dvec3 half{0};    // half sizes along its own axes
    double yaw = 0;   // radians about +Y
};

// `box`, given relative to a pivot, after the pivot was turned by `angle` about +Y.
Box turned_about(const Box& box, const dvec3& pivot, double angle);

struct Cylinder {
    dvec3 foot{0};  // centre of its lower end
    double radius = 0;
    double height = 0;
};

// Touching does not count.
bool overlaps(const Cylinder& body, const Box& box);
bool overlaps(const Cylinder& body, std::span<const Box> boxes);

// Where the body stands after it was pushed out of the boxes by the shortest ways, sideways alone. Between
// boxes that leave no room it ends in one of them. O(boxes).
dvec3 pushed_out(Cylinder body, std::span<const Box> boxes);

// The body moved by `way` in steps shorter than its radius, sliding along what is in the way.
dvec3 slide(const Cylinder& body, const dvec3& way, std::span<const Box> boxes);

}  // namespace lanthorn::game

// Solids of revolution about +Y: rings, vases, lamps.
#pragma once

#include <vector>

#include "tools/scene_generator/shapes.h"

namespace lanthorn::scene_generator {

// A point of the outline in the half plane (r, y), with the outline's unit normal there. Two points in one
// place with different normals make a sharp edge.
struct OutlinePoint {
    glm::dvec2 place{0};   // distance from the axis and height, metres
    glm::dvec2 normal{0};  // out of the solid
};
using Outline = std::vector<OutlinePoint>;

// A quarter turn about `centre`, from `from` to `from` + 90 degrees counter-clockwise in the (r, y) plane, in
// `steps` steps. `from` in degrees; 0 is away from the axis. The solid is inside of it.
void add_quarter(Outline& outline, const glm::dvec2& centre, double radius, double from, int steps);
// A smooth curve through the points (Catmull and Rom 1974), `steps` to each span, normals to the right of its
// way: a solid's outer side goes up.
void add_curve(Outline& outline, const std::vector<glm::dvec2>& points, int steps);

// The outline turned once about the axis, in `sides` steps. Counter-clockwise in the (r, y) plane: up on the
// outside. It either begins and ends on the axis or comes back to its first point (`loop`).
Shape lathe(const Outline& outline, int sides, bool loop = false);

// A band with rounded edges that stands on y = 0.
Shape ring_band(double inner, double outer, double height, double edge, int sides);

}  // namespace lanthorn::scene_generator

// What of a circle lies in a triangle.
#pragma once

#include "lanthorn/core/math.h"

namespace lanthorn::gi {

// The area of the triangle (a, b, c) within the circle of `radius` about the origin, with the triangle's sign
// (counter-clockwise: positive): the sum over its edges of what lies between the edge and the origin. In the
// square of the unit of lengths; exact but for rounding. O(1).
float circle_triangle_area(const vec2& a, const vec2& b, const vec2& c, float radius);

}  // namespace lanthorn::gi

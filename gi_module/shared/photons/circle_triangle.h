// How much of a triangle lies within a circle of its plane (Lavignotte and Paulin 2003, sec. 4.1, fig. 3),
// and how far from the circle's centre.
#pragma once

#include <array>

#include "lanthorn/core/math.h"

namespace lanthorn::gi {

// Of a piece of surface, about a point.
struct AreaMoment {
    double area = 0;    // m^2
    double moment = 0;  // integral of the squared distance from the point over it, m^4

    AreaMoment& operator+=(const AreaMoment& o) {
        area += o.area;
        moment += o.moment;
        return *this;
    }
};

// Of triangle `p` cut by the circle of `radius` about 0, exact, of either winding. The paper clips the
// triangle and adds the circle's segments beyond the new edges; this sums the same area edge by edge: inside
// the circle an edge spans a triangle with the centre, outside a sector.
AreaMoment circle_triangle(const std::array<glm::dvec2, 3>& p, double radius);

// Of triangle `p` cut by the sphere of `radius` about 0; the moment is about the sphere's centre.
AreaMoment sphere_triangle(const std::array<dvec3, 3>& p, double radius);

}  // namespace lanthorn::gi

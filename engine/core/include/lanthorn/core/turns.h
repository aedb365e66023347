// Turns by arithmetic alone. The C library's sine differs in its last bit from processor to processor (with
// and without fused multiply-adds); a recording is compared bit for bit.
#pragma once

#include "lanthorn/core/math.h"

namespace lanthorn {

// Both of one angle.
struct SineCosine {
    double sine = 0, cosine = 1;
};
// Of an angle in radians, within 1e-15.
SineCosine sine_cosine(double radians);

// Rotations, counter-clockwise seen from the axis' tip.
glm::dquat about_x(double radians);
// Turns +Z towards +X.
glm::dquat about_y(double radians);
// Turns +X towards +Y.
glm::dquat about_z(double radians);

}  // namespace lanthorn

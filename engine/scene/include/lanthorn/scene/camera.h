#pragma once

#include "lanthorn/core/math.h"

namespace lanthorn {

// A camera looks along its node's -Z axis, +Y up.
struct Camera {
    bool orthographic = false;
    float y_fov = kPi / 3;  // radians, perspective; 0 < y_fov < pi
    float x_mag = 1;        // half width in metres, orthographic
    float y_mag = 1;        // half height in metres, orthographic
    float z_near = 0.05f;   // metres
    float z_far = 0;        // metres; 0: infinite (perspective only)

    bool operator==(const Camera&) const = default;
};

}  // namespace lanthorn

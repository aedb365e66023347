// Directions through the faces of a cube map, as engine/render/cube.glsl numbers and turns them.
#pragma once

#include "lanthorn/core/math.h"

namespace lanthorn::gi {

// Through the point `p` of a face, -1..1; its largest coordinate is 1.
inline vec3 cube_direction(int face, const vec2& p) {
    switch (face) {
        case 0:
            return {1, p.y, p.x};
        case 1:
            return {-1, p.y, -p.x};
        case 2:
            return {p.x, 1, p.y};
        case 3:
            return {-p.x, -1, p.y};
        case 4:
            return {-p.x, p.y, 1};
        default:
            return {p.x, p.y, -1};
    }
}

}  // namespace lanthorn::gi

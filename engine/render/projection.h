// Projections as everything here draws with them: reversed depth (1 at the near plane, 0 at infinity), clip z
// in 0..1.
#pragma once

#include "lanthorn/core/math.h"
#include "lanthorn/scene/camera.h"

namespace lanthorn::render {

// View space (looking along -Z) to clip space for an image of `aspect` = width / height. A perspective
// camera's far plane is at infinity whatever its z_far; an orthographic one keeps z_near..z_far, mapped
// to 1..0 (z_far <= z_near is taken as z_near + 1000 half heights).
mat4 reversed_projection(const Camera& camera, float aspect);

}  // namespace lanthorn::render

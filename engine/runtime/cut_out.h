// Where masked materials have holes.
#pragma once

#include <cstddef>

#include "lanthorn/scene/instance_shape.h"

namespace lanthorn {

// Whether a masked material leaves out a point of triangle `t`. Textures are looked up at their finest.
bool is_cut_out(const FrameScene& scene, const InstanceShape& shape, const Material& material, std::size_t t,
                const vec3& barycentric);

}  // namespace lanthorn

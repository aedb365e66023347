// Plants in pots.
#pragma once

#include <cstdint>
#include <string>

#include "tools/scene_generator/builder.h"

namespace lanthorn::scene_generator {

// The meshes of a fern of 1 m in its pot, some 2600 triangles, and their materials: once a scene.
struct Fern {
    std::uint32_t pot, soil, leaves;
};
Fern fern(Builder& b);

// One that stands on `foot`, about `size` metres high and wide, turned by `turn` radians. Its pot blocks the
// way.
void add_fern(Builder& b, const Fern& fern, const std::string& name, const dvec3& foot, double size,
              double turn);

}  // namespace lanthorn::scene_generator

// A curtain of the game: a cloth whose points are the joints of a subdivided cage (game/rules/cloth.h).
#pragma once

#include <string>

#include "tools/scene_generator/builder.h"

namespace lanthorn::scene_generator {

// Hangs in folds from `rail`, the one end of its upper hem, along the node's +X turned by `yaw` radians about
// +Y: `width` by `height` metres. Nothing of it goes beyond `low` and `high` along X, where walls are.
void add_curtain(Builder& b, const std::string& name, std::uint32_t material, const dvec3& rail, double yaw,
                 double width, double height, double low, double high);

// A cloth that is seen from both sides.
std::uint32_t curtain_cloth(Builder& b, const std::string& name, const vec3& colour);

}  // namespace lanthorn::scene_generator

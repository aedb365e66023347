// What the hero wears, on the puppet's joints (puppet_joints.h).
#pragma once

#include <vector>

#include "tools/scene_generator/builder.h"

namespace lanthorn::scene_generator {

// Indices of skinned meshes: tunic and sleeves, trousers, leather, skin, eyes, hair, hat, scarf, cloak.
std::vector<std::uint32_t> add_hero_meshes(Builder& b);

}  // namespace lanthorn::scene_generator

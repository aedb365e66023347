#pragma once

#include "lanthorn/scene/scene_data.h"

namespace lanthorn {

// Expects two scenes to be equal in every field but `source`, bit for bit where they are floats.
void expect_same_scene(const SceneData& a, const SceneData& b);

}  // namespace lanthorn

// What moves and deforms, written to glTF: influences, morph targets, cages, skins, animations.
#pragma once

#include "lanthorn/scene/scene_data.h"
#include "tools/scene_generator/glb_buffer.h"

namespace lanthorn::scene_generator {

// Adds JOINTS_0 and WEIGHTS_0 (and _1 where a vertex has more than four influences), sparse `targets`, and
// the cage's extras to a primitive.
void add_deformation(GlbBuffer& buffer, const Mesh& mesh, nlohmann::json& primitive);

void write_skins(GlbBuffer& buffer, const SceneData& scene);
void write_animations(GlbBuffer& buffer, const SceneData& scene);

}  // namespace lanthorn::scene_generator

#pragma once

#include <string>

#include "lanthorn/scene/scene_data.h"

namespace lanthorn::scene_generator {

// `scene` as a binary glTF 2.0 file: the same bytes for the same scene on every machine (sorted keys,
// shortest numbers that read back exactly, stored PNG). Written: positions, normals and, where the material
// has a texture, uv0; influences, morph targets and cages; metallic-roughness factors, base colour texture,
// emission and its strength, specular factor, sidedness; cameras;
// punctual lights; skins; animations; nodes with names and extras. Shear and other textures are not.
std::string glb_bytes(const SceneData& scene);

}  // namespace lanthorn::scene_generator

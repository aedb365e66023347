#pragma once

#include <string>

#include "lanthorn/scene/scene_data.h"

namespace lanthorn::scene_generator {

// `scene` as a binary glTF 2.0 file: the same bytes for the same scene on every machine
// (GltfDocument::of_scene).
std::string glb_bytes(const SceneData& scene);

}  // namespace lanthorn::scene_generator

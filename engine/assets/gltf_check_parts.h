// The parts of check_gltf(), each for some of the document's arrays, in the order in which they rely on each
// other.
#pragma once

#include "engine/assets/json_checker.h"

namespace lanthorn {

// Buffers, buffer views and accessors: types, and that each lies in what it refers to.
void check_buffers(const JsonPlace& place, nlohmann::json& root);

// Cameras, lights, nodes and scenes, and that the nodes form trees.
void check_nodes(const GltfFile& file, const JsonPlace& place, nlohmann::json& root);

}  // namespace lanthorn

// The parts of check_gltf(), each for some of the document's arrays, in the order in which they rely on each
// other.
#pragma once

#include "engine/assets/json_checker.h"

namespace lanthorn {

// Buffers, buffer views and accessors: types, and that each lies in what it refers to.
void check_buffers(const JsonPlace& place, nlohmann::json& root);

// That `place` refers under `key`, if at all, to an accessor of a type that we know.
void check_accessor_use(const JsonPlace& place, std::string_view key, nlohmann::json& root,
                        Need need = Need::optional);

// Skins and animations: types and references. Nodes and accessors must be checked.
void check_skins(const JsonPlace& place, nlohmann::json& root);
void check_animations(const JsonPlace& place, nlohmann::json& root);

// Cameras, lights, nodes and scenes, and that the nodes form trees: what can be made one is, with a note.
void check_nodes(GltfFile& file, const JsonPlace& place, nlohmann::json& root);

}  // namespace lanthorn

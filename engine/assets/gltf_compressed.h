// Data of a glTF file that is compressed: decoded into the model's own buffers, so that accessors read it as
// any other.
#pragma once

#include "engine/assets/gltf_model.h"

namespace lanthorn {

// The buffers of `model` that hold what it uses must be read. check_gltf() has checked what the extensions
// say. Both refuse data that is damaged, and, before memory is taken for it, what unpacks
// to more than GltfFile::left has.

// gltf_meshopt.cpp
// EXT_meshopt_compression: buffer views.
void decode_meshopt(GltfFile& file, tinygltf::Model& model);

// gltf_draco.cpp
// KHR_draco_mesh_compression: attributes and indices of primitives.
void decode_draco(GltfFile& file, tinygltf::Model& model);

}  // namespace lanthorn

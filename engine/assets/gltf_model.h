// A checked glTF document as tinygltf's structures, with its buffers in memory.
#pragma once

#include "engine/assets/gltf_file.h"
#include "engine/assets/tiny_gltf.h"

namespace lanthorn {

// Interprets `file`, which check_gltf() has passed. Buffers that a buffer view refers to are read (relative
// files, data URIs, the .glb chunk) and hold at least their byteLength; the others, and those whose data is
// nowhere, stay empty. What is compressed is decoded into buffers of its own (gltf_compressed.h). Images are
// described, not decoded. Animations, skins, morph targets and extras are left out. Throws InputError for a
// buffer that is missing or too short.
tinygltf::Model build_model(GltfFile& file);

}  // namespace lanthorn

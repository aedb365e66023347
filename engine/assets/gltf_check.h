// The structure of a glTF document, checked before anything interprets it.
#pragma once

#include "engine/assets/gltf_file.h"

namespace lanthorn {

// Checks everything that the importer will read: JSON types, required properties, enumerations, references
// into the document's arrays, that buffer views lie in their buffers and accessors in their views, that nodes
// form trees, and that every required extension is one we read. Values that can be mended (a metallic factor
// of 2) are left for the importer to clamp. Integers written as 4.0 become integers. Throws InputError with
// the JSON pointer of the first problem.
void check_gltf(GltfFile& file);

}  // namespace lanthorn

// Small sound glTF files that have something of everything the importer reads: what fuzzing starts from.
#pragma once

#include "tests/unit/assets/gltf_builder.h"

namespace lanthorn {

GltfBuilder furnished();  // everything that materials, cameras, lights and nodes can say
GltfBuilder encoded();    // every way to lay out and encode vertices
GltfBuilder
moving();  // a skinned quad that morphs and is subdivided, and channels of every path and interpolation

}  // namespace lanthorn

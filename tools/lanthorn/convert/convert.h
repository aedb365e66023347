// glTF to glTF through the engine.
#pragma once

#include <filesystem>

#include "lanthorn/assets/gltf_document.h"

namespace lanthorn::tools {

// What comes along.
struct ConvertOptions {
    bool allow_outside = false;   // files outside of the folder of `in`
    bool self_contained = false;  // all in one .glb
};

// Imports `in`, so that what the engine cannot read is refused, and writes it as `out`, .gltf or .glb as the
// ending says, with the bytes that it was read
// with (see GltfDocument::write). The warnings of both are in the result. Throws InputError as import_gltf
// and GltfDocument::write do, for an `out` that is `in` by any name, and for one that is no .glb where it is
// to be self-contained.
GltfDocument::Written convert(const std::filesystem::path& in, const std::filesystem::path& out,
                              const ConvertOptions& options = {});

}  // namespace lanthorn::tools

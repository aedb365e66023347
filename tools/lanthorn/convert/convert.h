// glTF to glTF through the engine.
#pragma once

#include <filesystem>

#include "lanthorn/assets/gltf_document.h"

namespace lanthorn::tools {

// Imports `in`, so that what the engine cannot read is refused, and writes it as `out`, .gltf or .glb as the
// ending says (files outside of its folder come along if `allow_outside`), with the bytes that it was read
// with (see GltfDocument::write). The warnings of both are in the result. Throws InputError as import_gltf
// and GltfDocument::write do, and for an `out` that is `in` by any name.
GltfDocument::Written convert(const std::filesystem::path& in, const std::filesystem::path& out,
                              bool allow_outside = false);

}  // namespace lanthorn::tools

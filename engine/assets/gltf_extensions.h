// Which extensions of glTF are read, and what those become that say in other words what the format says
// itself.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "engine/assets/json_checker.h"

namespace lanthorn {

// Of the extensions of which something is read: their names, sorted.
std::span<const std::string_view> read_extensions();

// Those of which nothing is read, and that a file may require all the same: names, and what names of vendors
// begin with.
std::span<const std::string_view> extensions_left_out();
std::span<const std::string_view> extension_starts_left_out();

// Refuses an extension that the file requires and that changes more than looks; notes, in one line, all that
// are used and not read.
void check_extensions(const JsonPlace& root);

// Restates in `file`, which check_gltf() has passed, what extensions say, so that nobody after needs to know
// them: EXT_texture_webp (the texture's source), KHR_animation_pointer (channels that move nodes),
// KHR_materials_pbrSpecularGlossiness (KHR_materials_specular: the same reflectance, see the .cpp; images of
// glossiness are entered in GltfFile::glossiness, and decoded to roughness in G, 0 in B),
// KHR_materials_variants (the materials of `variant`; empty: the default ones), KHR_node_visibility (nodes
// that are not visible, and those under them, show nothing and do not light). Throws InputError for a variant
// that is not in the file.
void restate_extensions(GltfFile& file, const std::string& variant);

}  // namespace lanthorn

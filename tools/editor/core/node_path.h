// Nodes by their names: "/crypt/lamp_2".
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "tools/editor/core/edit_model.h"

namespace lanthorn::editor {

// Names from the root, each behind a /. A node without a name is "#12", one of several of its name among its
// siblings "lamp#12", by its index in the document, which stays as long as the document does. ~0, ~1 and ~2
// stand for ~, / and # within a name. The scene itself is "/". O(depth * siblings).
std::string path_of(const EditModel& model, std::uint32_t node);

// kNone: no such node. "/" is kNone too. A part may leave "#12" out where the name alone is clear.
std::uint32_t find_node(const EditModel& model, std::string_view path);

// Throws InputError that says how far the path led and which name comes nearest.
std::uint32_t node_at(const EditModel& model, std::string_view path);

// What people call it: its name, or "node 12".
std::string called(const EditModel& model, std::uint32_t node);

}  // namespace lanthorn::editor

// What a node is known by in another export of its file.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/editor/core/edit_model.h"

namespace lanthorn::editor {

struct NodeMark {
    std::uint32_t node = kNone;        // its index in the document of then
    std::string path;                  // as the command's text has it
    std::string name;                  // empty: none
    std::uint64_t mesh = 0;            // hash of its mesh's contents; 0: none
    std::string kind;                  // "mesh", "point", "spot", "directional", "camera", "empty"
    dvec3 at{0};                       // its origin, metres, relative to its parent
    dvec3 world{0};                    // and in the world
    bool made = false;                 // by a command: it is in no export
    bool alone = false;                // no other node has its name
    std::vector<std::string> below{};  // names of its first children: what a group is known by
    bool operator==(const NodeMark&) const = default;
};

// `mesh_hash` gives the hash of a mesh of the document; empty: 0.
NodeMark mark_of(const EditModel& model, std::uint32_t node, std::string_view path,
                 const std::function<std::uint64_t(std::uint32_t)>& mesh_hash);

// As one word for the recovery file, and back. Throws InputError.
std::string to_text(const NodeMark& mark);
NodeMark mark_from(std::string_view text);

// The node of `model` that was marked; kNone: none, or more than one that it could be. `near` is a length
// within which two places are one.
std::uint32_t find_marked(const EditModel& model, const NodeMark& mark,
                          const std::function<std::uint64_t(std::uint32_t)>& mesh_hash);

// Whether a node has the mark's name, kind, mesh and place.
bool is_marked(const EditModel& model, std::uint32_t node, const NodeMark& mark,
               const std::function<std::uint64_t(std::uint32_t)>& mesh_hash);

}  // namespace lanthorn::editor

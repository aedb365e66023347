// Commands: what alters a scene, as one line of text each.
//
//   move /crypt/lamp_2 1.2 2 0.5
//   set /crypt/lamp_2 light.intensity 310
//
// Menu, key, palette, script, rebase and recovery are the same call. docs/editor.md lists them all.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lanthorn/ecs/registry.h"
#include "tools/editor/core/edit_model.h"
#include "tools/editor/core/node_mark.h"

namespace lanthorn::editor {

// One command as it was applied.
struct Command {
    std::string text;  // the line, with every number written out: run again it does the same
    std::string path;  // of the node it altered, as it was called before; of a material "material NAME"
    std::string before, after;           // what it altered, as JSON; empty: it was or is not there
    std::vector<NodeMark> marks;         // the nodes that its text names, in their order
    std::vector<std::uint32_t> made;     // nodes that it added
    std::vector<std::uint32_t> touched;  // nodes that it altered or added: what a user would look at
};

// What applying needs beside the model.
struct CommandContext {
    const ecs::Registry& registry;  // the components that extras may name
    // From the text of a path to the node that is meant; throws InputError. Empty: node_at().
    std::function<std::uint32_t(const EditModel&, std::string_view)> find = {};
    // Of a mesh of the document, for marks; empty: 0.
    std::function<std::uint64_t(std::uint32_t)> mesh_hash = {};
};

// Applies a line to the model. Throws InputError with what was found and what was expected; the model is
// unchanged then. O(nodes) for what adds or removes nodes, else O(depth).
Command apply_command(EditModel& model, const CommandContext& context, std::string_view line);

// The words of a line: separated by white space, "..." keeps it (with \", \\, \n and \r within), what follows
// # at the beginning of a word is left out, a word that begins with { or [ goes to its matching end. Throws
// InputError for quotes and brackets that do not end.
std::vector<std::string> words_of(std::string_view line);
// Back: in quotes where need be.
std::string word(std::string_view text);

// Help: "move PATH X Y Z", and what it does.
struct CommandHelp {
    std::string name, usage, words;
};
std::span<const CommandHelp> command_list();

// A number with no more digits than it needs to be read again as it is.
std::string number(double value);
std::string number(float value);
// The same read again: all of the text must be one, and finite.
std::optional<double> finite_number(std::string_view text);

}  // namespace lanthorn::editor

// One command being applied: its words, and what all commands share.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "tools/editor/core/command.h"

namespace lanthorn::editor {

class Operation {
  public:
    Operation(EditModel& model, const CommandContext& context, std::vector<std::string> words);

    EditModel& model;
    const CommandContext& context;
    Command result;

    std::size_t count() const { return words_.size() - 1; }  // words behind the command's name
    const std::string& name() const { return words_.front(); }
    // The word `i`, from 1. Throws InputError with the command's usage if it is missing.
    const std::string& word_at(std::size_t i) const;
    double number_at(std::size_t i) const;        // finite
    dvec3 vector_at(std::size_t i) const;         // three numbers from there on
    std::uint32_t node_at_word(std::size_t i);    // and its mark
    std::uint32_t parent_at_word(std::size_t i);  // "/" is kNone
    void expect_count(std::initializer_list<std::size_t> counts) const;
    [[noreturn]] void refuse(const std::string& problem) const;

    // The canonical text: the name and these words.
    void say(std::initializer_list<std::string> words);

    // --- changes of the model ---

    // Appends a node, whose index is the one that the document will give it, as the last child of `parent`.
    std::uint32_t add_node(ModelNode node, std::uint32_t parent);
    void detach(std::uint32_t node);
    void attach(std::uint32_t node, std::uint32_t parent);  // as its last child
    void set_local(std::uint32_t node, const Transform& local, const mat3& shear);
    std::uint32_t add_light(const Light& light);
    std::string unique_name(const std::string& name, std::uint32_t parent) const;  // among the children

  private:
    std::vector<std::string> words_;
};

// By what they alter; each takes the operation apart and does it.
void apply_transform(Operation& op);  // move, rotate, scale
void apply_structure(
    Operation& op);  // add-node, add-light, duplicate, delete, rename, reparent, group, hide, show
void apply_value(Operation& op);  // set, unset
void apply_light_value(Operation& op, std::uint32_t node, std::string_view field, const std::string& value);
void apply_scale_lights(Operation& op);
void apply_material(Operation& op);  // set-material

// The value of a word as JSON text: JSON as it is, anything else as a string. `place` is for messages.
std::string json_of(const std::string& word);

// A material's name for commands: "brick", "brick#4" where several have that name, "#4" without one.
std::string material_name(const EditModel& model, std::uint32_t material);
// Throws InputError.
std::string factor_of(const Material& material, std::string_view field);  // as JSON
// Throws InputError.
std::uint32_t material_named(const EditModel& model, std::string_view name);

}  // namespace lanthorn::editor

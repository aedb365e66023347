#include "tools/editor/core/operation.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "engine/assets/matrix_parts.h"
#include "lanthorn/core/error.h"
#include "lanthorn/scene/transforms.h"
#include "tools/editor/core/node_path.h"

namespace lanthorn::editor {

Operation::Operation(EditModel& m, const CommandContext& c, std::vector<std::string> words)
    : model(m), context(c), words_(std::move(words)) {}

void Operation::refuse(const std::string& problem) const {
    throw InputError(fmt::format("{}: {}", name(), problem));
}

const std::string& Operation::word_at(std::size_t i) const {
    if (i > count()) {
        const auto list = command_list();
        const auto help = std::ranges::find(list, name(), &CommandHelp::name);
        refuse(fmt::format("found {} word{} behind it, expected {}", count(), count() == 1 ? "" : "s",
                           help->usage));
    }
    return words_[i];
}

void Operation::expect_count(std::initializer_list<std::size_t> counts) const {
    if (std::ranges::find(counts, count()) == counts.end()) {
        const auto list = command_list();
        const auto help = std::ranges::find(list, name(), &CommandHelp::name);
        refuse(fmt::format("found {} word{} behind it, expected {}", count(), count() == 1 ? "" : "s",
                           help->usage));
    }
}

double Operation::number_at(std::size_t i) const {
    const std::string& text = word_at(i);
    const auto value = finite_number(std::string_view(text).substr(text.starts_with('+') ? 1 : 0));
    if (!value) {
        refuse(fmt::format("found '{}', expected a number", text));
    }
    return *value;
}

dvec3 Operation::vector_at(std::size_t i) const {
    return {number_at(i), number_at(i + 1), number_at(i + 2)};
}

std::uint32_t Operation::node_at_word(std::size_t i) {
    const std::string& path = word_at(i);
    const std::uint32_t node = context.find ? context.find(model, path) : node_at(model, path);
    result.marks.push_back(mark_of(model, node, editor::path_of(model, node), context.mesh_hash));
    return node;
}

std::uint32_t Operation::parent_at_word(std::size_t i) {
    return word_at(i) == "/" ? kNone : node_at_word(i);
}

void Operation::say(std::initializer_list<std::string> words) {
    result.text = name();
    for (const std::string& next : words) {
        result.text += ' ' + next;
    }
}

std::uint32_t Operation::add_node(ModelNode node, std::uint32_t parent) {
    const auto index = static_cast<std::uint32_t>(model.nodes.size());
    node.parent = kNone;
    node.made = true;
    model.nodes.push_back(std::make_shared<const ModelNode>(std::move(node)));
    attach(index, parent);
    result.made.push_back(index);
    return index;
}

void Operation::detach(std::uint32_t node) {
    const std::uint32_t parent = model.node(node).parent;
    std::erase(parent == kNone ? model.roots : model.alter(parent).children, node);
    if (parent != kNone) {
        model.alter(node).parent = kNone;
    }
}

void Operation::attach(std::uint32_t node, std::uint32_t parent) {
    (parent == kNone ? model.roots : model.alter(parent).children).push_back(node);
    model.alter(node).parent = parent;
}

void Operation::set_local(std::uint32_t node, const Transform& local, const mat3& shear) {
    constexpr double kMost = std::numeric_limits<float>::max();
    ModelNode& altered = model.alter(node);
    altered.local = local;
    altered.shear = shear;
    if (shear == mat3(1)) {
        altered.local.rotation = written_rotation(local.rotation);
    } else {  // a file has a matrix then, which is taken apart again
        const dmat4 matrix = local_matrix(local, shear);
        decompose(matrix, altered.local, altered.shear);
    }
    const dmat4 world = model.world_matrix(node);
    for (int c = 0; c < 4; ++c) {
        for (int r = 0; r < 3; ++r) {
            if (!(std::abs(world[c][r]) <= kMost)) {
                refuse("the node would leave the range of 32-bit numbers, expected it nearer");
            }
        }
    }
}

std::uint32_t Operation::add_light(const Light& light) {
    model.lights.push_back(std::make_shared<const Light>(light));
    return static_cast<std::uint32_t>(model.lights.size() - 1);
}

std::string Operation::unique_name(const std::string& wanted, std::uint32_t parent) const {
    const auto is_taken = [&](const std::string& candidate) {
        return std::ranges::any_of(model.children_of(parent),
                                   [&](std::uint32_t child) { return model.node(child).name == candidate; });
    };
    std::string candidate = wanted;
    for (int i = 2; is_taken(candidate); ++i) {
        candidate = fmt::format("{}-{}", wanted, i);
    }
    return candidate;
}

}  // namespace lanthorn::editor

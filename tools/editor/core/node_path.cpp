#include "tools/editor/core/node_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "lanthorn/core/error.h"
#include "lanthorn/core/value_info.h"

namespace lanthorn::editor {

namespace {

std::string escaped(std::string_view name) {
    std::string out;
    for (const char c : name) {
        switch (c) {
            case '~':
                out += "~0";
                break;
            case '/':
                out += "~1";
                break;
            case '#':
                out += "~2";
                break;
            default:
                out += c;
        }
    }
    return out;
}

std::string plain(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '~' && i + 1 < text.size() && text[i + 1] >= '0' && text[i + 1] <= '2') {
            out += "~/#"[text[++i] - '0'];
        } else {
            out += text[i];
        }
    }
    return out;
}

std::string part_of(const EditModel& model, std::uint32_t index) {
    const ModelNode& node = model.node(index);
    bool is_alone = !node.name.empty();
    if (is_alone) {
        for (const std::uint32_t sibling : model.children_of(node.parent)) {
            is_alone = is_alone && (sibling == index || model.node(sibling).name != node.name);
        }
    }
    return is_alone ? escaped(node.name) : fmt::format("{}#{}", escaped(node.name), index);
}

struct Part {
    std::string name;
    std::optional<std::uint32_t> index;
};

Part parsed_part(std::string_view text) {
    const std::size_t hash = text.find('#');
    Part part{plain(text.substr(0, hash)), {}};
    if (hash != std::string_view::npos) {
        std::uint32_t index = kNone;
        const std::string_view digits = text.substr(hash + 1);
        const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
        part.index = problem == std::errc() && end == digits.data() + digits.size() ? index : kNone;
    }
    return part;
}

// Follows the path as far as it leads.
struct Walk {
    std::uint32_t node = kNone;
    bool complete = false;
    std::string_view missing;  // the first part that leads nowhere
    bool ambiguous = false;    // it names several
};

Walk walk(const EditModel& model, std::string_view path) {
    Walk at;
    if (!path.starts_with('/')) {
        at.missing = path;
        return at;
    }
    path.remove_prefix(1);
    if (path.empty()) {
        at.complete = true;
        return at;
    }
    while (true) {
        const std::size_t slash = path.find('/');
        const std::string_view text = path.substr(0, slash);
        const Part part = parsed_part(text);
        std::uint32_t found = kNone;
        for (const std::uint32_t child : model.children_of(at.node)) {
            const bool is_meant =
                model.node(child).name == part.name && (!part.index || *part.index == child);
            if (is_meant && found != kNone) {
                at.ambiguous = true;
            }
            found = is_meant ? child : found;
        }
        if (found == kNone || at.ambiguous) {
            at.missing = text;
            return at;
        }
        at.node = found;
        if (slash == std::string_view::npos) {
            at.complete = true;
            return at;
        }
        path.remove_prefix(slash + 1);
    }
}

}  // namespace

std::string path_of(const EditModel& model, std::uint32_t node) {
    if (node == kNone) {
        return "/";
    }
    std::string path;
    for (; node != kNone; node = model.node(node).parent) {
        path.insert(0, '/' + part_of(model, node));
    }
    return path;
}

std::uint32_t find_node(const EditModel& model, std::string_view path) {
    const Walk at = walk(model, path);
    return at.complete ? at.node : kNone;
}

std::uint32_t node_at(const EditModel& model, std::string_view path) {
    if (!path.starts_with('/')) {
        throw InputError(fmt::format("found '{}', expected a node's path: /NAME/NAME", path));
    }
    const Walk at = walk(model, path);
    if (at.complete && at.node != kNone) {
        return at.node;
    }
    if (at.complete) {
        throw InputError("found '/', the scene itself, expected a node in it");
    }
    const std::string in = at.node == kNone ? "the scene" : fmt::format("'{}'", path_of(model, at.node));
    if (at.ambiguous) {
        throw InputError(fmt::format("'{}': {} has several '{}', expected one of them by its index: {}#INDEX",
                                     path, in, at.missing, at.missing));
    }
    std::string nearest;
    std::size_t distance = std::max<std::size_t>(2, at.missing.size() / 2) + 1;
    for (const std::uint32_t child : model.children_of(at.node)) {
        const std::string part = part_of(model, child);
        const std::size_t d = edit_distance(part, at.missing);
        if (d < distance) {
            distance = d;
            nearest = part;
        }
    }
    throw InputError(fmt::format("'{}': {} has no '{}'{}", path, in, at.missing,
                                 nearest.empty() ? "" : fmt::format("; '{}' comes nearest", nearest)));
}

std::string called(const EditModel& model, std::uint32_t node) {
    const ModelNode& found = model.node(node);
    return found.name.empty() ? fmt::format("node {}", node) : found.name;
}

}  // namespace lanthorn::editor

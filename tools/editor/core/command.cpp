#include "tools/editor/core/command.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "engine/core/json.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/value_info.h"
#include "tools/editor/core/node_path.h"
#include "tools/editor/core/operation.h"

namespace lanthorn::editor {

namespace {

struct Entry {
    CommandHelp help;
    void (*apply)(Operation&);
};

const std::vector<Entry>& entries() {
    static const std::vector<Entry> list = {
        {{"move", "move PATH X Y Z", "its place, metres from its parent"}, apply_transform},
        {{"rotate", "rotate PATH X Y Z",
          "degrees about X, then Y, then Z; four numbers: a quaternion X Y Z W"},
         apply_transform},
        {{"scale", "scale PATH FACTOR | X Y Z", "its size along its own axes"}, apply_transform},
        {{"set", "set PATH FIELD VALUE",
          "a field of a component (door.open_angle), a light (light.intensity 310, 800lm, 40lx; light.colour "
          "2700K), a camera (camera.y_fov), or extras.KEY as JSON"},
         apply_value},
        {{"unset", "unset PATH COMPONENT", "takes a component, light, camera or extras.KEY away"},
         apply_value},
        {{"set-material", "set-material NAME FIELD VALUE",
          "a material's factor: base_colour, roughness, ..."},
         apply_material},
        {{"scale-lights", "scale-lights FACTOR", "every light's intensity times this"}, apply_scale_lights},
        {{"add-node", "add-node PARENT NAME [X Y Z]", "an empty node"}, apply_structure},
        {{"add-light", "add-light PARENT NAME point|spot|directional X Y Z [VALUE [COLOUR]]",
          "a light: 80 cd and 3000 K (directional: 10000 lx and white) unless said otherwise"},
         apply_structure},
        {{"duplicate", "duplicate PATH [NAME]", "the node and what stands under it once more"},
         apply_structure},
        {{"delete", "delete PATH", "the node and what stands under it"}, apply_structure},
        {{"rename", "rename PATH NAME", "another name"}, apply_structure},
        {{"reparent", "reparent PATH PARENT", "under another node, or / for none; it stays where it is"},
         apply_structure},
        {{"group", "group NAME PATH...", "a node above them, beside the first; they stay where they are"},
         apply_structure},
        {{"hide", "hide PATH", "the node and what stands under it is not shown (KHR_node_visibility)"},
         apply_structure},
        {{"show", "show PATH", "undoes hide"}, apply_structure},
    };
    return list;
}

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

// The end of the JSON object or array at `i`.
std::size_t end_of_json(std::string_view line, std::size_t i) {
    int depth = 0;
    bool quoted = false;
    for (std::size_t at = i; at < line.size(); ++at) {
        const char c = line[at];
        if (quoted) {
            at += c == '\\' ? 1 : 0;
            quoted = c != '"';
        } else if (c == '"') {
            quoted = true;
        } else if (c == '{' || c == '[') {
            ++depth;
        } else if (c == '}' || c == ']') {
            if (--depth == 0) {
                return at + 1;
            }
        }
    }
    throw InputError(
        fmt::format("found '{}' without its end, expected {}", line[i], line[i] == '{' ? '}' : ']'));
}

template <class T>
std::string shortest(T value) {
    if (std::isinf(value)) {
        return value > 0 ? "inf" : "-inf";
    }
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value == 0 ? T(0) : value).ptr;
    return {text.data(), end};
}

}  // namespace

std::string number(double value) {
    return shortest(value);
}

std::string number(float value) {
    return shortest(value);
}

std::optional<double> finite_number(std::string_view text) {
    double value = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = problem == std::errc() && end == text.data() + text.size() && std::isfinite(value);
    return whole ? std::optional(value) : std::nullopt;
}

std::vector<std::string> words_of(std::string_view line) {
    std::vector<std::string> words;
    std::size_t i = 0;
    while (true) {
        while (i < line.size() && is_space(line[i])) {
            ++i;
        }
        if (i == line.size() || line[i] == '#') {
            return words;
        }
        std::string found;
        if (line[i] == '{' || line[i] == '[') {
            const std::size_t end = end_of_json(line, i);
            found = line.substr(i, end - i);
            i = end;
        } else if (line[i] == '"') {
            for (++i; i < line.size() && line[i] != '"'; ++i) {
                const bool is_escaped = line[i] == '\\' && i + 1 < line.size();
                i += is_escaped ? 1 : 0;
                found += is_escaped && line[i] == 'n' ? '\n' : is_escaped && line[i] == 'r' ? '\r' : line[i];
            }
            if (i == line.size()) {
                throw InputError("found a quotation mark without its end, expected another \"");
            }
            ++i;
        } else {
            while (i < line.size() && !is_space(line[i])) {
                found += line[i++];
            }
        }
        words.push_back(std::move(found));
    }
}

std::string word(std::string_view text) {
    const bool is_plain = !text.empty() && text.front() != '"' && text.front() != '#' &&
                          text.front() != '{' && text.front() != '[' &&
                          std::ranges::none_of(text, [](char c) { return is_space(c); });
    if (is_plain) {
        return std::string(text);
    }
    if ((text.starts_with('{') || text.starts_with('[')) && json_if_valid(text)) {
        return std::string(text);
    }
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\' || c == '\n' || c == '\r') {
            quoted += '\\';
        }
        quoted += c == '\n' ? 'n' : c == '\r' ? 'r' : c;
    }
    return quoted + '"';
}

std::span<const CommandHelp> command_list() {
    static const std::vector<CommandHelp> list = [] {
        std::vector<CommandHelp> all;
        for (const Entry& entry : entries()) {
            all.push_back(entry.help);
        }
        return all;
    }();
    return list;
}

Command apply_command(EditModel& model, const CommandContext& context, std::string_view line) {
    std::vector<std::string> words = words_of(line);
    if (words.empty()) {
        throw InputError("found an empty line, expected a command");
    }
    const auto found =
        std::ranges::find_if(entries(), [&](const Entry& entry) { return entry.help.name == words.front(); });
    if (found == entries().end()) {
        std::string nearest;
        std::size_t distance = 3;
        for (const Entry& entry : entries()) {
            if (const std::size_t d = edit_distance(entry.help.name, words.front()); d < distance) {
                distance = d;
                nearest = entry.help.name;
            }
        }
        throw InputError(fmt::format("found '{}', expected a command{}", words.front(),
                                     nearest.empty() ? "" : fmt::format(" ('{}' comes nearest)", nearest)));
    }
    EditModel altered = model;  // a pointer a node: what fails changes nothing
    Operation op(altered, context, std::move(words));
    found->apply(op);
    model = std::move(altered);
    return std::move(op.result);
}

}  // namespace lanthorn::editor

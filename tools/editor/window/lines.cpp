#include "tools/editor/window/lines.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tools/editor/core/command.h"

namespace lanthorn::edit_window {

using editor::number;
using editor::word;

std::string move_line(const std::string& path, const dvec3& t) {
    return fmt::format("move {} {} {} {}", word(path), number(t.x), number(t.y), number(t.z));
}

std::string turn_line(const std::string& path, const quat& r) {
    return fmt::format("rotate {} {} {} {} {}", word(path), number(r.x), number(r.y), number(r.z),
                       number(r.w));
}

std::string scale_line(const std::string& path, const vec3& s) {
    return fmt::format("scale {} {} {} {}", word(path), number(s.x), number(s.y), number(s.z));
}

std::vector<std::string> transform_lines(const std::string& path, const Transform& from,
                                         const Transform& to) {
    std::vector<std::string> lines;
    if (from.translation != to.translation) {
        lines.push_back(move_line(path, to.translation));
    }
    if (from.rotation != to.rotation) {
        lines.push_back(turn_line(path, to.rotation));
    }
    if (from.scale != to.scale) {
        lines.push_back(scale_line(path, to.scale));
    }
    return lines;
}

std::string set_line(const std::string& path, std::string_view field, const std::string& json) {
    return fmt::format("set {} {} {}", word(path), field, word(json));
}

std::string json_number(double value) {
    return number(value);  // "inf" where it has no end
}

std::string json_text(std::string_view text) {
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string json_vector(const vec3& v) {
    return fmt::format("[{},{},{}]", number(v.x), number(v.y), number(v.z));
}

}  // namespace lanthorn::edit_window

// The commands that panels give, as text: one place that knows how they are spelled.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lanthorn/scene/scene_data.h"

namespace lanthorn::edit_window {

std::string move_line(const std::string& path, const dvec3& translation);
std::string turn_line(const std::string& path, const quat& rotation);
std::string scale_line(const std::string& path, const vec3& scale);
// What of `to` differs from `from`.
std::vector<std::string> transform_lines(const std::string& path, const Transform& from, const Transform& to);
// A field by its component's and its own name, and a value as the command `set` takes it: JSON, or 800lm.
std::string set_line(const std::string& path, std::string_view field, const std::string& json);
std::string json_number(double value);
std::string json_text(std::string_view text);
std::string json_vector(const vec3& v);

}  // namespace lanthorn::edit_window

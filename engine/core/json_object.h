// Text that is to be one JSON object: settings, options, keys; and how deep any JSON may nest.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

namespace lanthorn {

// Valid files need about 10 levels; what copies, compares or prints JSON recurses, and would end the program
// on a deep file.
inline constexpr int kDeepestJson = 64;

// The byte at which `text` nests deeper than kDeepestJson; none: nowhere. O(bytes).
std::optional<std::size_t> nests_too_deep(std::string_view text);

// Throws InputError with `source` and "`place` N", where N is that byte.
void check_nesting(std::string_view text, std::string_view source, std::string_view place);

// Throws InputError with `source`: the byte at which the text is not JSON or nests too deep, or what was
// found instead of an object of `what`. O(bytes).
nlohmann::json parse_json_object(std::string_view text, std::string_view source, std::string_view what);

}  // namespace lanthorn

// The one door through which JSON comes in: settings, options, keys, glTF, extras, recordings, saves. All of
// it has the same bounds, and what is wrong is one line "SOURCE: JSON line L, column C: PROBLEM".
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

namespace lanthorn {

// Valid files need about 10 levels; what copies, compares or prints JSON recurses, and would end the program
// on a deep file.
inline constexpr int kDeepestJson = 64;

// One JSON value (RFC 8259); a byte order mark before it is passed over. Throws InputError with `source` and
// the place: for what is not JSON, nests deeper than kDeepestJson, has a number beyond the range of a double
// or text that is not UTF-8. O(bytes).
nlohmann::json parse_json(std::string_view text, std::string_view source);
// The same, but objects keep their members in the order of the text.
nlohmann::ordered_json parse_ordered_json(std::string_view text, std::string_view source);

// The same, which must be an object of `what`.
nlohmann::json parse_json_object(std::string_view text, std::string_view source, std::string_view what);

// Nothing where parse_ordered_json() throws.
std::optional<nlohmann::ordered_json> json_if_valid(std::string_view text);

}  // namespace lanthorn

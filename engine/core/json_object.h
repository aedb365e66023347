// Text that is to be one JSON object: settings, options, keys.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

namespace lanthorn {

// Throws InputError with `source`: the byte at which the text is not JSON, or what was found instead of an
// object of `what`. O(bytes).
nlohmann::json parse_json_object(std::string_view text, std::string_view source, std::string_view what);

}  // namespace lanthorn

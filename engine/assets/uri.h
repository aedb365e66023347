// URIs as glTF uses them: data: with base64, and relative paths with percent escapes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lanthorn {

// True for "data:...".
bool is_data_uri(std::string_view uri);

// True for "http:", "file:" and the like: anything with a scheme that is not "data".
bool has_foreign_scheme(std::string_view uri);

// The bytes of a base64 data URI; nothing if it is not one or its base64 is broken. Any media type.
std::optional<std::vector<std::uint8_t>> decode_data_uri(std::string_view uri);

// "data:application/octet-stream;base64,..." of the bytes (RFC 4648, 4).
std::string data_uri(std::string_view bytes);

// "a%20b" to "a b". An escape that is not two hexadecimal digits is left as it stands.
std::string percent_decoded(std::string_view uri);

// The other way, for a relative path: what RFC 3986 does not allow in one is escaped, but not bytes of UTF-8.
std::string percent_encoded(std::string_view path);

}  // namespace lanthorn

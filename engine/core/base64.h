// Bytes as text, for files that hold no bytes.
#pragma once

#include <string>
#include <string_view>

namespace lanthorn {

// RFC 4648, section 4, with its padding.
std::string base64(std::string_view bytes);

}  // namespace lanthorn

#pragma once

#include <string>

#include "lanthorn/core/math.h"

namespace lanthorn::tools {

// The value of --size: "WIDTHxHEIGHT" in pixels. Throws InputError for anything else.
ivec2 parse_size(const std::string& text);

}  // namespace lanthorn::tools

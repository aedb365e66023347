// What people type on a command line: one of several things by name or number, a picture's size, a seed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "lanthorn/core/math.h"

namespace lanthorn {

// The first of `names` that is `wanted`, else the one whose number (from 0) it is; nothing if no name
// matches.
std::optional<std::size_t> find_by_name_or_number(std::span<const std::string> names,
                                                  const std::string& wanted);

// "0 'front', 1 'door'": for an error that says what there is. Empty without names.
std::string numbered_names(std::span<const std::string> names);

inline constexpr int kLargestPicture = 16384;  // pixels a side

// A size in pixels, "WIDTHxHEIGHT", each side from `smallest` to `largest`. Throws InputError that begins
// with `option`.
ivec2 parse_size(const std::string& option, const std::string& text, int smallest, int largest);

// A whole number from 0 to the largest of 64 bits, in decimal. Throws InputError that begins with `option`.
std::uint64_t parse_whole(const std::string& option, const std::string& text);

}  // namespace lanthorn

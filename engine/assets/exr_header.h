// Whether the headers of an OpenEXR file are what they say, before its library reads them.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace lanthorn {

// The library makes room for what an attribute states before it looks for it, and of attributes of a known
// type reads as much as the type takes, whatever size the file gives them: a few bytes could ask for
// gigabytes. Returns what is wrong, one line; empty where nothing is. File layout: openexr.com, "OpenEXR File
// Layout", version 2.
std::string problem_of_exr_headers(std::span<const std::uint8_t> bytes);

}  // namespace lanthorn

// What makes the levels' rooms look lived in. None of it has a collider of its own but the shelf.
#pragma once

#include <string>

#include "tools/scene_generator/level_finishes.h"

namespace lanthorn::scene_generator {

// A carpet with a pattern of `field` and `figure` (sRGB) and a hem, from `low` to `high`.
struct CarpetColours {
    dvec3 field, ground, figure;
    vec3 hem;  // linear
};
inline constexpr CarpetColours kRedCarpet{
    {0.5, 0.12, 0.1}, {0.32, 0.07, 0.09}, {0.75, 0.58, 0.3}, {0.45f, 0.28f, 0.09f}};
inline constexpr CarpetColours kBlueCarpet{
    {0.2, 0.26, 0.36}, {0.12, 0.15, 0.24}, {0.66, 0.6, 0.46}, {0.2f, 0.17f, 0.1f}};
void add_carpet(Builder& b, const std::string& name, const dvec3& low, const dvec3& high,
                const CarpetColours& colours);

// A case of boards as shelf_parts() has it, at `foot`, with books on most boards; `seed`: which.
void add_bookshelf(Builder& b, const Finishes& f, const std::string& name, const dvec3& foot,
                   const dvec3& size, int levels, std::uint64_t seed);

// A jug of glazed clay that stands on `foot`, 0.24 m high, and two books beside it, towards +X.
void add_still_life(Builder& b, const std::string& name, const dvec3& foot);

}  // namespace lanthorn::scene_generator

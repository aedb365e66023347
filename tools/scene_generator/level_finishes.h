// What the game's levels are made of: matte materials with generated textures and normal maps, in metres.
#pragma once

#include <functional>

#include "tools/scene_generator/builder.h"

namespace lanthorn::scene_generator {

// A square normal map that repeats, `pixels` a side, for a material whose texture() is `metres` a side.
// height(x, y): metres, of a place in it, 0 to 1. Right on the flat faces of boxes alone.
void relief(Builder& b, std::uint32_t material, int pixels, double metres,
            const std::function<double(double, double)>& height);

struct Finishes {
    std::uint32_t ashlar;   // pale blocks of stone
    std::uint32_t flags;    // a floor of stone slabs
    std::uint32_t plaster;  // uneven lime plaster
    std::uint32_t oak;      // dark boards with grain
    std::uint32_t iron;     // nearly black
    std::uint32_t brass;    // a warm dull yellow
    std::uint32_t trim;     // smooth stone of mouldings
    std::uint32_t slate;    // dark, behind what is to stand out
};
// Uneven lime plaster of another colour, `mean` its linear reflectance.
std::uint32_t painted_plaster(Builder& b, const std::string& name, const vec3& mean);
// The blocks of ashlar under a coat of paint.
std::uint32_t painted_stone(Builder& b, const std::string& name, const vec3& mean);

// `stone`: linear reflectance of the blocks, about its mean.
Finishes finishes(Builder& b, const vec3& stone = {0.4f, 0.36f, 0.31f});

}  // namespace lanthorn::scene_generator

// Integers that an accessor does not mark as `normalized`, though glTF has them so: what they mean.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/assets/gltf_accessor.h"

namespace lanthorn {

inline constexpr const char* kReadAsFractions =
    "integers that are not 'normalized', as glTF has them here; read as fractions";

// Up to where plain integers are taken for the numbers that they are.
enum class NumbersUpTo {
    one,         // of what is never more: colours
    a_sixteenth  // of the type's range, 15 of bytes: repeated textures, weights of morph targets
};

// Whether the integers of accessor `index`, 8 or 16 bits and not normalised, are fractions of the largest of
// their type: so where some are beyond what they could be as numbers. False for other accessors. O(count).
bool are_fractions(const GltfContext& context, std::size_t index, NumbersUpTo limit);

// How to read them, with a warning at `place` where it is as fractions.
Integers integers_of(const GltfContext& context, std::size_t index, NumbersUpTo limit,
                     const std::string& place);

}  // namespace lanthorn

#include "engine/assets/gltf_integers.h"

#include <algorithm>
#include <cmath>

#include "engine/assets/gltf_format.h"

namespace lanthorn {

namespace {

// What 1 is of normalised integers; 0 of types that are none.
float largest_of(std::uint64_t type) {
    switch (type) {
        case kByte:
            return 127;
        case kUnsignedByte:
            return 255;
        case kShort:
            return 32767;
        case kUnsignedShort:
            return 65535;
        default:
            return 0;
    }
}

}  // namespace

bool are_fractions(const GltfContext& context, std::size_t index, NumbersUpTo limit) {
    const tinygltf::Accessor& accessor = context.model.accessors[index];
    const float one = largest_of(static_cast<std::uint64_t>(accessor.componentType));
    if (one == 0 || accessor.normalized) {
        return false;
    }
    const float most = limit == NumbersUpTo::one ? 1.0f : one / 16;
    const auto components =
        static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
    return std::ranges::any_of(read_floats(context, index, components),
                               [&](float value) { return std::abs(value) > most; });
}

Integers integers_of(const GltfContext& context, std::size_t index, NumbersUpTo limit,
                     const std::string& place) {
    if (!are_fractions(context, index, limit)) {
        return Integers::as_stated;
    }
    context.warn(place, kReadAsFractions);
    return Integers::fractions;
}

}  // namespace lanthorn

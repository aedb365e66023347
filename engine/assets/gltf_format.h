// Numbers of the glTF 2.0 format (Khronos specification, 3.6.2 and 5.1).
#pragma once

#include <cstdint>
#include <string_view>

namespace lanthorn {

inline constexpr std::uint64_t kByte = 5120;
inline constexpr std::uint64_t kUnsignedByte = 5121;
inline constexpr std::uint64_t kShort = 5122;
inline constexpr std::uint64_t kUnsignedShort = 5123;
inline constexpr std::uint64_t kUnsignedInt = 5125;
inline constexpr std::uint64_t kFloat = 5126;

// Elements that an accessor without a buffer view may have; such a one is all zeros, so only memory limits
// it.
inline constexpr std::uint64_t kMaxZeroElements = std::uint64_t{1} << 22;

// Bytes of one component. 0 for an unknown type.
constexpr std::uint64_t component_size(std::uint64_t component_type) {
    switch (component_type) {
        case kByte:
        case kUnsignedByte:
            return 1;
        case kShort:
        case kUnsignedShort:
            return 2;
        case kUnsignedInt:
        case kFloat:
            return 4;
        default:
            return 0;
    }
}

// Components of "SCALAR", "VEC2", ... 0 for an unknown type.
constexpr std::uint64_t component_count(std::string_view type) {
    if (type == "SCALAR") {
        return 1;
    }
    if (type.size() != 4 || type[3] < '2' || type[3] > '4') {
        return 0;
    }
    const auto n = static_cast<std::uint64_t>(type[3] - '0');
    return type.starts_with("VEC") ? n : type.starts_with("MAT") ? n * n : 0;
}

// Bytes of one element; matrix columns start on multiples of 4 bytes (3.6.2.4).
constexpr std::uint64_t element_size(std::uint64_t component_type, std::string_view type) {
    const std::uint64_t size = component_size(component_type);
    if (type.starts_with("MAT")) {
        const auto n = static_cast<std::uint64_t>(type[3] - '0');
        return n * ((n * size + 3) / 4 * 4);
    }
    return size * component_count(type);
}

}  // namespace lanthorn

// Little-endian numbers, as glTF buffers hold them.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>

namespace lanthorn {

inline void append_u16(std::string& out, std::uint16_t value) {
    out.push_back(static_cast<char>(value));
    out.push_back(static_cast<char>(value >> 8));
}

inline void append_u32(std::string& out, std::uint32_t value) {
    append_u16(out, static_cast<std::uint16_t>(value));
    append_u16(out, static_cast<std::uint16_t>(value >> 16));
}

// -0 as 0, so that equal numbers have equal bytes.
inline void append_f32(std::string& out, float value) {
    const float plain = value == 0 ? 0.0f : value;
    std::uint32_t bits;
    std::memcpy(&bits, &plain, sizeof bits);
    append_u32(out, bits);
}

// The components of a vector, one after the other.
template <typename V>
void append_vector(std::string& out, const V& v) {
    for (int i = 0; i < static_cast<int>(v.length()); ++i) {
        append_f32(out, v[i]);
    }
}

}  // namespace lanthorn

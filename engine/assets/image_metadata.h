// What the readers and writers of float images share.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "lanthorn/core/image.h"

namespace lanthorn {

inline constexpr std::string_view kMetadataPrefix = "lanthorn:";

// The name that a file has for `key` of ImageF::metadata.
inline std::string metadata_name(std::string_view key) {
    return std::string(kMetadataPrefix) + std::string(key);
}

// Puts a text of a file into the metadata if it was such a name's.
inline void keep_metadata(ImageF& image, std::string_view name, std::string_view text) {
    if (name.starts_with(kMetadataPrefix)) {
        image.metadata[std::string(name.substr(kMetadataPrefix.size()))] = text;
    }
}

// The nearest of 8 bits; NaN becomes 0.
inline std::uint8_t byte_of(float value) {
    return static_cast<std::uint8_t>(std::lround((value > 0 ? std::min(value, 1.0f) : 0.0f) * 255));
}

// Of a library's message.
inline std::string first_line(std::string text) {
    text.erase(std::min(text.find_first_of("\r\n"), text.size()));
    return text.empty() ? "unknown reason" : text;
}

}  // namespace lanthorn

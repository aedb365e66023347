#include "lanthorn/core/printable.h"

#include <fmt/format.h>

#include <cstdint>

namespace lanthorn {

namespace {

std::uint32_t byte_at(std::string_view text, std::size_t at) {
    return static_cast<unsigned char>(text[at]);
}

// Of a whole character of `size` bytes.
std::uint32_t code_point(std::string_view text, std::size_t at, std::size_t size) {
    if (size == 1) {
        return byte_at(text, at);
    }
    std::uint32_t code = byte_at(text, at) & (0x7fu >> size);
    for (std::size_t i = 1; i < size; ++i) {
        code = code << 6 | (byte_at(text, at + i) & 0x3f);
    }
    return code;
}

bool turns_text(std::uint32_t code) {
    return code == 0x200e || code == 0x200f || (code >= 0x202a && code <= 0x202e) ||
           (code >= 0x2066 && code <= 0x2069);
}

std::string escaped(std::uint32_t code) {
    switch (code) {
        case '\n':
            return "\\n";
        case '\r':
            return "\\r";
        case '\t':
            return "\\t";
        default:
            return code < 0x100 ? fmt::format("\\x{:02x}", code) : fmt::format("\\u{:04x}", code);
    }
}

}  // namespace

std::size_t utf8_character(std::string_view text, std::size_t at) {
    const std::uint32_t first = byte_at(text, at);
    const std::size_t size = first < 0x80   ? 1
                             : first < 0xc2 ? 0
                             : first < 0xe0 ? 2
                             : first < 0xf0 ? 3
                             : first < 0xf5 ? 4
                                            : 0;
    if (size == 0 || size > text.size() - at) {
        return 0;
    }
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte_at(text, at + i) & 0xc0) != 0x80) {
            return 0;
        }
    }
    const std::uint32_t code = code_point(text, at, size);
    const bool is_overlong = (size == 3 && code < 0x800) || (size == 4 && code < 0x10000);
    const bool is_surrogate = code >= 0xd800 && code < 0xe000;
    return is_overlong || is_surrogate || code > 0x10ffff ? 0 : size;
}

std::string printable(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t size = utf8_character(text, at);
        const std::uint32_t code = size == 0 ? byte_at(text, at) : code_point(text, at, size);
        const bool is_control = code < 0x20 || (code >= 0x7f && code < 0xa0) || turns_text(code);
        if (size == 0 || is_control) {
            result += escaped(code);
        } else {
            result += text.substr(at, size);
        }
        at += size == 0 ? 1 : size;
    }
    return result;
}

std::string markup_text(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t size = utf8_character(text, at);
        const char c = text[at];
        if (size == 0 || (byte_at(text, at) < 0x20 && c != '\n' && c != '\t')) {
            result += '?';
        } else {
            result += c == '&'    ? "&amp;"
                      : c == '<'  ? "&lt;"
                      : c == '>'  ? "&gt;"
                      : c == '"'  ? "&quot;"
                      : c == '\'' ? "&#39;"
                                  : text.substr(at, size);
        }
        at += size == 0 ? 1 : size;
    }
    return result;
}

std::string shortened(std::string_view text, std::size_t most) {
    if (text.size() <= most) {
        return std::string(text);
    }
    std::size_t end = most - 3;
    while (end > 0 && (byte_at(text, end) & 0xc0) == 0x80) {
        --end;
    }
    return std::string(text.substr(0, end)) + "...";
}

std::string shortened_front(std::string_view text, std::size_t most) {
    if (text.size() <= most) {
        return std::string(text);
    }
    std::size_t start = text.size() - (most - 3);
    while (start < text.size() && (byte_at(text, start) & 0xc0) == 0x80) {
        ++start;
    }
    return "..." + std::string(text.substr(start));
}

}  // namespace lanthorn

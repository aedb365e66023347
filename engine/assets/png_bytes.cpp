#include "engine/assets/png_bytes.h"

#include <algorithm>

namespace lanthorn {

namespace {

void append_big_endian(std::string& out, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) {
        out.push_back(static_cast<char>(value >> shift));
    }
}

std::uint32_t crc32(const std::string& bytes) {
    std::uint32_t crc = 0xffffffffu;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc >> 1) ^ ((crc & 1u) ? 0xedb88320u : 0u);
        }
    }
    return ~crc;
}

std::uint32_t adler32(const std::string& bytes) {
    std::uint32_t a = 1, b = 0;
    for (const char c : bytes) {
        a = (a + static_cast<unsigned char>(c)) % 65521u;
        b = (b + a) % 65521u;
    }
    return b << 16 | a;
}

void append_chunk(std::string& out, const std::string& type, const std::string& data) {
    append_big_endian(out, static_cast<std::uint32_t>(data.size()));
    out += type + data;
    append_big_endian(out, crc32(type + data));
}

std::string zlib_stored(const std::string& bytes) {
    constexpr std::size_t kMaxBlock = 65535;
    std::string out = "\x78\x01";
    for (std::size_t at = 0; at < bytes.size(); at += kMaxBlock) {
        const std::size_t size = std::min(kMaxBlock, bytes.size() - at);
        const bool last = at + size == bytes.size();
        out.push_back(last ? 1 : 0);
        for (const std::size_t value : {size, ~size}) {
            out.push_back(static_cast<char>(value));
            out.push_back(static_cast<char>(value >> 8));
        }
        out += bytes.substr(at, size);
    }
    append_big_endian(out, adler32(bytes));
    return out;
}

bool is_opaque(const Image& image) {
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
        if (image.rgba[i] != 255) {
            return false;
        }
    }
    return true;
}

}  // namespace

std::string png_bytes(const Image& image) {
    std::string header;
    append_big_endian(header, image.width);
    append_big_endian(header, image.height);
    const bool opaque = is_opaque(image);
    header += {8, opaque ? char{2} : char{6}, 0, 0,
               0};  // 8 bits, RGB or RGBA, deflate, adaptive filters, not interlaced

    std::string rows;
    for (std::uint32_t y = 0; y < image.height; ++y) {
        rows.push_back(0);  // filter: none
        for (std::uint32_t x = 0; x < image.width; ++x) {
            const auto* texel = &image.rgba[4 * (std::size_t(y) * image.width + x)];
            rows.append(reinterpret_cast<const char*>(texel), opaque ? 3 : 4);
        }
    }

    std::string out = "\x89PNG\r\n\x1a\n";
    append_chunk(out, "IHDR", header);
    append_chunk(out, "IDAT", zlib_stored(rows));
    append_chunk(out, "IEND", {});
    return out;
}

}  // namespace lanthorn

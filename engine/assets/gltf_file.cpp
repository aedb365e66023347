#include "engine/assets/gltf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <span>
#include <system_error>

#include "engine/core/json.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/printable.h"

namespace lanthorn {

namespace fs = std::filesystem;

namespace {

constexpr std::uint32_t kMagic = 0x46546c67;  // "glTF"

std::uint32_t u32_at(std::span<const std::uint8_t> bytes, std::size_t offset) {
    return std::uint32_t{bytes[offset]} | std::uint32_t{bytes[offset + 1]} << 8 |
           std::uint32_t{bytes[offset + 2]} << 16 | std::uint32_t{bytes[offset + 3]} << 24;
}

// Some exporters write null for what they have not; it says as little as nothing. Returns how many there
// were.
std::size_t erase_nulls(nlohmann::json& value) {
    std::size_t count = 0;
    if (value.is_object()) {
        for (auto it = value.begin(); it != value.end();) {
            const bool is_null = it->is_null();
            count += is_null ? 1 : it.key() == "extras" ? 0 : erase_nulls(*it);
            it = is_null ? value.erase(it) : std::next(it);
        }
    } else if (value.is_array()) {
        for (nlohmann::json& element : value) {
            count += erase_nulls(element);
        }
    }
    return count;
}

void take_json(GltfFile& file, std::string_view text) {
    file.json = parse_json(text, file.name);
    if (!file.json.is_object()) {
        file.refuse("/", fmt::format("found JSON {}, expected an object", file.json.type_name()));
    }
    if (const std::size_t nulls = erase_nulls(file.json); nulls > 0) {
        file.note("JSON", fmt::format("{} members are null; they are left out", nulls));
    }
}

// `text` with the bytes that are no UTF-8 taken for Latin-1, which older exporters write names in.
std::string mended_text(GltfFile& file, std::string_view text) {
    std::string mended;
    mended.reserve(text.size());
    std::size_t foreign = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t size = utf8_character(text, at);
        if (size > 0) {
            mended += text.substr(at, size);
        } else {
            const auto byte = static_cast<unsigned char>(text[at]);
            mended += {static_cast<char>(0xc0 | byte >> 6), static_cast<char>(0x80 | (byte & 0x3f))};
            ++foreign;
        }
        at += std::max<std::size_t>(size, 1);
    }
    if (foreign > 0) {
        file.note("JSON", fmt::format("{} bytes are no UTF-8; they are read as Latin-1", foreign));
    }
    return mended;
}

void read_json(GltfFile& file, std::span<const std::uint8_t> bytes, Keep keep) {
    const std::string text = mended_text(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    take_json(file, text);
    if (keep == Keep::source) {
        file.text = text;
    }
}

// After a byte order mark and white space.
bool begins_json(std::span<const std::uint8_t> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const std::size_t at = text.find_first_not_of(" \t\r\n\xef\xbb\xbf");
    return at != std::string_view::npos && text[at] == '{';
}

void read_glb(GltfFile& file, std::span<const std::uint8_t> bytes, Keep keep) {
    if (bytes.size() < 12) {
        file.refuse("GLB header",
                    fmt::format("found {} bytes, expected at least 12: the file is cut off", bytes.size()));
    }
    if (u32_at(bytes, 0) != kMagic) {
        file.refuse("GLB header", fmt::format("found magic 0x{:08x}, expected 0x{:08x} (\"glTF\")",
                                              u32_at(bytes, 0), kMagic));
    }
    if (u32_at(bytes, 4) != 2) {
        file.refuse("GLB header", fmt::format("found container version {}, expected 2", u32_at(bytes, 4)));
    }
    const std::size_t length = u32_at(bytes, 8);
    if (length > bytes.size()) {
        file.refuse("GLB header", fmt::format("found {} bytes, expected the declared {}: the file is cut off",
                                              bytes.size(), length));
    }
    bytes = bytes.first(length);
    bool has_json = false;
    for (std::size_t at = 12, number = 0; at < bytes.size(); ++number) {
        const std::string place = fmt::format("GLB chunk {}", number);
        if (bytes.size() - at < 8) {
            file.refuse(place, fmt::format("found {} bytes, expected a header of 8", bytes.size() - at));
        }
        const std::size_t size = u32_at(bytes, at);
        const std::uint32_t type = u32_at(bytes, at + 4);
        at += 8;
        if (size > bytes.size() - at) {
            file.refuse(place, fmt::format("found {} bytes, expected {}", bytes.size() - at, size));
        }
        const auto content = bytes.subspan(at, size);
        at += size;
        if (number == 0) {
            if (type != kJsonChunk) {
                file.refuse(place, fmt::format("found type 0x{:08x}, expected 0x{:08x} (\"JSON\")", type,
                                               kJsonChunk));
            }
            has_json = true;
            read_json(file, content, keep);
        } else if (type == kJsonChunk || (type == kBinChunk && file.chunk)) {
            file.refuse(place, fmt::format("found a second chunk of type 0x{:08x}", type));
        } else if (type == kBinChunk) {
            file.chunk.emplace(content.begin(), content.end());
        } else if (keep == Keep::source) {  // else ignored, as glTF 2.0, 4.4.3, asks
            file.other_chunks.push_back({type, {content.begin(), content.end()}});
        }
    }
    if (!has_json) {
        file.refuse("GLB chunk 0", "found the end of the file, expected the JSON chunk");
    }
}

}  // namespace

void GltfFile::refuse(std::string_view place, std::string_view problem) const {
    throw InputError(name, place, problem);
}

void GltfFile::note(std::string_view place, std::string_view text) {
    notes.push_back(printable(fmt::format("{}: {}", place, text)));
}

std::vector<std::uint8_t> read_bytes(const fs::path& path, std::string_view name, std::string_view place) {
    const std::string shown = printable(path.string());
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) {
        throw InputError(name, place, fmt::format("found no file '{}'", shown));
    }
    if (!fs::is_regular_file(status)) {
        throw InputError(name, place, fmt::format("'{}' is not a regular file", shown));
    }
    std::ifstream stream(path, std::ios::binary);
    const std::uintmax_t size = fs::file_size(path, error);
    if (!stream || error) {
        throw InputError(name, place, fmt::format("'{}' cannot be read: {}", shown, std::strerror(errno)));
    }
    std::vector<std::uint8_t> bytes(size);
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (static_cast<std::uintmax_t>(stream.gcount()) != size) {
        throw InputError(name, place, fmt::format("'{}' cannot be read to its end", shown));
    }
    return bytes;
}

GltfFile read_gltf_file(const fs::path& path, Keep keep) {
    GltfFile file;
    file.name = path.string();
    file.folder = path.parent_path();
    const std::vector<std::uint8_t> bytes = read_bytes(path, file.name, "");
    const bool has_magic = bytes.size() >= 4 && u32_at(bytes, 0) == kMagic;
    if (!has_magic && path.extension() == ".glb" && begins_json(bytes)) {
        file.note("GLB header", "found JSON, as in a .gltf; it is read as such");
        read_json(file, bytes, keep);
    } else if (has_magic || path.extension() == ".glb") {
        file.is_glb = true;
        read_glb(file, bytes, keep);
    } else {
        read_json(file, bytes, keep);
    }
    return file;
}

}  // namespace lanthorn

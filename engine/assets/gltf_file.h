// A glTF file as read from disk: the container opened, the JSON parsed, nothing interpreted yet.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lanthorn {

struct GltfFile {
    std::string name;              // as the user wrote it, for messages
    std::filesystem::path folder;  // relative URIs start here
    nlohmann::json json;           // an object
    bool is_glb = false;
    std::optional<std::vector<std::uint8_t>> chunk;  // the BIN chunk of a .glb

    // For who writes the file again; with Keep::source alone.
    struct Chunk {
        std::uint32_t type = 0;
        std::vector<std::uint8_t> bytes;
    };
    std::string text;                 // the JSON as it stands in the file, with what is around its root
    std::vector<Chunk> other_chunks;  // of a .glb, of types that glTF does not know

    // Throws InputError "NAME: PLACE: PROBLEM". PLACE is a JSON pointer or a place in the container.
    [[noreturn]] void refuse(std::string_view place, std::string_view problem) const;
};

enum class Keep { meaning, source };

// Reads .gltf or .glb (told apart by content). Throws InputError for a missing or unreadable file, a broken
// container, broken JSON, or JSON nested deeper than 64.
GltfFile read_gltf_file(const std::filesystem::path& path, Keep keep = Keep::meaning);

// `text` with control characters replaced by spaces, so that names and numbers of a file can be quoted in a
// line.
std::string one_line(std::string_view text);

// All bytes of a regular file. Throws InputError(NAME, PLACE) if it cannot be read.
std::vector<std::uint8_t> read_bytes(const std::filesystem::path& path, std::string_view name,
                                     std::string_view place);

}  // namespace lanthorn

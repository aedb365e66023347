// A glTF file as read from disk: the container opened, the JSON parsed, nothing interpreted yet.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/assets/uri_file.h"
#include "lanthorn/assets/import_budget.h"

namespace lanthorn {

// Types of a .glb's chunks.
inline constexpr std::uint32_t kJsonChunk = 0x4e4f534a;  // "JSON"
inline constexpr std::uint32_t kBinChunk = 0x004e4942;   // "BIN"

// The end of a range that has none: numbers are read as floats.
inline constexpr double kNoLimit = std::numeric_limits<float>::max();

struct GltfFile {
    std::string name;              // as the user wrote it, for messages
    std::filesystem::path folder;  // relative URIs start here
    nlohmann::json json;           // an object
    bool is_glb = false;
    std::optional<std::vector<std::uint8_t>> chunk;  // the BIN chunk of a .glb
    bool allow_outside = false;                      // whether files outside of `folder` may be read
    std::shared_ptr<FolderNames> folders = std::make_shared<FolderNames>();  // that are read for such files
    ImportBudget left;  // what it may still make of itself
    // Images, by index, whose alpha is read as glossiness, and what that is multiplied by
    // (restate_extensions()).
    std::map<std::size_t, double> glossiness;
    std::vector<std::string> notes;  // what was mended: "PLACE: WHAT WAS FOUND; WHAT WAS DONE"

    // For who writes the file again; with Keep::source alone.
    struct Chunk {
        std::uint32_t type = 0;
        std::vector<std::uint8_t> bytes;
    };
    std::string text;                 // the JSON as it stands in the file, with what is around its root
    std::vector<Chunk> other_chunks;  // of a .glb, of types that glTF does not know

    // Throws InputError "NAME: PLACE: PROBLEM". PLACE is a JSON pointer or a place in the container.
    [[noreturn]] void refuse(std::string_view place, std::string_view problem) const;
    void note(std::string_view place, std::string_view text);
};

enum class Keep { meaning, source };

// Reads .gltf or .glb (told apart by content: JSON may be in a file named .glb). Bytes of the JSON that are
// no UTF-8 are taken for Latin-1, with a note. Throws InputError for a missing or unreadable file, a broken
// container, broken JSON, or JSON nested deeper than 64.
GltfFile read_gltf_file(const std::filesystem::path& path, Keep keep = Keep::meaning);

// All bytes of a regular file. Throws InputError(NAME, PLACE) if it cannot be read.
std::vector<std::uint8_t> read_bytes(const std::filesystem::path& path, std::string_view name,
                                     std::string_view place);

}  // namespace lanthorn

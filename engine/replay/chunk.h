// A chunk of a recording's file: what it is, its bytes, compressed or not, and the hashes that say whether
// they are whole (docs/replay-format.md).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "engine/replay/byte_stream.h"

namespace lanthorn::replay {

// Four letters, as a number.
enum class ChunkKind : std::uint32_t {};
constexpr ChunkKind chunk_kind(const char (&letters)[5]) {
    std::uint32_t number = 0;
    for (int i = 3; i >= 0; --i) {
        number = number << 8 | static_cast<unsigned char>(letters[i]);
    }
    return static_cast<ChunkKind>(number);
}
// A recording begins with its head, has its steps in pieces, and ends with what says that it is whole.
inline constexpr ChunkKind kHead = chunk_kind("HEAD");
inline constexpr ChunkKind kSteps = chunk_kind("STEP");
inline constexpr ChunkKind kDone = chunk_kind("DONE");
// "SNAP"; what is no printable letter as '?'.
std::string letters_of(ChunkKind kind);

enum class Packing {
    plain,  // while a session runs
    zstd,   // where that is smaller
};

struct Chunk {
    ChunkKind kind{};
    bool optional = false;  // who does not know the kind may pass over it
    std::size_t begin = 0;  // of the body, in the file
    std::string body;       // unpacked
};

// Bytes of a body, unpacked. Less than what is stored times kMostExpansion and kFreeExpansion: no bomb.
inline constexpr std::uint32_t kMostBody = 16u << 20;
inline constexpr std::uint64_t kMostExpansion = 16;
inline constexpr std::uint64_t kFreeExpansion = 512;

// A body of more than kMostBody is a broken invariant.
std::string encoded_chunk(ChunkKind kind, std::string_view body, Packing packing, bool optional = false);

// Throws EndsHere where the chunk is not whole, InputError where it is damaged.
Chunk read_chunk(Reader& reader);

}  // namespace lanthorn::replay

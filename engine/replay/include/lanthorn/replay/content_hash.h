// Hashes of bytes and files: which level a recording was made in, and whether its chunks are whole. Hashes of
// a world's state are lanthorn/ecs/world_hash.h's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace lanthorn::replay {

// xxHash (XXH3, 64 bits).
std::uint64_t hash_bytes(std::span<const std::byte> bytes);

// The hash of a file's bytes. Throws InputError if it cannot be read.
std::uint64_t hash_file(const std::string& path);

}  // namespace lanthorn::replay

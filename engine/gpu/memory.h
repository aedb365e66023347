// Bytes of GPU storage that our buffers and textures hold; what `--stats` states as gpu_mb.
#pragma once

#include <cstddef>

namespace lanthorn::gpu {

// Process-wide, all contexts together. O(1).
std::size_t allocated_bytes();

// Used by Buffer and Texture alone: signed change in bytes.
void account(std::ptrdiff_t bytes);

}  // namespace lanthorn::gpu

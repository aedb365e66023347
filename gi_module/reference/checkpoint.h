// A path tracer's sums in a file, with a checksum. Native byte order: a checkpoint is for the machine that
// wrote it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "gi_module/reference/film.h"

namespace lanthorn::reference {

struct CheckpointHeader {
    std::uint64_t sample_hash = 0;  // scene_hash.h
    std::uint32_t width = 0, height = 0;
    std::uint32_t spp = 0;
    std::uint32_t films = 0;  // bit i: the i-th film is there
    std::uint64_t nan_count = 0;
};

// Whole or not at all. Throws InputError if `path` cannot be written.
void write_checkpoint(const std::filesystem::path& path, const CheckpointHeader& header,
                      std::span<const Film> films);

// Fills the films and returns the header. Throws InputError, the films untouched, unless the file is whole
// and agrees with `expected` in everything but spp and nan_count.
CheckpointHeader read_checkpoint(const std::filesystem::path& path, const CheckpointHeader& expected,
                                 std::span<Film> films);

}  // namespace lanthorn::reference

// A path tracer's sums in a file, with a checksum: of a whole picture, or of some rows. Native byte order:
// for machines like the one that wrote it.
#pragma once

#include <cstddef>
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
    std::uint32_t first = 0;          // number of the first sample
    std::uint32_t top = 0, rows = 0;  // that are in the file
    std::uint32_t reserved = 0;       // no padding

    std::size_t begin() const { return std::size_t{top} * width; }    // pixels
    std::size_t pixels() const { return std::size_t{rows} * width; }  // in the file
};

// The header's rows of films of the whole picture. Whole or not at all. Throws InputError if `path` cannot be
// written.
void write_checkpoint(const std::filesystem::path& path, const CheckpointHeader& header,
                      std::span<const Film> films);

// Fills these rows of the films and returns the header. Throws InputError, the films untouched, unless the
// file is whole and agrees with `expected` in everything but spp and nan_count.
CheckpointHeader read_checkpoint(const std::filesystem::path& path, const CheckpointHeader& expected,
                                 std::span<Film> films);

}  // namespace lanthorn::reference

// What `coarse-path` counts in a frame: a part of its GiStatistics.
#pragma once

#include <cstdint>

namespace lanthorn::gi {

struct CoarseStatistics {
    std::uint64_t points = 0;        // that show a surface
    std::uint64_t extra_points = 0;  // of them: off the lattice
    std::uint64_t samples = 0;       // paths of this frame
    std::uint64_t rays = 0;          // of these, shadow rays included
    double history = 0;              // samples behind a point, on average
    std::uint64_t new_points = 0;    // of `points`: nothing was known of them from the frame before
    std::uint64_t builds = 0;        // of the whole acceleration structure so far
};

}  // namespace lanthorn::gi

// What `path` counts: a part of its GiStatistics.
#pragma once

#include <cstdint>

namespace lanthorn::gi {

struct PathStatistics {
    int spp = 0;               // samples a pixel that the picture is the mean of
    int wanted_spp = 0;        // path.spp
    int frame_spp = 0;         // of `spp`: added by the last frame
    double noise = 0;          // of the picture, as its two halves tell (reference/film.h); in reports alone
    std::uint64_t builds = 0;  // of the whole acceleration structure so far
};

}  // namespace lanthorn::gi

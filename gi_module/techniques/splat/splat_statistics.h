// What `splat` counts: a part of its GiStatistics.
#pragma once

#include <cstdint>
#include <string>

namespace lanthorn::gi {

struct SplatStatistics {
    std::uint64_t walks = 0;            // of light that the photons come from
    std::uint64_t photons = 0;          // of indirect light that are kept
    std::uint64_t caustic_photons = 0;  // of them
    std::uint64_t rays = 0;             // that it took
    std::uint64_t surfaces = 0;
    std::uint64_t splatted = 0;     // in the picture, over all rounds; 0: the picture was kept
    std::uint64_t mirror_rays = 0;  // of pixels that mirror or are looked through, in this frame
    int rounds = 0;                 // of bandwidths
    std::uint64_t memory = 0;       // bytes of photons, at most so far
    std::uint64_t on_disk = 0;      // bytes
    std::uint64_t builds = 0;       // of the whole acceleration structure so far
    std::string error;              // why there are no more photons; empty: there is none
};

}  // namespace lanthorn::gi

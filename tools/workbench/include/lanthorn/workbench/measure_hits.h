// Image-space hits of photons against exact rays.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "lanthorn/workbench/photon_flights.h"

namespace lanthorn::workbench {

// A hit agrees if it lies within this share of the scene's diagonal of the exact one.
inline constexpr double kHitTolerance = 0.02;

// Upper ends of the histogram's bins, in shares of the diagonal; the last has none.
inline constexpr std::array<double, 7> kHitBins = {0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2};

// The flights of one bounce. A photon that has left through an opening, by image and by exact ray, has met
// nothing to agree on: it counts as `left` alone.
struct HitCounts {
    std::uint64_t segments = 0;  // those that meet a surface, by image or by exact ray
    std::uint64_t agree = 0;     // both do, within kHitTolerance
    std::uint64_t near = 0;      // both do, the image's too near
    std::uint64_t far = 0;       // both do, the image's too far
    std::uint64_t missed = 0;    // by exact ray alone
    std::uint64_t invented = 0;  // by image alone
    std::uint64_t left = 0;      // neither
    // Distance between the two hits, of those that both have; apart for image hits before and behind.
    std::array<std::uint64_t, kHitBins.size() + 1> before{}, behind{};

    // `n` over the segments, 0 where there are none.
    double share(std::uint64_t n) const {
        return segments > 0 ? static_cast<double>(n) / static_cast<double>(segments) : 0;
    }
    HitCounts& operator+=(const HitCounts& other);
};

// By bounce. `done` is told how many flights of all have been looked at. One exact ray a flight.
std::vector<HitCounts> measure_hits(const PhotonFlights& flights,
                                    const std::function<void(std::uint64_t)>& done);

}  // namespace lanthorn::workbench

// How much of what photons can reach the environment maps see, by exact rays.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "lanthorn/workbench/photon_flights.h"

namespace lanthorn::workbench {

// Shares that choices at random cover.
struct RandomCoverage {
    double mean = 0, deviation = 0, least = 0, most = 0;
};

// How much of the surface that light reaches the selected maps see.
struct CoverageFigures {
    int points = 0;                    // spread evenly over all surfaces that photons are stored on
    int reached = 0;                   // of them, those that light reaches after 1 to gi.bounces reflections
    double area = 0;                   // m^2 of those surfaces; both sides of double-sided ones
    double reached_area = 0;           // m^2, estimated
    double coverage = 0;               // share of the reached area that at least one selected map sees
    double standard_error = 0;         // of coverage
    std::vector<double> seen_by_map;   // share of the reached area, by map
    std::vector<double> alone_by_map;  // the same, of what no other map sees
    RandomCoverage random;  // of kRandomDraws choices of as many candidates (Yao et al. 2010, Fig. 3)
    double by_eq1 = 0;  // the technique's own figure: of what its candidates see, by eq. 1 of Yao et al. 2010
};

inline constexpr int kReachWalks = 256;  // random walks that look for light from a point
inline constexpr int kRandomDraws = 32;  // choices of candidates at random

// The figures of one frame's photons, by up to `points` points; `seed` is that of all random numbers. A point
// is reached if one of kReachWalks random walks from it along cosine-distributed directions comes to a
// surface that reflects and that a light shines on; a map sees it if its centre lies before the surface and
// nothing between. `done` is told how many points have been looked at. About 0.1 ms a point.
CoverageFigures measure_coverage(const PhotonFlights& flights, int points, std::uint32_t seed,
                                 const std::function<void(std::uint64_t)>& done);

}  // namespace lanthorn::workbench

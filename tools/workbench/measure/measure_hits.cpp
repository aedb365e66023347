#include "lanthorn/workbench/measure_hits.h"

#include <algorithm>

#include "tools/workbench/measure/measured_scene.h"

namespace lanthorn::workbench {

namespace {

HitCounts judge(const PhotonFlight& flight, const ExactSurfaces& surfaces, double diagonal) {
    HitCounts counts;
    const auto exact = surfaces.arrival(flight.origin, flight.direction);
    const bool stored = exact && exact->receives;
    if (!flight.arrived && !stored) {
        counts.left = 1;
        return counts;
    }
    counts.segments = 1;
    if (!flight.arrived) {
        counts.missed = 1;
        return counts;
    }
    if (!stored) {
        counts.invented = 1;
        return counts;
    }
    const double distance = glm::length(dvec3(flight.position) - dvec3(exact->hit.position)) / diagonal;
    const auto bin =
        static_cast<std::size_t>(std::ranges::upper_bound(kHitBins, distance) - kHitBins.begin());
    const bool behind = glm::length(flight.position - flight.origin) > exact->hit.t;
    (behind ? counts.behind : counts.before)[bin] = 1;
    (distance <= kHitTolerance ? counts.agree : behind ? counts.far : counts.near) = 1;
    return counts;
}

}  // namespace

HitCounts& HitCounts::operator+=(const HitCounts& other) {
    segments += other.segments;
    agree += other.agree;
    near += other.near;
    far += other.far;
    missed += other.missed;
    invented += other.invented;
    left += other.left;
    for (std::size_t i = 0; i < before.size(); ++i) {
        before[i] += other.before[i];
        behind[i] += other.behind[i];
    }
    return *this;
}

std::vector<HitCounts> measure_hits(const PhotonFlights& flights,
                                    const std::function<void(std::uint64_t)>& done) {
    const ExactSurfaces surfaces(flights.frame);
    const double diagonal = static_cast<double>(flights.frame.diagonal());
    std::vector<HitCounts> result;
    std::uint64_t looked_at = 0;
    for (const auto& bounce : flights.bounces) {
        HitCounts& counts = result.emplace_back();
        for (const PhotonFlight& flight : bounce) {
            counts += judge(flight, surfaces, diagonal);
            done(++looked_at);
        }
    }
    return result;
}

}  // namespace lanthorn::workbench

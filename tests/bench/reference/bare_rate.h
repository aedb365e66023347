// Embree's own rate over rays that were noted, which a tracer's is held against.
#pragma once

#include <cstdint>

#include "gi_module/reference/ray_log.h"
#include "tests/support/clocks.h"

namespace lanthorn::bench {

// Rays that a bare loop traces in a second of the processor's, one at a time; for `seconds` of them.
inline double bare_rate(const reference::RayLog& log, double seconds) {
    std::uint64_t rays = 0;
    const double start = support::processor_seconds();
    do {
        for (const reference::LoggedRay& logged : log.rays) {
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            if (logged.any_hit) {
                RTCRay ray = logged.ray;
                rtcOccluded1(log.scene, &context, &ray);
            } else {
                RTCRayHit query;
                query.ray = logged.ray;
                query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
                rtcIntersect1(log.scene, &context, &query);
            }
        }
        rays += log.rays.size();
    } while (support::processor_seconds() - start < seconds);
    return static_cast<double>(rays) / (support::processor_seconds() - start);
}

}  // namespace lanthorn::bench

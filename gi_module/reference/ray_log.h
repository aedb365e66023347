// The rays of a sample, as Embree was asked for them: to measure what tracing alone costs.
#pragma once

#include <embree3/rtcore.h>

#include <vector>

namespace lanthorn::reference {

struct LoggedRay {
    RTCRay ray;
    bool any_hit;  // asked of rtcOccluded1, else of rtcIntersect1
};

struct RayLog {
    RTCScene scene = nullptr;  // lives as long as the PathTracer
    std::vector<LoggedRay> rays;
};

}  // namespace lanthorn::reference

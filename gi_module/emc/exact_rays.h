// Rays that meet the scene's triangles themselves instead of its environment maps: gi.emc.rays = bvh. Who can
// trace them lives in a library of its own (lanthorn::coarse has Embree) and is made known here.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

struct ExactRay {
    vec3 origin{0};
    float unused0 = 0;
    vec3 direction{0};  // unit
    float unused1 = 0;
};

struct Arrival {
    float distance = 0;        // m; 0: nothing was met
    std::uint32_t normal = 0;  // unit, on the ray's side, octahedral in 2 x 16 bits as packSnorm2x16 has them
};

class ExactRays {
  public:
    virtual ~ExactRays() = default;
    // Becomes this frame's scene, by what its changes say. `scene` must stay as it is until the last trace()
    // of the frame. O(what changed); O(triangles log triangles) at first, and when instances come or go.
    virtual void follow(const FrameScene& scene) = 0;
    // The nearest surface on each ray; the same in any order and with any number of threads.
    virtual void trace(std::span<const ExactRay> rays, std::span<Arrival> arrivals) = 0;
};

using ExactRaysMaker = std::unique_ptr<ExactRays> (*)();
// Once, before any technique is made; not thread-safe.
void add_exact_rays(ExactRaysMaker maker);
// Null if this program has none.
std::unique_ptr<ExactRays> make_exact_rays();

}  // namespace lanthorn::gi

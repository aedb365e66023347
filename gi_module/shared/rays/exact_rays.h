// Rays that meet the scene's triangles themselves, for techniques that do not trace on the processor
// otherwise. Who can trace them lives in a library of its own (lanthorn::rays has Embree) and is made known
// here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "gi_module/shared/mirrors/specular_ray.h"
#include "gi_module/shared/rays/seen_triangles.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

struct ExactRay {
    vec3 origin{0};
    float unused0 = 0;
    vec3 direction{0};  // unit
    float unused1 = 0;
};
static_assert(sizeof(ExactRay) == 32 && offsetof(ExactRay, direction) == 16);

struct Arrival {
    float distance = 0;        // m; 0: nothing was met
    std::uint32_t normal = 0;  // unit, on the ray's side, octahedral in 2 x 16 bits as packSnorm2x16 has them
    std::uint32_t albedo = 0;  // of diffuse transport, red in the lowest of three bytes
    std::uint32_t unused = 0;
};
static_assert(sizeof(Arrival) == 16 && offsetof(Arrival, albedo) == 8);

struct CausticArrivals;
struct CausticPhoton;
struct CausticTargets;

// How finely rays meet what moves or deforms.
enum class RayDetail { full, coarser };

class ExactRays : public TriangleSight {
  public:
    // Becomes this frame's scene, by what its changes say. `scene` must stay as it is until the last trace()
    // of the frame. O(what changed); O(triangles log triangles) at first, and when instances come or go.
    virtual void follow(const FrameScene& scene, RayDetail detail) = 0;
    // The nearest surface on each ray; the same in any order and with any number of threads. `albedo`: finds
    // it, too; else it is 0.
    virtual void trace(std::span<const ExactRay> rays, std::span<Arrival> arrivals, bool albedo) = 0;
    // Follows each ray over mirrors and through glass until it meets what is neither (specular_chain.h). One
    // end a ray, in their order, then those that are found by `next`. The same with any number of threads.
    virtual std::vector<SpecularHit> trace(std::span<const SpecularRay> rays) = 0;
    // Follows each photon as caustic_chains.h says and returns where they arrive, in order of photons; radius
    // is not set. The same with any number of threads.
    virtual CausticArrivals trace_caustics(std::span<const CausticPhoton> photons,
                                           const CausticTargets& targets, int bounces,
                                           std::uint32_t seed) = 0;
};

using ExactRaysMaker = std::unique_ptr<ExactRays> (*)();
// Once, before any technique is made; not thread-safe.
void add_exact_rays(ExactRaysMaker maker);
bool has_exact_rays();
// Null if this program has none.
std::unique_ptr<ExactRays> make_exact_rays();

}  // namespace lanthorn::gi

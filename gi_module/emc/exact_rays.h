// Rays that meet the scene's triangles themselves instead of its environment maps: gi.emc.rays = bvh. Who can
// trace them lives in a library of its own (lanthorn::coarse has Embree) and is made known here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "lanthorn/gi/emc/caustic_photon.h"
#include "lanthorn/gi/emc/photon.h"
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
};
static_assert(sizeof(Arrival) == 8 && offsetof(Arrival, normal) == 4);

// A ray from what a pixel shows, towards what is mirrored there or seen through it.
struct SpecularRay {
    vec3 origin{0};
    std::uint32_t pixel = 0;  // y * width + x
    vec3 direction{0};        // unit
    // 1: it has yet to meet the surface of the pixel, right ahead, and goes through it. Plus 2 times 0 to 15:
    // which of 16 directions of a rough surface's lobe it takes.
    std::uint32_t through = 0;
};
static_assert(sizeof(SpecularRay) == 32 && offsetof(SpecularRay, pixel) == 12 &&
              offsetof(SpecularRay, direction) == 16 && offsetof(SpecularRay, through) == 28);

// Where it ends, after mirrors and glass: what sends light back along it. Where glass both mirrors and lets
// through it ends in several places. specular.glsl has the same.
struct SpecularHit {
    vec3 position{0};
    std::uint32_t kind = 0;  // 0: nothing is known, 1: a surface, 2: the sky
    vec3 normal{0};          // of the surface, unit, on the ray's side; of the sky: the direction towards it
    float spread = 0;  // 1: on the way it took one direction of a lobe; the mean of its neighbours tells more
    vec3 reflectance{0};        // of even light, times what is left on the way; of the sky: that alone
    std::uint32_t emitter = 0;  // Instance::id + 1 of what it has met; 0: not known
    vec3 emission{0};           // radiance, nits, times what is left on the way
    std::uint32_t next = 0;     // index of another end of the same ray; 0: there is none
};
static_assert(sizeof(SpecularHit) == 64 && offsetof(SpecularHit, kind) == 12 &&
              offsetof(SpecularHit, normal) == 16 && offsetof(SpecularHit, reflectance) == 32 &&
              offsetof(SpecularHit, emission) == 48 && offsetof(SpecularHit, next) == 60);

// Where caustic photons arrive.
struct CausticArrivals {
    std::vector<PhotonHit> straight;   // light that has met mirrors and glass alone
    std::vector<PhotonHit> scattered;  // light that something else has scattered, before them or after
};
struct CausticTargets;

// How finely rays meet what moves or deforms.
enum class RayDetail { full, coarser };

class ExactRays {
  public:
    virtual ~ExactRays() = default;
    // Becomes this frame's scene, by what its changes say. `scene` must stay as it is until the last trace()
    // of the frame. O(what changed); O(triangles log triangles) at first, and when instances come or go.
    virtual void follow(const FrameScene& scene, RayDetail detail) = 0;
    // The nearest surface on each ray; the same in any order and with any number of threads.
    virtual void trace(std::span<const ExactRay> rays, std::span<Arrival> arrivals) = 0;
    // Follows each ray over mirrors and through glass until it meets what is neither (specular_chain.h). One
    // end a ray, in their order, then those that are found by `next`. The same with any number of threads.
    virtual std::vector<SpecularHit> trace(std::span<const SpecularRay> rays) = 0;
    // Follows each photon as caustic_chains.h says and returns where they arrive, in order of photons; radius
    // is not set. The same with any number of threads.
    virtual CausticArrivals trace(std::span<const CausticPhoton> photons, const CausticTargets& targets,
                                  int bounces, std::uint32_t seed) = 0;
};

inline constexpr int kCausticSurfaces = 10;

using ExactRaysMaker = std::unique_ptr<ExactRays> (*)();
// Once, before any technique is made; not thread-safe.
void add_exact_rays(ExactRaysMaker maker);
bool has_exact_rays();
// Null if this program has none.
std::unique_ptr<ExactRays> make_exact_rays();

}  // namespace lanthorn::gi

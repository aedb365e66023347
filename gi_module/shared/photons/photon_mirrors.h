// What mirrors and glass show, by techniques that keep photons: rays by Embree, and at what they meet
// indirect light that the technique estimates on the processor.
#pragma once

#include <span>
#include <vector>

#include "gi_module/shared/mirrors/mirror_view.h"
#include "gi_module/shared/rays/specular_chain.h"
#include "lanthorn/gpu/growing_buffer.h"

namespace lanthorn::gi {

class PhotonMirrors {
  public:
    // Forgets its rays: has() is false until the next shoot().
    void clear();
    // Of a picture of that size rays have been shot.
    bool has(ivec2 size) const { return known_ && view_.has(size); }
    // A ray from every pixel that mirrors or is looked through, to what sends light back along it. `scene`:
    // as it is drawn. Waits for the GPU. O(pixels + rays log triangles).
    void shoot(const render::FrameInputs& inputs, const FollowedScene& scene, float roughness,
               reference::TileWorkers& workers);
    // Where they end: a hit a ray, then those found by `next`; and what surfaces they lie on.
    std::span<const SpecularHit> hits() const { return hits_; }
    std::span<const ChainSurface> surfaces() const { return surfaces_; }
    std::uint64_t rays() const { return rays_; }

    // IndirectLight::specular of what they send. `irradiances`: by hit, lux. `lamps`: they have direct light
    // in them, and the light maps are not asked.
    const gpu::Texture& shade(const render::FrameInputs& inputs, float roughness,
                              std::span<const vec4> irradiances, bool lamps = false);
    // Of the last shade().
    const gpu::Texture& picture() const { return view_.picture(); }
    std::uint64_t bad() const;  // values that were not numbers so far; waits for the GPU

  private:
    MirrorView view_{"gi_module/shared/mirrors/specular_shade_known.comp"};
    bool known_ = false;
    std::vector<SpecularHit> hits_;
    std::vector<ChainSurface> surfaces_;
    std::uint64_t rays_ = 0;
    gpu::GrowingBuffer irradiances_;
    gpu::Buffer bad_;
};

}  // namespace lanthorn::gi

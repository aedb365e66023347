// What mirrors and glass show, with the room's indirect light (Frisvad et al. 2005, sec. 4: light paths L D D
// S* E).
//
// Where the paper draws a mirrored scene for every planar mirror and a cube map for every curved one, a ray
// is followed from every pixel that mirrors to what is neither mirror nor glass, and lit there by the light
// maps and the samples. That has the same light paths without what those techniques get wrong: near things in
// curved mirrors, and mirrors in mirrors.
#pragma once

#include "lanthorn/drm/radiance_map.h"
#include "lanthorn/gi/emc/exact_rays.h"
#include "lanthorn/render/brdf_table.h"
#include "lanthorn/render/light_programs.h"

namespace lanthorn::gi {

class MirrorView {
  public:
    // Radiance and share of the lobe, RGBA32F of the picture's size (IndirectLight::specular). `shoot`: view
    // or surfaces have changed, rays are followed anew; else those of the frame before are lit anew. `shows`:
    // what of the room's light. Cost: a ray a pixel of what is smoother than `roughness`, and at each end
    // what a pixel costs.
    const gpu::Texture& radiance(const render::FrameInputs& inputs, const RadianceMap& map, ExactRays& exact,
                                 float roughness, DrmMirrors shows, bool shoot,
                                 const gpu::Buffer& bad_values);
    // Of the last frame that had one.
    const gpu::Texture& picture() const { return picture_; }
    std::uint32_t rays() const;  // of the last frame that shot any; waits for the GPU

  private:
    void allocate(ivec2 size);
    void use(const gpu::Program& program, const render::FrameInputs& inputs);
    void shoot(const render::FrameInputs& inputs, ExactRays& exact, float roughness);
    void shade(const render::FrameInputs& inputs, const RadianceMap& map, bool indirect,
               const gpu::Buffer& bad_values);

    ivec2 size_{0};
    gpu::Program rays_program_, resolve_program_;
    render::LightPrograms shade_programs_{{"gi_module/drm/mirror_shade.comp"}};
    render::BrdfTable table_;
    gpu::Buffer header_;   // number of rays, groups of 64
    gpu::Buffer rays_;     // SpecularRay
    gpu::Buffer hits_;     // SpecularHit, in the rays' order, then those found by next
    gpu::Buffer samples_;  // two a pixel
    gpu::Texture picture_;
};

}  // namespace lanthorn::gi

// What the picture mirrors and what is seen through it: a ray a pixel of smooth, glossy or transparent
// surfaces, followed to what sends light back along it, which is lit by the light maps and the lit maps. Wide
// lobes are left to the irradiance (render::IndirectLight::specular).
#pragma once

#include "lanthorn/gi/emc/caustic_cells.h"
#include "lanthorn/gi/emc/caustic_photons.h"
#include "lanthorn/gi/emc/environment_maps.h"
#include "lanthorn/gi/emc/exact_rays.h"
#include "lanthorn/gi/emc/lit_maps.h"
#include "lanthorn/render/brdf_table.h"
#include "lanthorn/render/light_programs.h"

namespace lanthorn::gi {

// Whether any surface of the scene is smooth or transparent enough. O(instances).
bool any_specular(const FrameScene& scene, const GiSettings& settings);

class SpecularView {
  public:
    // Radiance and share of the lobe, RGBA32F of the picture's size. `shoot`: view or surfaces have changed,
    // rays are followed anew; else those of the frame before are lit anew. `exact` null: rays go through the
    // maps. What they meet has the picture's own indirect `irradiance` (null: none) where the picture shows
    // it, and else that of the lit maps (`lit`; null: none) and of `caustics` (null: none). `bad_values`
    // counts what is not finite. Cost: a ray a pixel that mirrors or is looked through.
    const gpu::Texture& radiance(const render::FrameInputs& inputs, const EnvironmentMaps& maps,
                                 const LitMaps* lit, const gpu::Texture* irradiance,
                                 const CausticPhotons* caustics, ExactRays* exact, const GiSettings& settings,
                                 bool shoot, const gpu::Buffer& bad_values);
    // The picture of the last frame.
    const gpu::Texture& picture() const { return picture_; }
    std::uint32_t rays() const;  // of the last frame that shot any; waits for the GPU

  private:
    void allocate(ivec2 size);
    void shoot(const render::FrameInputs& inputs, const EnvironmentMaps& maps, const LitMaps* lit,
               ExactRays* exact, const GiSettings& settings);
    void trace_exactly(ExactRays& exact);
    void march(const render::FrameInputs& inputs, const EnvironmentMaps& maps, const LitMaps* lit,
               const GiSettings& settings);
    void shade(const render::FrameInputs& inputs, const EnvironmentMaps& maps, const LitMaps* lit,
               const gpu::Texture* irradiance, const CausticPhotons* caustics, const GiSettings& settings,
               const gpu::Buffer& bad_values);
    void use(const gpu::Program& program, const render::FrameInputs& inputs);
    void dispatch_rays() const;

    ivec2 size_{0};
    gpu::Program rays_program_, trace_program_, resolve_program_;
    render::LightPrograms shade_programs_{{"gi_module/emc/specular_shade.comp"}};
    render::BrdfTable table_;
    gpu::Buffer header_;   // number of rays, groups of 64
    gpu::Buffer rays_;     // SpecularRay
    gpu::Buffer hits_;     // SpecularHit, in the rays' order, then those found by next
    gpu::Buffer samples_;  // two a pixel
    gpu::Texture picture_;
    CausticCells cells_;
    gpu::BufferTexture points_view_, radiosity_view_, albedo_view_, direct_view_;
};

}  // namespace lanthorn::gi

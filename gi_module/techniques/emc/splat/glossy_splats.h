// Glossy surfaces of the picture, lit by photons at full size: each pixel sums the photons around it, each by
// the lobe for the direction in which it has come (Yao et al. 2010, sec. 6 and Fig. 8).
#pragma once

#include "gi_module/techniques/emc/maps/environment_maps.h"
#include "gi_module/techniques/emc/splat/splat_runs.h"
#include "gi_module/techniques/emc/splat/splatting.h"
#include "lanthorn/render/brdf_table.h"

namespace lanthorn::gi {

// Lobes that are wider, perceptual, are lit by irradiance.
inline constexpr float kGlossyRoughness = 0.75f;
// With glossy splats rays bring lobes up to this roughness, blended from 0.15 below it: narrower ones meet
// too few photons.
inline constexpr float kGlossyFromRays = 0.3f;

class GlossySplats {
  public:
    // Of the photons that `splatting` has splatted last; they have directions. `bad_values` (one uint32)
    // counts what is not finite. Cost: glossy pixels times photons within a bandwidth of each.
    void splat(const render::FrameInputs& inputs, const EnvironmentMaps& maps, const PhotonSet& photons,
               const GiSettings& settings, Splatting& splatting, const gpu::Buffer& bad_values);
    // Radiance in nits times the share of the lobe, and that share: of the last splat().
    const gpu::Texture& picture() const { return glossy_; }
    // The same of what rays bring (`traced`; null: nothing) and of `glossy` together, with what these lobes
    // reflect of the irradiance of `caustics` (null: none). Holds until the next call.
    const gpu::Texture& with(const render::FrameInputs& inputs, const gpu::Texture* traced,
                             const gpu::Texture& glossy, const gpu::Texture* caustics,
                             const GiSettings& settings);

  private:
    void allocate(ivec2 size);
    void use_pixels(const gpu::Program& program, const render::FrameInputs& inputs,
                    const GiSettings& settings);

    gpu::Program list_program_, boundaries_program_, splat_program_, add_program_;
    render::BrdfTable table_;
    ivec2 size_{0};
    gpu::Texture glossy_;
    gpu::Texture sum_;
    gpu::Buffer dispatches_;  // splat_lists.glsl
    gpu::Buffer pixels_;      // whose boundaries are found
    SplatRuns runs_;          // of splat_program_
    gpu::BufferTexture hits_texture_, directions_texture_;
};

}  // namespace lanthorn::gi

// What mirrors and glass show by `emc`: rays through triangles or through the maps, lit by the picture, the
// lit maps and caustic photons.
#pragma once

#include "gi_module/shared/mirrors/mirror_view.h"
#include "gi_module/shared/rays/exact_rays.h"
#include "gi_module/techniques/emc/caustics/caustic_cells.h"
#include "gi_module/techniques/emc/caustics/caustic_photons.h"
#include "gi_module/techniques/emc/lit_maps/lit_maps.h"
#include "gi_module/techniques/emc/maps/environment_maps.h"

namespace lanthorn::gi {

class SpecularView {
  public:
    // Radiance and share of the lobe (MirrorView::shade). `shoot`: view or surfaces have changed, rays are
    // followed anew; else those of the frame before are lit anew. `exact` null: rays go through the maps.
    // What they meet has the picture's own indirect `irradiance` (null: none) where the picture shows
    // it, and else that of the lit maps (`lit`; null: none) and of `caustics` (null: none). `bad_values`
    // counts what is not finite. Cost: a ray a pixel that mirrors or is looked through.
    const gpu::Texture& radiance(const render::FrameInputs& inputs, const EnvironmentMaps& maps,
                                 const LitMaps* lit, const gpu::Texture* irradiance,
                                 const CausticPhotons* caustics, ExactRays* exact, const GiSettings& settings,
                                 bool shoot, const gpu::Buffer& bad_values);

  private:
    void march(const render::FrameInputs& inputs, const EnvironmentMaps& maps, const LitMaps* lit,
               const GiSettings& settings);
    void bind(const gpu::Program& program, const render::FrameInputs& inputs, const EnvironmentMaps& maps,
              const LitMaps* lit, const gpu::Texture* irradiance, const CausticPhotons* caustics,
              const GiSettings& settings);

    MirrorView view_{"gi_module/techniques/emc/specular/specular_shade.comp"};
    gpu::Program trace_program_;
    CausticCells cells_;
    gpu::BufferTexture points_view_, radiosity_view_, albedo_view_, direct_view_;
};

}  // namespace lanthorn::gi

// The debug views of `emc`.
#pragma once

#include <vector>

#include "gi_module/techniques/emc/gather/gather.h"
#include "gi_module/techniques/emc/lit_maps/lit_maps.h"
#include "gi_module/techniques/emc/maps/environment_maps.h"
#include "gi_module/techniques/emc/photons/photon_set.h"
#include "lanthorn/gi/technique.h"

namespace lanthorn::gi {

std::vector<DebugView> emc_views();

// Each waits for the GPU.
class EmcViews {
  public:
    // The maps, a row each.
    gpu::Texture maps(const EnvironmentMaps& maps, const GiSettings& settings,
                      const render::FrameInputs& inputs);
    // How many maps see what each pixel shows.
    gpu::Texture coverage(const EnvironmentMaps& maps, const GiSettings& settings,
                          const render::FrameInputs& inputs);

  private:
    gpu::Program atlas_, coverage_;
};

// What the lit texels reflect, a row a map.
gpu::Texture draw_lit_texels(const LitMaps& lit);
gpu::Texture draw_photons(const std::vector<PhotonHit>& photons, const render::FrameInputs& inputs);
// One value a point of the gather's grid.
gpu::Texture draw_points(const std::vector<vec4>& values, ivec2 grid, int stride, ivec2 size);

}  // namespace lanthorn::gi

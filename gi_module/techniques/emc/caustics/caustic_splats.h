// Caustic photons on the picture: each pixel sums the narrow splats that cover it, at full size, and the sum
// joins the irradiance of the final stage.
#pragma once

#include <vector>

#include "gi_module/techniques/emc/photons/photon_set.h"
#include "gi_module/techniques/emc/splat/splat_runs.h"
#include "gi_module/techniques/emc/splat/splat_tiles.h"
#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/gpu/texture.h"
#include "lanthorn/render/frame.h"

namespace lanthorn::gi {

class CausticSplats {
  public:
    // Splats `hits`, none narrower than the pixels that see it. `surfaces_changed`: the visible surface
    // points are not those of the last call. `local_length`: EnvironmentMaps::extent(). `bad_values` (one
    // uint32) counts what is not finite.
    void splat(const render::FrameInputs& inputs, const std::vector<PhotonHit>& hits, bool surfaces_changed,
               float local_length, const gpu::Buffer& bad_values);
    // Irradiance in lux of `base` (null: 0) and of what was last splatted. Holds until the next call.
    const gpu::Texture& with(const gpu::Texture* base);

    // Irradiance of what was last splatted alone.
    const gpu::Texture& picture() const { return caustics_; }

  private:
    void allocate(ivec2 size);
    // Dispatches of splat_program_ that may be needed: which of them are is left to the GPU.
    void upload(const render::FrameInputs& inputs, std::vector<PhotonHit> hits);

    gpu::Program splat_program_, add_program_;
    SplatTiles tiles_{{.use = "caustics"}};
    PhotonSet photons_;
    ivec2 size_{0};
    gpu::Texture caustics_;  // lux
    gpu::Texture sum_;
    SplatRuns runs_;  // of splat_program_
    gpu::BufferTexture hits_texture_;
};

}  // namespace lanthorn::gi

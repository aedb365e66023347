// From samples to the picture: every pixel is lit by all of them (Frisvad et al. 2005, eq. 10; sec. 5, step
// 6).
#pragma once

#include <map>
#include <tuple>

#include "gi_module/techniques/drm/radiance_map.h"
#include "lanthorn/render/brdf_table.h"

namespace lanthorn::gi {

class DrmGather {
  public:
    // Indirect irradiance of every pixel, and with `lobes` what its specular lobe reflects of the same light
    // where that is wider than what `mirrored` has (RGBA32F as IndirectLight::specular, null: nothing), which
    // is added. `most_roughness`: of surfaces that are mirrored. The map has at least one sample. O(pixels *
    // samples).
    render::IndirectLight light(const render::FrameInputs& inputs, const RadianceMap& map, bool lobes,
                                const gpu::Texture* mirrored, float most_roughness,
                                const gpu::Buffer& bad_values);

  private:
    const gpu::Program& program(bool lobes, bool in_block, bool hidden);

    std::map<std::tuple<bool, bool, bool>, gpu::Program> programs_;
    render::BrdfTable table_;
    gpu::Texture irradiance_;
    gpu::Texture specular_;
};

}  // namespace lanthorn::gi

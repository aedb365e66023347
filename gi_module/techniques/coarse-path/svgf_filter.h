// The spatial half of SVGF (Schied et al. 2017, sec. 4.2 to 4.4) on the lattice: light is averaged along
// surfaces, as far as its own uncertainty says.
#pragma once

#include "gi_module/shared/coarse_grid/coarse_grid.h"

namespace lanthorn::gi {

class SvgfFilter {
  public:
    // Light of the lattice's cells (RGBA32F: lux, variance of the luminance), from the points and their
    // estimates (PointEstimate each), by `levels` levels of the filter; `sigma`: luminances that differ by so
    // many standard deviations count 1/e. O(cells levels).
    const gpu::Texture& filter(const render::FrameInputs& inputs, ivec2 cells, const gpu::Buffer& points,
                               const gpu::Buffer& estimates, int levels, float sigma);

  private:
    gpu::Program planes_program_;
    gpu::Program variance_program_;
    gpu::Program guided_program_;  // the first level
    gpu::Program atrous_program_;
    gpu::Texture light_[2];
    gpu::Texture planes_;
    gpu::Texture guide_;
    gpu::BufferTexture points_;
    gpu::BufferTexture estimates_;
};

}  // namespace lanthorn::gi

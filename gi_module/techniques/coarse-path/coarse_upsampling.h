// From the lattice and the extra points to every pixel, level by level (as Yao et al. 2010, sec. 6, does it).
#pragma once

#include "gi_module/shared/coarse_grid/coarse_grid.h"

namespace lanthorn::gi {

class CoarseUpsampling {
  public:
    // Irradiance of every pixel (RGBA32F, lux). `light`: of the lattice's cells; `estimates`: PointEstimate
    // of each of the grid's points, of which the extra ones are read. O(pixels).
    const gpu::Texture& irradiance(const render::FrameInputs& inputs, const CoarseGrid& grid,
                                   const gpu::Texture& light, const gpu::Buffer& estimates);

  private:
    gpu::Program place_program_;
    gpu::Program extras_program_;
    gpu::Program level_program_;
    gpu::Texture irradiance_;
    gpu::Texture extras_;
    gpu::BufferTexture points_;
    gpu::BufferTexture estimates_;
};

}  // namespace lanthorn::gi

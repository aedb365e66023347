// Which points of the picture light is computed at, found on the GPU from the G-buffer.
#pragma once

#include "gi_module/shared/coarse_grid/surface_point.h"
#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/gpu/texture.h"
#include "lanthorn/render/frame.h"

namespace lanthorn::gi {

class CoarseGrid {
  public:
    // Finds the points of what the G-buffer shows. `spacing`: of the lattice, pixels, a power of 2. Waits for
    // the GPU. O(pixels).
    void find(const render::FrameInputs& inputs, int spacing);

    const GridPoints& points() const { return points_; }
    const gpu::Buffer& buffer() const { return buffer_; }  // points().points
    // R32UI by pixel: which corners of the coarser lattice's cell around it lie on its surface, bit k for
    // (k & 1, k >> 1).
    const gpu::Texture& fits() const { return fits_; }

  private:
    std::uint32_t run(const render::FrameInputs& inputs);

    gpu::Program program_;
    gpu::Buffer buffer_;
    gpu::Buffer count_;
    gpu::Texture fits_;
    std::size_t capacity_ = 0;  // of extra points
    GridPoints points_;
};

}  // namespace lanthorn::gi

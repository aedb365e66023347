// A still picture as the mean of many passes, each with photons of its own and splats smaller than the last
// (Knaus and Zwicker 2011, "Progressive photon mapping: a probabilistic approach").
#pragma once

#include "lanthorn/gpu/program.h"
#include "lanthorn/gpu/texture.h"

namespace lanthorn::gi {

// Splat radius of pass `pass` (from 0) over that of pass 0: r_k^2 = r_(k-1)^2 (k + alpha) / (k + 1), their
// recurrence, alpha = 2/3. Error falls as both variance and bias of the mean go to 0.
float pass_radius(int pass);

class Accumulation {
  public:
    // Takes `image` (RGBA32F) into the mean of those since pass 0, and returns the mean; pass 0 is `image`.
    const gpu::Texture& add(const gpu::Texture& image, int pass);

  private:
    gpu::Program program_;
    gpu::Texture mean_;
};

}  // namespace lanthorn::gi

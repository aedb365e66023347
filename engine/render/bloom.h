// The veil of light around what is bright: the share of a picture's light that eye and lens scatter, in a
// pyramid of ever wider pictures (Burt and Adelson 1983, "The Laplacian Pyramid as a Compact Image Code";
// as games have it: Jimenez 2014, "Next Generation Post Processing in Call of Duty: Advanced Warfare").
// Without a threshold, and linear: light keeps its hue and its sum.
#pragma once

#include <vector>

#include "lanthorn/gpu/framebuffer.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/gpu/texture.h"

namespace lanthorn::render {

class Bloom {
  public:
    static constexpr int kFirst = 4;  // pixels of the picture a texel of scattered() is wide

    // For pictures of that size.
    explicit Bloom(ivec2 size);

    // Spreads the light of `radiance` (linear; where alpha is 2 it counts as black) over scattered().
    // `spread`, 0..1: the share that each level hands on to the next, which is twice as wide; a constant
    // picture stays constant. O(pixels): 16 fetches of each, and a third more for all levels together.
    void scatter(const gpu::Texture& radiance, float spread);
    // The result, a texel for kFirst x kFirst pixels from the lower left on; RGBA32F.
    const gpu::Texture& scattered() const { return levels_.front().sum; }

  private:
    struct Level {
        ivec2 size{0};
        gpu::Texture light, sum;  // of its own width; with what the wider levels hand back
        gpu::Framebuffer to_light, to_sum;
    };
    std::vector<Level> levels_;  // the finest first
    gpu::Program tile_, down_, up_;
};

}  // namespace lanthorn::render

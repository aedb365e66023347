// Smooth edges in a finished picture: fast approximate antialiasing (Lottes 2009, "FXAA"), which finds steps
// of luma along edges and mixes across them by how far a pixel is from the step's ends. It knows no geometry:
// what is thinner than a pixel stays broken. Only pixels on edges are worked on.
#pragma once

#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/gpu/texture.h"

namespace lanthorn::render {

class Fxaa {
  public:
    explicit Fxaa(ivec2 size);

    // `picture`: RGBA8 of that size, encoded for display; smoothed in place. O(pixels) and 62 fetches a pixel
    // on an edge.
    void smooth(const gpu::Texture& picture);

    // The last picture, as it came.
    const gpu::Texture& source() const { return source_; }

  private:
    ivec2 size_;
    gpu::Texture source_;  // the picture as it came
    gpu::Buffer edges_;    // fxaa.glsl
    gpu::Program list_;
    gpu::Program smooth_;
};

}  // namespace lanthorn::render

// Irradiance at pixels from that at the points of a coarse grid: bilinear between those around on the pixel's
// surface.
#pragma once

#include "gi_module/techniques/emc/gather/entry_list.h"
#include "gi_module/techniques/emc/gather/surface_points.h"
#include "lanthorn/gpu/texture.h"
#include "lanthorn/render/frame.h"

namespace lanthorn::gi {

class GatherUpsampling {
  public:
    // The points of the grid, one every `stride` pixels, lie elsewhere: the next irradiance() finds out which
    // of them each pixel shares its surface with, and its side of walls (`walls`: gather_links.h). Both must
    // live until then.
    void place(const SurfacePoints& points, const gpu::Buffer& walls, ivec2 grid, int stride);
    // Irradiance in lux over the G-buffer's pixels, from that at points (vec4; a < 0: not known). A pixel
    // that shares its surface with none of the four points around takes it from the sixteen around, or else
    // from the most alike of those. Cost: a pass over the pixels.
    const gpu::Texture& irradiance(const render::FrameInputs& inputs, const gpu::Buffer& irradiance);
    const gpu::Texture& picture() const { return picture_; }  // that it was last

  private:
    void allocate(ivec2 size);
    void use(const gpu::Program& program, const render::FrameInputs& inputs);

    bool placed_ = false;
    const SurfacePoints* points_ = nullptr;
    const gpu::Buffer* walls_ = nullptr;
    ivec2 size_{0};
    ivec2 grid_{0};
    int stride_ = 0;
    gpu::Program place_program_, upsample_program_, lone_program_;
    gpu::Texture fits_;  // by pixel: weights of the four points around, 8 bits each
    gpu::Texture picture_;
    EntryList lone_;  // pixels that none of the four fits
    gpu::BufferTexture points_view_, irradiance_view_, walls_view_;
};

}  // namespace lanthorn::gi

// Photons sorted into screen tiles, so that each pixel meets only the photons whose splats may touch its
// tile.
#pragma once

#include "lanthorn/gi/emc/photon_set.h"
#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/render/frame.h"

namespace lanthorn::gi {

class SplatTiles {
  public:
    static constexpr int kTileSize = 64;  // pixels a side

    void resize(ivec2 image_size);
    // `surfaces_changed`: the visible surface points are not those of the last call.
    void sort(const render::FrameInputs& inputs, const PhotonSet& photons, bool surfaces_changed);

    ivec2 grid() const { return grid_; }
    const gpu::Buffer& starts() const { return starts_; }  // by tile: its first entry in lists()
    const gpu::Buffer& lists() const { return lists_; }    // indices of photons
    std::uint32_t longest_list() const { return longest_list_; }

  private:
    gpu::Program boxes_program_;
    gpu::Program count_program_;
    gpu::Program fill_program_;
    gpu::Program scan_programs_[3];

    ivec2 image_size_{0};
    ivec2 grid_{0};
    gpu::Buffer boxes_;
    gpu::Buffer counts_;
    gpu::Buffer starts_;
    gpu::Buffer lists_;
    std::uint32_t longest_list_ = 0;
    gpu::BufferTexture hits_texture_;
    gpu::BufferTexture boxes_texture_;
};

}  // namespace lanthorn::gi

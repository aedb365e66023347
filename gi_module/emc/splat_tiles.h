// Photons sorted into screen tiles, so that each pixel meets only the photons whose splats may touch its
// tile. The GLSL side: splat_tiles.glsl.
#pragma once

#include <cstddef>
#include <cstdint>

#include "lanthorn/gi/emc/emc_statistics.h"
#include "lanthorn/gi/emc/photon_set.h"
#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/gpu/read_back.h"
#include "lanthorn/render/frame.h"

namespace lanthorn::gi {

class SplatTiles {
  public:
    static constexpr int kTileSize = 64;  // pixels a side
    // Entries that lists have room for at first, where every photon in every tile would be more; or so many a
    // photon.
    static constexpr std::size_t kEntries = 4'000'000;
    static constexpr std::size_t kEntriesAPhoton = 16;

    // How long lists become is known to the GPU alone, and to the processor a frame later. Tiles whose lists
    // there is no room for have all photons tried, which is slow; the next frame has room.
    explicit SplatTiles(std::size_t entries = kEntries, std::size_t entries_a_photon = kEntriesAPhoton)
        : entries_(entries), entries_a_photon_(entries_a_photon) {}

    void resize(ivec2 image_size);
    // `surfaces_changed`: the visible surface points are not those of the last call. Waits at most for what
    // the last call has begun.
    void sort(const render::FrameInputs& inputs, const PhotonSet& photons, bool surfaces_changed);

    ivec2 grid() const { return grid_; }
    // For splat_tiles.glsl, of the program in use.
    void bind(const gpu::Program& program, GLuint lists_unit);
    SplatStatistics statistics() const { return statistics_; }

  private:
    void make_room(std::size_t photons);

    gpu::Program boxes_program_;
    gpu::Program count_program_;
    gpu::Program fill_program_;
    gpu::Program scan_programs_[3];

    std::size_t entries_, entries_a_photon_;
    ivec2 image_size_{0};
    ivec2 grid_{0};
    gpu::Buffer boxes_;
    gpu::Buffer counts_;
    gpu::Buffer starts_;  // behind Totals, by tile: its first entry in lists_
    gpu::Buffer lists_;   // indices of photons
    gpu::ReadBack totals_;
    SplatStatistics statistics_;
    gpu::BufferTexture hits_texture_;
    gpu::BufferTexture boxes_texture_;
    gpu::BufferTexture lists_texture_;
};

}  // namespace lanthorn::gi

// Photons sorted into screen tiles, so that each pixel meets only the photons whose splats may touch its
// tile. The GLSL side: splat_tiles.glsl.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "engine/gpu/read_back.h"
#include "gi_module/techniques/emc/photons/photon_set.h"
#include "gi_module/techniques/emc/splat/splat_ways.h"
#include "lanthorn/emc/emc_statistics.h"
#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"
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
    struct Options {
        std::size_t entries = kEntries;
        std::size_t entries_a_photon = kEntriesAPhoton;
        std::string use = "splats";  // splats of one kind, that one binning suits
        // None: the faster on this device, by the first sort() of the use.
        std::optional<SplatBinning> binning = {};
    };
    SplatTiles() : SplatTiles(Options()) {}
    explicit SplatTiles(Options options) : options_(std::move(options)), binning_(options_.binning) {}

    void resize(ivec2 image_size);
    // `surfaces_changed`: the visible surface points are not those of the last call. `least_radius`: of a
    // splat, metres; none reaches less far. Waits at most for what the last call has begun.
    void sort(const render::FrameInputs& inputs, const PhotonSet& photons, bool surfaces_changed,
              float least_radius = 0);

    ivec2 grid() const { return grid_; }
    // For splat_tiles.glsl, of the program in use.
    void bind(const gpu::Program& program, GLuint lists_unit);
    SplatListStatistics statistics() const { return statistics_; }
    std::optional<SplatBinning> binning() const { return binning_; }  // none: nothing has been sorted yet

  private:
    struct Chunks {  // of the photons, that are counted apart
        int size;
        int count;
    };
    static Chunks chunks_of(int hits);
    void make_room(std::size_t photons);
    void find_boxes(const render::FrameInputs& inputs);
    void find_rects(const render::FrameInputs& inputs, const PhotonSet& photons);
    // Counts entries by tile and chunk, or writes them at the places that the sums of the counts say.
    void bin(SplatBinning binning, bool fill, const Chunks& chunks);

    gpu::Program boxes_program_;
    gpu::Program rects_program_;
    gpu::Program bin_programs_[2][2];  // by SplatBinning; counts, fills
    gpu::Program scan_programs_[3];

    Options options_;
    std::optional<SplatBinning> binning_;
    ivec2 image_size_{0};
    ivec2 grid_{0};
    float least_radius_ = 0;
    gpu::Buffer boxes_;
    gpu::Buffer rects_;  // splat_rects.glsl, by photon
    gpu::Buffer counts_;
    gpu::Buffer starts_;  // behind Totals, by tile: its first entry in lists_
    gpu::Buffer lists_;   // indices of photons
    gpu::ReadBack totals_;
    SplatListStatistics statistics_;
    gpu::BufferTexture hits_texture_;
    gpu::BufferTexture boxes_texture_;
    gpu::BufferTexture rects_texture_;
    gpu::BufferTexture lists_texture_;
};

}  // namespace lanthorn::gi

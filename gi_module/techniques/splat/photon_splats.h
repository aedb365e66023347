// Photons onto the picture, on the GPU.
#pragma once

#include <span>
#include <vector>

#include "gi_module/techniques/splat/kernel_areas.h"
#include "gi_module/techniques/splat/photon_collection.h"
#include "gi_module/techniques/splat/splat_lists.h"
#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/gpu/texture.h"

namespace lanthorn::gi {

class PhotonSplats {
  public:
    // Irradiance of every pixel (RGBA32F, lux) by all photons: read once a bandwidth, a run at a time, so
    // that the GPU holds one run, and at most kMostEntries of what tells its tiles. Null where they could not
    // be read: photons.store().error() says why. O(pixels * C^2 + photons).
    const gpu::Texture* draw(const PictureSurfaces& picture, const SplatSurfaces& surfaces,
                             PhotonCollection& photons, std::span<const vec3> powers,
                             const SplatSettings& settings, reference::TileWorkers& workers);

    struct Counts {
        std::uint64_t splatted = 0;  // records of photons, in every round
        std::uint64_t entries = 0;   // blocks of photons in tiles
        int rounds = 0;              // bandwidths that were tried, both kinds together
        std::uint64_t bad = 0;       // pixels that were not numbers
    };
    const Counts& counts() const { return counts_; }
    // At a time, but for a block that alone has more: 16 MiB here, 20 on the GPU, and some 18 to 36 while
    // they are sorted.
    static constexpr std::size_t kMostEntries = std::size_t{1} << 19;

  private:
    bool draw_kind(bool caustic, const PictureSurfaces& picture, const SplatSurfaces& surfaces,
                   PhotonCollection& photons, const SplatSettings& settings, reference::TileWorkers& workers);
    // A run's photons, blocks of them at a time.
    void add_run(const RecordRun& run, const PictureSurfaces& picture, std::span<const float> h,
                 std::span<const std::uint32_t> open, reference::TileWorkers& workers);
    // Of the photons that add_run() has put there.
    void add_lists(const SplatLists& lists, const PictureSurfaces& picture);
    void resolve(const PictureSurfaces& picture, std::span<const float> h, std::span<const float> areas,
                 std::span<const std::uint32_t> splatted, const SplatSettings& settings, bool last);

    gpu::Program splat_, resolve_;
    int lanes_ = 0;
    PhotonKernel kernel_ = PhotonKernel::constant;
    gpu::Texture sums_, irradiance_, decided_;
    gpu::Buffer photons_, entries_, tiles_, pixels_, areas_, bandwidths_, open_, splatted_, bad_, powers_;
    gpu::BufferTexture photon_texels_, entry_texels_, tile_texels_, pixel_texels_, area_texels_,
        bandwidth_texels_, splatted_texels_, power_texels_;
    Counts counts_;
};

}  // namespace lanthorn::gi

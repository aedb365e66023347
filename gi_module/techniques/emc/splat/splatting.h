// Photon splatting at low resolution and multi-level up-sampling (Yao et al. 2010, sec. 6).
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "gi_module/techniques/emc/maps/environment_maps.h"
#include "gi_module/techniques/emc/photons/photon_set.h"
#include "gi_module/techniques/emc/splat/splat_tiles.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/gpu/texture.h"
#include "lanthorn/render/frame.h"

namespace lanthorn::gi {

// Sizes of indirect dispatches; splat_lists.glsl.
struct SplatDispatches {
    std::uint32_t batch_groups[3] = {0, 1, 1};
    std::uint32_t new_groups[3] = {0, 1, 1};
    std::uint32_t batch_count = 0;
    std::uint32_t new_count = 0;
};

class Splatting {
  public:
    // `kernel`: none: the faster on this device, by the first picture.
    explicit Splatting(SplatTiles::Options tiles = {}, std::optional<SplatKernel> kernel = {})
        : tiles_(std::move(tiles)), wanted_kernel_(kernel) {}

    // Irradiance in lux over the G-buffer's pixels. `surroundings_changed`: surface points or maps are not
    // those of the last call. `bad_values` (one uint32) counts what is not finite.
    const gpu::Texture& irradiance(const render::FrameInputs& inputs, const EnvironmentMaps& maps,
                                   const PhotonSet& photons, const GiSettings& settings,
                                   bool surroundings_changed, const gpu::Buffer& bad_values);

    // Of the last irradiance(): photons by tile; how far surfaces go on around full-size pixels, and the
    // weights of kernels there (splat_boundaries.comp), of pixels that have been gathered.
    SplatTiles& tiles() { return tiles_; }
    const gpu::Texture& boundaries() const { return boundaries_; }
    const gpu::Texture& weights() const { return weights_; }

    SplatListStatistics statistics() const { return tiles_.statistics(); }
    // Of the last picture; none before.
    std::optional<SplatKernel> kernel() const { return kernel_; }
    std::optional<SplatBinning> binning() const { return tiles_.binning(); }

  private:
    struct Level {
        int stride;           // full-size pixels a side of this level's
        gpu::Texture image;   // irradiance
        gpu::Texture blocks;  // splat_blocks.glsl; none on the coarsest level
    };

    void build_programs();
    // Of gather_programs_.
    enum Gathering { kBatches, kLongLists, kPixels, kGatherings };
    void build_gather_programs(Gathering gathering);
    void choose_kernel(const render::FrameInputs& inputs, const PhotonSet& photons);
    void allocate(ivec2 size, int level_count);
    void find_neighbours(const render::FrameInputs& inputs, float bandwidth_max);
    void upsample(const Level& level, const Level& coarse, float contrast);
    void use_level(const gpu::Program& program, const render::FrameInputs& inputs, const Level& level,
                   const PhotonSet& photons);
    const gpu::Program& use_boundaries(bool listed, const render::FrameInputs& inputs, const Level& level,
                                       const EnvironmentMaps& maps, const PhotonSet& photons,
                                       const GiSettings& settings);
    // The gather of a level; by batches with a program for short lists and, where there may be any, one for
    // long ones.
    void gather(SplatKernel kernel, bool listed, const render::FrameInputs& inputs, const Level& level,
                const PhotonSet& photons, const gpu::Buffer& bad_values);

    SplatTiles tiles_;
    gpu::Program boundaries_programs_[2];           // a whole level, listed pixels
    gpu::Program gather_programs_[kGatherings][2];  // the same of each
    gpu::Program neighbours_program_;
    gpu::Program upsampling_programs_[2];  // by SplatKernel, whose batches of pixels it lists
    std::optional<SplatKernel> wanted_kernel_, kernel_;
    Bandwidth bandwidth_ = Bandwidth::fixed;

    ivec2 size_{0};
    float local_length_ = 1;     // EnvironmentMaps::extent()
    float bandwidth_max_ = 0;    // that the boundaries were found for
    std::vector<Level> levels_;  // [0] is full size, each next half of it
    gpu::Texture boundaries_;    // eight radii a full-size pixel, where it has been gathered
    gpu::Texture weights_;       // kernel_moments.glsl: by which the kernel is corrected over their polygon
    gpu::Buffer dispatches_;     // splat_lists.glsl
    gpu::Buffer listed_;
    gpu::Buffer tile_counts_;
    gpu::Buffer new_pixels_;
    gpu::Buffer batches_;
    gpu::BufferTexture hits_texture_;
};

}  // namespace lanthorn::gi

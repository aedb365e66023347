// Photon splatting at low resolution and multi-level up-sampling (Yao et al. 2010, sec. 6).
#pragma once

#include <vector>

#include "engine/gpu/buffer.h"
#include "engine/gpu/program.h"
#include "engine/gpu/texture.h"
#include "engine/render/frame.h"
#include "gi_module/emc/environment_maps.h"
#include "gi_module/emc/photon_tracing.h"
#include "gi_module/gi_settings.h"

namespace lanthorn::gi {

class Splatting {
  public:
    // Irradiance in lux over the G-buffer's pixels. `camera_changed`: the surface points are not those of the
    // last call.
    const gpu::Texture& irradiance(const render::FrameInputs& inputs, const EnvironmentMaps& maps,
                                   const PhotonTracing& photons, const GiSettings& settings,
                                   bool camera_changed);

  private:
    void allocate(ivec2 size, int level_count);
    void sort_into_tiles(const render::FrameInputs& inputs, const PhotonTracing& photons,
                         bool camera_changed);
    void prepare_gather(const gpu::Program& program, const render::FrameInputs& inputs,
                        const EnvironmentMaps& maps, const PhotonTracing& photons,
                        const GiSettings& settings);

    gpu::Program tile_boxes_program_;
    gpu::Program count_program_;
    gpu::Program fill_program_;
    gpu::Program scan_programs_[3];
    gpu::Program gather_program_;
    gpu::Program gather_listed_program_;
    gpu::Program upsampling_program_;

    void build_gather_programs(Bandwidth bandwidth);
    Bandwidth bandwidth_ = Bandwidth::fixed;
    ivec2 size_{0};
    ivec2 tile_grid_{0};
    std::vector<gpu::Texture> levels_;  // [0] is full size, each next half of it
    gpu::Buffer tile_boxes_;
    gpu::Buffer counts_;
    gpu::Buffer starts_;
    gpu::Buffer lists_;
    gpu::Buffer redo_;
    gpu::BufferTexture hits_texture_;
    gpu::BufferTexture lists_texture_;
    gpu::BufferTexture boxes_texture_;
};

}  // namespace lanthorn::gi

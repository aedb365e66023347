#include "gi_module/techniques/emc/splat/splatting.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "gi_module/techniques/emc/faster.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gi/passes.h"
#include "lanthorn/gpu/context.h"

namespace lanthorn::gi {

namespace {

constexpr int kBatch = 8;        // splat_lists.glsl
constexpr int kPixelBatch = 64;  // the same of splat_gather_pixels.comp
// Invocations that share a tile's photons out. Mesa's llvmpipe ends an invocation's loops, silently, after
// 65535 turns in all: lists too long for few lanes are left to many. How long they are the GPU knows alone.
constexpr int kLanes = 16;
constexpr int kManyLanes = 256;
constexpr int kLongList = 60'000 * kLanes;

constexpr SplatDispatches kNoDispatches;
constexpr GLintptr kBatchGroups = offsetof(SplatDispatches, batch_groups);
constexpr GLintptr kNewGroups = offsetof(SplatDispatches, new_groups);
static_assert(sizeof(SplatDispatches) == 32 && kNewGroups == 12 &&
              offsetof(SplatDispatches, batch_count) == 24 && offsetof(SplatDispatches, new_count) == 28);

}  // namespace

void Splatting::build_programs() {
    boundaries_programs_[0] =
        gpu::Program({"gi_module/techniques/emc/splat/splat_boundaries.comp"}, {"LISTED 0"});
    boundaries_programs_[1] =
        gpu::Program({"gi_module/techniques/emc/splat/splat_boundaries.comp"}, {"LISTED 1"});
    neighbours_program_ = gpu::Program({"gi_module/techniques/emc/splat/splat_neighbours.comp"});
    upsampling_programs_[0] = gpu::Program({"gi_module/techniques/emc/splat/upsampling.comp"},
                                           {"BATCH " + std::to_string(kBatch) + "u"});
    upsampling_programs_[1] = gpu::Program({"gi_module/techniques/emc/splat/upsampling.comp"},
                                           {"BATCH " + std::to_string(kPixelBatch) + "u"});
}

void Splatting::build_gather_programs(Gathering gathering) {
    const std::string fixed = std::string("BANDWIDTH_FIXED ") + (bandwidth_ == Bandwidth::fixed ? "1" : "0");
    for (int listed = 0; listed < 2; ++listed) {
        std::vector<std::string> defines{"LISTED " + std::to_string(listed), fixed};
        if (gathering != kPixels) {
            const bool many = gathering == kLongLists;
            defines.push_back(std::string("MANY_LANES ") + (many ? "1" : "0"));
            defines.push_back("LANES " + std::to_string(many ? kManyLanes : kLanes));
        }
        gather_programs_[gathering][listed] =
            gpu::Program({gathering == kPixels ? "gi_module/techniques/emc/splat/splat_gather_pixels.comp"
                                               : "gi_module/techniques/emc/splat/splat_gather.comp"},
                         defines);
    }
}

void Splatting::allocate(ivec2 size, int level_count) {
    size_ = size;
    tiles_.resize(size);
    levels_.clear();
    for (int l = 0; l < level_count; ++l) {
        const int stride = 1 << l;
        const ivec2 level_size = (size + stride - 1) / stride;
        Level level{stride, gpu::Texture::make_2d(GL_RGBA32F, level_size), {}};
        if (l + 1 < level_count) {
            level.blocks = gpu::Texture::make_2d(GL_R32UI, level_size / 2 + 1);
        }
        levels_.push_back(std::move(level));
    }
    boundaries_ = gpu::Texture::make_2d(GL_RGBA32UI, size);
    weights_ = gpu::Texture::make_2d_array(GL_RGBA32F, size, 3);
    const ivec2 grid = tiles_.grid();
    const auto tiles = static_cast<std::size_t>(grid.x) * static_cast<std::size_t>(grid.y);
    const std::size_t pixels = tiles * SplatTiles::kTileSize * SplatTiles::kTileSize;
    dispatches_ = gpu::Buffer(sizeof(kNoDispatches));
    listed_ = gpu::Buffer(pixels * sizeof(std::uint32_t));
    new_pixels_ = gpu::Buffer(pixels * sizeof(std::uint32_t));
    batches_ = gpu::Buffer(pixels / kBatch * sizeof(std::uint32_t));
    tile_counts_ = gpu::Buffer(tiles * sizeof(std::uint32_t));
}

void Splatting::find_neighbours(const render::FrameInputs& inputs, float bandwidth_max) {
    use_surfaces(neighbours_program_, inputs);
    neighbours_program_.set("bandwidth_max", bandwidth_max);
    for (std::size_t l = 0; l + 1 < levels_.size(); ++l) {
        const Level& level = levels_[l];
        neighbours_program_.set("stride", level.stride);
        neighbours_program_.set("level_size", ivec2(level.image.size()));
        neighbours_program_.set("coarse_size", ivec2(levels_[l + 1].image.size()));
        level.blocks.bind_image(1, GL_WRITE_ONLY);
        neighbours_program_.dispatch(ivec2(level.blocks.size()), ivec2(8));
    }
    wait_for_shaders();
}

void Splatting::upsample(const Level& level, const Level& coarse, float contrast) {
    dispatches_.write_bytes(0, &kNoDispatches, sizeof(kNoDispatches));
    tile_counts_.clear();
    const gpu::Program& program = upsampling_programs_[kernel_ == SplatKernel::pixels ? 1 : 0];
    program.use();
    program.set("coarse", 0);
    program.set("level_size", ivec2(level.image.size()));
    program.set("coarse_size", ivec2(coarse.image.size()));
    program.set("image_size", size_);
    program.set("tile_grid", tiles_.grid());
    program.set("tile_size", SplatTiles::kTileSize);
    program.set("stride", level.stride);
    program.set("contrast", contrast);
    coarse.image.bind(0);
    level.image.bind_image(0, GL_WRITE_ONLY);
    level.blocks.bind_image(1, GL_READ_WRITE);
    listed_.bind_storage(2);
    tile_counts_.bind_storage(3);
    new_pixels_.bind_storage(4);
    dispatches_.bind_storage(6);
    batches_.bind_storage(7);
    program.dispatch(ivec2(level.blocks.size()), ivec2(8));
    wait_for_shaders();
}

// The uniforms of splat_surface.glsl, from texture unit 2.
void Splatting::use_level(const gpu::Program& program, const render::FrameInputs& inputs, const Level& level,
                          const PhotonSet& photons) {
    use_surfaces(program, inputs, 2);
    program.set("level_size", ivec2(level.image.size()));
    program.set("stride", level.stride);
    program.set("bandwidth_max", photons.h_max);
    dispatches_.bind_storage(6);
}

const gpu::Program& Splatting::use_boundaries(bool listed, const render::FrameInputs& inputs,
                                              const Level& level, const EnvironmentMaps& maps,
                                              const PhotonSet& photons, const GiSettings& settings) {
    const gpu::Program& program = boundaries_programs_[listed ? 1 : 0];
    use_level(program, inputs, level, photons);
    maps.bind(program, 0, 1, settings, inputs.scene);
    new_pixels_.bind_storage(4);
    boundaries_.bind_image(0, GL_WRITE_ONLY);
    weights_.bind_image(1, GL_WRITE_ONLY);
    return program;
}

void Splatting::gather(SplatKernel kernel, bool listed, const render::FrameInputs& inputs, const Level& level,
                       const PhotonSet& photons, const gpu::Buffer& bad_values) {
    const int side = SplatTiles::kTileSize / level.stride;
    const ivec2 grid = tiles_.grid();
    const bool pixels = kernel == SplatKernel::pixels;
    const int batch = pixels ? kPixelBatch : kBatch;
    const auto run = [&](Gathering gathering) {
        if (!gather_programs_[gathering][0]) {
            build_gather_programs(gathering);
        }
        const gpu::Program& program = gather_programs_[gathering][listed ? 1 : 0];
        use_level(program, inputs, level, photons);
        program.set("local_length", local_length_);
        program.set("long_list", kLongList);
        hits_texture_.bind(4, photons.hits, GL_RGBA32F);
        tiles_.bind(program, 5);
        boundaries_.bind(6);
        weights_.bind(7);
        program.set("photon_hits", 4);
        program.set("boundaries", 6);
        program.set("weights", 7);
        listed_.bind_storage(2);
        tile_counts_.bind_storage(3);
        batches_.bind_storage(7);
        bad_values.bind_storage(4);
        level.image.bind_image(0, GL_WRITE_ONLY);
        if (listed) {
            glDispatchComputeIndirect(kBatchGroups);
        } else {
            glDispatchCompute(static_cast<GLuint>(grid.x * grid.y),
                              static_cast<GLuint>(std::max(side * side / batch, 1)), 1);
        }
    };
    if (pixels) {
        run(kPixels);
    } else {
        run(kBatches);
        if (photons.capacity > kLongList) {  // else no list can be
            run(kLongLists);
        }
    }
    wait_for_shaders();
}

void Splatting::choose_kernel(const render::FrameInputs& inputs, const PhotonSet& photons) {
    // One invocation sums a whole list by pixels.
    const bool too_long = gpu::draws_in_software() && photons.capacity > kLongList / kLanes;
    if (!wanted_kernel_ && !too_long) {
        const gpu::Buffer not_counted(sizeof(std::uint32_t));  // bad values, of which there will be as many
        const auto run = [&](SplatKernel kernel) {
            return [&, kernel] { gather(kernel, false, inputs, levels_.back(), photons, not_counted); };
        };
        wanted_kernel_ =
            other_is_faster("gather of splats", run(SplatKernel::batches), run(SplatKernel::pixels))
                ? SplatKernel::pixels
                : SplatKernel::batches;
    }
    kernel_ = too_long ? SplatKernel::batches : *wanted_kernel_;
}

const gpu::Texture& Splatting::irradiance(const render::FrameInputs& inputs, const EnvironmentMaps& maps,
                                          const PhotonSet& photons, const GiSettings& settings,
                                          bool surroundings_changed, const gpu::Buffer& bad_values) {
    local_length_ = maps.extent(inputs.scene);
    const int level_count = 1 + static_cast<int>(settings.of<EmcSettings>().splat_base);
    if (!neighbours_program_) {
        build_programs();
    }
    if (inputs.gbuffer.size() != size_ || level_count != static_cast<int>(levels_.size())) {
        allocate(inputs.gbuffer.size(), level_count);
        surroundings_changed = true;
    }
    if (photons.h_max != bandwidth_max_) {
        bandwidth_max_ = photons.h_max;
        surroundings_changed = true;
    }
    {
        const gpu::PassTimer::Scope scope(inputs.timer, "splat_sort");
        const bool glossy_fixed = settings.of<EmcSettings>().splat_glossy == GlossyBandwidth::fixed;
        tiles_.sort(inputs, photons, surroundings_changed, glossy_fixed ? photons.h_fixed : 0.0f);
    }
    if (std::exchange(bandwidth_, settings.of<EmcSettings>().splat_bandwidth) !=
        settings.of<EmcSettings>().splat_bandwidth) {
        for (gpu::Program(&programs)[2] : gather_programs_) {
            programs[0] = gpu::Program();
        }
    }
    {
        const gpu::PassTimer::Scope scope(inputs.timer, "splats");
        const Level& level = levels_.back();
        const ivec2 size(level.image.size());
        if (surroundings_changed) {
            use_boundaries(false, inputs, level, maps, photons, settings).dispatch(size, ivec2(8));
            wait_for_shaders();
        }
        choose_kernel(inputs, photons);
        gather(*kernel_, false, inputs, level, photons, bad_values);
    }
    const gpu::PassTimer::Scope scope(inputs.timer, "upsampling");
    if (surroundings_changed) {
        find_neighbours(inputs, photons.h_max);
    }
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, dispatches_.id());
    for (std::size_t l = levels_.size() - 1; l-- > 0;) {
        const Level& level = levels_[l];
        upsample(level, levels_[l + 1], settings.of<EmcSettings>().splat_contrast);
        use_boundaries(true, inputs, level, maps, photons, settings);
        glDispatchComputeIndirect(kNewGroups);
        wait_for_shaders();
        gather(*kernel_, true, inputs, level, photons, bad_values);
    }
    return levels_.front().image;
}

}  // namespace lanthorn::gi

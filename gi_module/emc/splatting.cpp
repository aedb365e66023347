#include "gi_module/emc/splatting.h"

#include <algorithm>

namespace lanthorn::gi {

namespace {

constexpr int kTileSize = 64;  // pixels a side
constexpr int kMaxChunks = 2048;
constexpr int kMinChunkSize = 32;

struct Chunks {
    int size;
    int count;
};

Chunks chunks_of(int hits) {
    const int size = std::max(kMinChunkSize, (hits + kMaxChunks - 1) / kMaxChunks);
    return {size, (hits + size - 1) / size};
}

}  // namespace

void Splatting::allocate(ivec2 size, int level_count) {
    const auto levels = static_cast<std::size_t>(level_count);
    if (size == size_ && levels == levels_.size()) {
        return;
    }
    if (!upsampling_program_) {
        tile_boxes_program_ = gpu::Program({"gi_module/emc/splat_tile_boxes.comp"});
        count_program_ = gpu::Program({"gi_module/emc/splat_count.comp"}, {"FILL 0"});
        fill_program_ = gpu::Program({"gi_module/emc/splat_count.comp"}, {"FILL 1"});
        for (int stage = 0; stage < 3; ++stage) {
            scan_programs_[stage] =
                gpu::Program({"gi_module/emc/splat_scan.comp"}, {"STAGE " + std::to_string(stage)});
        }
        upsampling_program_ = gpu::Program({"gi_module/emc/upsampling.comp"});
    }
    size_ = size;
    levels_.clear();
    for (std::size_t level = 0; level < levels; ++level) {
        const int stride = 1 << level;
        levels_.push_back(gpu::Texture::make_2d(GL_RGBA32F, (size + stride - 1) / stride));
    }
    tile_grid_ = (size + kTileSize - 1) / kTileSize;
    const auto tiles = static_cast<std::size_t>(tile_grid_.x) * static_cast<std::size_t>(tile_grid_.y);
    tile_boxes_ = gpu::Buffer(tiles * 2 * sizeof(vec4));
    starts_ = gpu::Buffer((tiles + 1) * sizeof(std::uint32_t));
    redo_ = gpu::Buffer((4 + static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y)) *
                        sizeof(std::uint32_t));
}

void Splatting::build_gather_programs(Bandwidth bandwidth) {
    const std::string fixed = std::string("BANDWIDTH_FIXED ") + (bandwidth == Bandwidth::fixed ? "1" : "0");
    gather_program_ = gpu::Program({"gi_module/emc/splat_gather.comp"}, {"LISTED 0", fixed});
    gather_listed_program_ = gpu::Program({"gi_module/emc/splat_gather.comp"}, {"LISTED 1", fixed});
    bandwidth_ = bandwidth;
}

void Splatting::sort_into_tiles(const render::FrameInputs& inputs, const PhotonTracing& photons,
                                bool camera_changed) {
    const int tiles = tile_grid_.x * tile_grid_.y;
    const auto set_grid = [&](const gpu::Program& program) {
        inputs.camera.set(program);
        program.set("tile_grid", tile_grid_);
        program.set("image_size", size_);
        program.set("tile_size", kTileSize);
    };
    if (camera_changed) {
        tile_boxes_.bind_storage(2);
        tile_boxes_program_.use();
        set_grid(tile_boxes_program_);
        inputs.gbuffer.distance().bind(0);
        glDispatchCompute(static_cast<GLuint>(tiles), 1, 1);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    }
    const Chunks chunks = chunks_of(photons.hit_count());
    const std::size_t count_bytes =
        static_cast<std::size_t>(tiles) * static_cast<std::size_t>(chunks.count) * sizeof(std::uint32_t);
    if (counts_.bytes() < count_bytes) {
        counts_ = gpu::Buffer(count_bytes);
    } else {
        counts_.clear();
    }
    hits_texture_.bind(1, photons.hits(), GL_RGBA32F);
    boxes_texture_.bind(2, tile_boxes_, GL_RGBA32F);
    counts_.bind_storage(3);
    starts_.bind_storage(5);
    const auto run = [&](const gpu::Program& program) {
        program.use();
        set_grid(program);
        program.set("photon_hits", 1);
        program.set("tile_boxes", 2);
        program.set("hit_count", photons.hit_count());
        program.set("chunk_count", chunks.count);
        program.set("chunk_size", chunks.size);
        program.dispatch(chunks.count, 32);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    };
    run(count_program_);
    for (const gpu::Program& program : scan_programs_) {
        program.use();
        program.set("chunk_count", chunks.count);
        program.set("tile_count", tiles);
        program.dispatch(tiles, 32);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    }
    // The lists' length decides their storage: one number comes back to the CPU.
    const std::size_t entries =
        starts_.read<std::uint32_t>(1, static_cast<std::size_t>(tiles) * sizeof(std::uint32_t))[0];
    if (lists_.bytes() < entries * sizeof(std::uint32_t)) {
        lists_ = gpu::Buffer(entries * 5 / 4 * sizeof(std::uint32_t));
    }
    lists_.bind_storage(4);
    run(fill_program_);
}

void Splatting::prepare_gather(const gpu::Program& program, const render::FrameInputs& inputs,
                               const EnvironmentMaps& maps, const PhotonTracing& photons,
                               const GiSettings& settings) {
    program.use();
    inputs.camera.set(program);
    maps.bind(program, 0, 1, settings, inputs.scene);
    inputs.gbuffer.distance().bind(2);
    inputs.gbuffer.normals().bind(3);
    program.set("gbuffer_distance", 2);
    program.set("gbuffer_normals", 3);
    program.set("image_size", size_);
    program.set("tile_grid", tile_grid_);
    program.set("tile_size", kTileSize);
    program.set("bandwidth_max", photons.bandwidth_max());
    hits_texture_.bind(4, photons.hits(), GL_RGBA32F);
    lists_texture_.bind(5, lists_, GL_R32UI);
    program.set("photon_hits", 4);
    program.set("photon_lists", 5);
    starts_.bind_storage(5);
    redo_.bind_storage(6);
}

const gpu::Texture& Splatting::irradiance(const render::FrameInputs& inputs, const EnvironmentMaps& maps,
                                          const PhotonTracing& photons, const GiSettings& settings,
                                          bool camera_changed) {
    const bool resized = inputs.gbuffer.size() != size_;
    allocate(inputs.gbuffer.size(), 1 + static_cast<int>(settings.splat_base));
    if (!gather_program_ || settings.splat_bandwidth != bandwidth_) {
        build_gather_programs(settings.splat_bandwidth);
    }
    {
        const gpu::PassTimer::Scope scope(inputs.timer, "splat_sort");
        sort_into_tiles(inputs, photons, camera_changed || resized);
    }
    constexpr GLbitfield kBarrier = GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                                    GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT;
    const int top = static_cast<int>(levels_.size()) - 1;
    {
        const gpu::PassTimer::Scope scope(inputs.timer, "splats");
        const gpu::Texture& level = levels_[static_cast<std::size_t>(top)];
        prepare_gather(gather_program_, inputs, maps, photons, settings);
        gather_program_.set("stride", 1 << top);
        level.bind_image(0, GL_WRITE_ONLY);
        gather_program_.dispatch(ivec2(level.size()), ivec2(8));
        glMemoryBarrier(kBarrier);
    }
    const gpu::PassTimer::Scope scope(inputs.timer, "upsampling");
    for (int l = top - 1; l >= 0; --l) {
        const gpu::Texture& level = levels_[static_cast<std::size_t>(l)];
        constexpr std::uint32_t kHeader[4] = {0, 0, 1, 1};  // nothing listed; groups x, y, z
        redo_.write_bytes(0, kHeader, sizeof(kHeader));
        upsampling_program_.use();
        inputs.camera.set(upsampling_program_);
        inputs.gbuffer.distance().bind(0);
        inputs.gbuffer.normals().bind(1);
        levels_[static_cast<std::size_t>(l) + 1].bind(2);
        upsampling_program_.set("gbuffer_distance", 0);
        upsampling_program_.set("gbuffer_normals", 1);
        upsampling_program_.set("coarse", 2);
        upsampling_program_.set("image_size", size_);
        upsampling_program_.set("stride", 1 << l);
        upsampling_program_.set("contrast", settings.splat_contrast);
        redo_.bind_storage(6);
        level.bind_image(0, GL_WRITE_ONLY);
        upsampling_program_.dispatch(ivec2(level.size()), ivec2(8));
        glMemoryBarrier(kBarrier);
        prepare_gather(gather_listed_program_, inputs, maps, photons, settings);
        gather_listed_program_.set("stride", 1 << l);
        level.bind_image(0, GL_WRITE_ONLY);
        glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, redo_.id());
        glDispatchComputeIndirect(sizeof(std::uint32_t));
        glMemoryBarrier(kBarrier);
    }
    return levels_.front();
}

}  // namespace lanthorn::gi

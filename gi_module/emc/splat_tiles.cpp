#include "lanthorn/gi/emc/splat_tiles.h"

#include <algorithm>

namespace lanthorn::gi {

namespace {

constexpr int kTilesPerInvocation = 8;  // splat_count.comp
constexpr int kMaxChunks = 2048;
constexpr int kRun = 32;  // chunks are multiples of it

struct Chunks {
    int size;
    int count;
};

Chunks chunks_of(int hits) {
    const int size = (std::max(1, (hits + kMaxChunks - 1) / kMaxChunks) + kRun - 1) / kRun * kRun;
    return {size, (hits + size - 1) / size};
}

}  // namespace

void SplatTiles::resize(ivec2 image_size) {
    if (!count_program_) {
        boxes_program_ = gpu::Program({"gi_module/emc/splat_tile_boxes.comp"});
        count_program_ = gpu::Program({"gi_module/emc/splat_count.comp"}, {"FILL 0"});
        fill_program_ = gpu::Program({"gi_module/emc/splat_count.comp"}, {"FILL 1"});
        for (int stage = 0; stage < 3; ++stage) {
            scan_programs_[stage] =
                gpu::Program({"gi_module/emc/splat_scan.comp"}, {"STAGE " + std::to_string(stage)});
        }
    }
    image_size_ = image_size;
    grid_ = (image_size + kTileSize - 1) / kTileSize;
    const auto tiles = static_cast<std::size_t>(grid_.x) * static_cast<std::size_t>(grid_.y);
    boxes_ = gpu::Buffer(tiles * 2 * sizeof(vec4));
    starts_ = gpu::Buffer((tiles + 1) * sizeof(std::uint32_t));
}

void SplatTiles::sort(const render::FrameInputs& inputs, const PhotonSet& photons, bool surfaces_changed) {
    const int tiles = grid_.x * grid_.y;
    if (surfaces_changed) {
        boxes_program_.use();
        inputs.camera.set(boxes_program_);
        boxes_program_.set("tile_grid", grid_);
        boxes_program_.set("image_size", image_size_);
        boxes_program_.set("tile_size", kTileSize);
        inputs.gbuffer.distance().bind(0);
        boxes_.bind_storage(2);
        glDispatchCompute(static_cast<GLuint>(tiles), 1, 1);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    }
    const Chunks chunks = chunks_of(photons.capacity);
    const std::size_t count_bytes =
        static_cast<std::size_t>(tiles) * static_cast<std::size_t>(chunks.count) * sizeof(std::uint32_t);
    if (counts_.bytes() < count_bytes) {
        counts_ = gpu::Buffer(count_bytes);
    }
    hits_texture_.bind(1, photons.hits, GL_RGBA32F);
    boxes_texture_.bind(2, boxes_, GL_RGBA32F);
    counts_.bind_storage(3);
    starts_.bind_storage(5);
    photons.count.bind_storage(6);
    const auto run = [&](const gpu::Program& program) {
        program.use();
        program.set("photon_hits", 1);
        program.set("tile_boxes", 2);
        program.set("chunk_count", chunks.count);
        program.set("chunk_size", chunks.size);
        program.set("tile_count", tiles);
        program.dispatch({(tiles + kTilesPerInvocation - 1) / kTilesPerInvocation, chunks.count}, ivec2(8));
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
    // The lists' lengths decide their storage and how they are worked off: they come back to the CPU.
    const auto starts = starts_.read<std::uint32_t>(static_cast<std::size_t>(tiles) + 1);
    const std::size_t entries = starts.back();
    longest_list_ = 0;
    for (std::size_t tile = 0; tile + 1 < starts.size(); ++tile) {
        longest_list_ = std::max(longest_list_, starts[tile + 1] - starts[tile]);
    }
    if (lists_.bytes() < entries * sizeof(std::uint32_t)) {
        lists_ = gpu::Buffer(entries * 5 / 4 * sizeof(std::uint32_t));
    }
    lists_.bind_storage(4);
    run(fill_program_);
}

}  // namespace lanthorn::gi

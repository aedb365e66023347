#include "lanthorn/gi/emc/splat_tiles.h"

#include <algorithm>
#include <cstring>

namespace lanthorn::gi {

namespace {

constexpr int kTilesPerInvocation = 8;  // splat_count.comp
constexpr int kMaxChunks = 2048;
constexpr int kRun = 32;  // chunks are multiples of it

struct Totals {  // splat_tiles.glsl
    std::uint32_t entries, photons, longest, padding;
};
static_assert(sizeof(Totals) == 16);

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
        totals_.reserve(sizeof(Totals));
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
    starts_ = gpu::Buffer(sizeof(Totals) + (tiles + 1) * sizeof(std::uint32_t));
}

void SplatTiles::make_room(std::size_t photons) {
    const auto tiles = static_cast<std::size_t>(grid_.x) * static_cast<std::size_t>(grid_.y);
    std::size_t wanted = std::min(tiles * photons, std::max(entries_, entries_a_photon_ * photons));
    while (const auto arrived = totals_.wait()) {
        Totals before{};
        std::memcpy(&before, arrived->bytes.data(), sizeof(before));
        const auto room = static_cast<std::size_t>(arrived->tag);
        statistics_.entries = before.entries;
        if (before.entries > room) {
            ++statistics_.overflows;
            wanted = std::max(wanted, static_cast<std::size_t>(before.entries) + before.entries / 4);
        }
    }
    if (lists_.bytes() < wanted * sizeof(std::uint32_t)) {
        lists_ = gpu::Buffer(wanted * sizeof(std::uint32_t));
    }
    statistics_.capacity = lists_.bytes() / sizeof(std::uint32_t);
}

void SplatTiles::sort(const render::FrameInputs& inputs, const PhotonSet& photons, bool surfaces_changed) {
    const int tiles = grid_.x * grid_.y;
    make_room(static_cast<std::size_t>(photons.capacity));
    const auto capacity = static_cast<int>(statistics_.capacity);
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
        program.set("list_capacity", capacity);
        program.dispatch({(tiles + kTilesPerInvocation - 1) / kTilesPerInvocation, chunks.count}, ivec2(8));
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    };
    run(count_program_);
    for (const gpu::Program& program : scan_programs_) {
        program.use();
        program.set("chunk_count", chunks.count);
        program.set("tile_count", tiles);
        program.set("list_capacity", capacity);
        program.dispatch(tiles, 32);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    }
    totals_.begin(starts_, sizeof(Totals), statistics_.capacity);
    lists_.bind_storage(4);
    run(fill_program_);
}

void SplatTiles::bind(const gpu::Program& program, GLuint lists_unit) {
    lists_texture_.bind(lists_unit, lists_, GL_R32UI);
    starts_.bind_storage(5);
    program.set("photon_lists", static_cast<int>(lists_unit));
    program.set("list_capacity", static_cast<int>(statistics_.capacity));
    program.set("tile_grid", grid_);
    program.set("tile_size", kTileSize);
}

}  // namespace lanthorn::gi

#include "gi_module/techniques/emc/splat/splat_tiles.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "gi_module/techniques/emc/faster.h"

namespace lanthorn::gi {

namespace {

constexpr int kTilesPerInvocation = 8;  // splat_count.comp
constexpr int kMaxChunks = 2048;
constexpr int kChunkUnit = 32;  // chunks are multiples of it

struct Totals {  // splat_tiles.glsl
    std::uint32_t entries, photons, longest, padding;
};
static_assert(sizeof(Totals) == 16 && offsetof(Totals, photons) == 4 && offsetof(Totals, longest) == 8);

void wait_for_lists() {
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

}  // namespace

SplatTiles::Chunks SplatTiles::chunks_of(int hits) {
    const int size =
        (std::max(1, (hits + kMaxChunks - 1) / kMaxChunks) + kChunkUnit - 1) / kChunkUnit * kChunkUnit;
    return {size, (hits + size - 1) / size};
}

void SplatTiles::resize(ivec2 image_size) {
    if (!boxes_program_) {
        totals_.reserve(sizeof(Totals));
        boxes_program_ = gpu::Program({"gi_module/techniques/emc/splat/splat_tile_boxes.comp"});
        rects_program_ = gpu::Program({"gi_module/techniques/emc/splat/splat_rects.comp"});
        for (int stage = 0; stage < 3; ++stage) {
            scan_programs_[stage] = gpu::Program({"gi_module/techniques/emc/splat/splat_scan.comp"},
                                                 {"STAGE " + std::to_string(stage)});
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
    std::size_t wanted =
        std::min(tiles * photons, std::max(options_.entries, options_.entries_a_photon * photons));
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

void SplatTiles::find_boxes(const render::FrameInputs& inputs) {
    boxes_program_.use();
    inputs.camera.set(boxes_program_);
    boxes_program_.set("tile_grid", grid_);
    boxes_program_.set("image_size", image_size_);
    boxes_program_.set("tile_size", kTileSize);
    inputs.gbuffer.distance().bind(0);
    boxes_.bind_storage(2);
    glDispatchCompute(static_cast<GLuint>(grid_.x * grid_.y), 1, 1);
    wait_for_lists();
}

void SplatTiles::find_rects(const render::FrameInputs& inputs, const PhotonSet& photons) {
    const std::size_t bytes = static_cast<std::size_t>(photons.capacity) * sizeof(std::uint32_t);
    if (rects_.bytes() < bytes) {
        rects_ = gpu::Buffer(bytes);
    }
    rects_program_.use();
    inputs.camera.set(rects_program_);
    rects_program_.set("photon_hits", 1);
    rects_program_.set("least_radius", least_radius_);
    rects_program_.set("tile_grid", grid_);
    rects_program_.set("image_size", image_size_);
    rects_program_.set("tile_size", kTileSize);
    rects_.bind_storage(7);
    rects_program_.dispatch(photons.capacity, 64);
    wait_for_lists();
}

void SplatTiles::bin(SplatBinning binning, bool fill, const Chunks& chunks) {
    const bool by_tile = binning == SplatBinning::by_tile;
    gpu::Program& program = bin_programs_[by_tile ? 0 : 1][fill ? 1 : 0];
    if (!program) {
        program = gpu::Program({by_tile ? "gi_module/techniques/emc/splat/splat_count.comp"
                                        : "gi_module/techniques/emc/splat/splat_project.comp"},
                               {fill ? "FILL 1" : "FILL 0"});
    }
    const int tiles = grid_.x * grid_.y;
    program.use();
    program.set("photon_hits", 1);
    program.set("least_radius", least_radius_);
    program.set("tile_boxes", 2);
    program.set("photon_rects", 3);
    program.set("tile_grid", grid_);
    program.set("chunk_count", chunks.count);
    program.set("chunk_size", chunks.size);
    program.set("tile_count", tiles);
    program.set("list_capacity", static_cast<int>(statistics_.capacity));
    if (by_tile) {
        program.dispatch({(tiles + kTilesPerInvocation - 1) / kTilesPerInvocation, chunks.count}, ivec2(8));
    } else {
        glDispatchCompute(static_cast<GLuint>(chunks.count), 1, 1);
    }
    wait_for_lists();
}

void SplatTiles::sort(const render::FrameInputs& inputs, const PhotonSet& photons, bool surfaces_changed,
                      float least_radius) {
    least_radius_ = least_radius;
    const int tiles = grid_.x * grid_.y;
    make_room(static_cast<std::size_t>(photons.capacity));
    if (surfaces_changed) {
        find_boxes(inputs);
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
    find_rects(inputs, photons);
    rects_texture_.bind(3, rects_, GL_R32UI);
    // Rectangles are of 128 tiles a side at most (splat_rects.glsl).
    const bool large = std::max(grid_.x, grid_.y) > 128;
    if (!binning_ && !large) {
        const bool by_photon = other_is_faster(
            "binning of " + options_.use, [&] { bin(SplatBinning::by_tile, false, chunks); },
            [&] { bin(SplatBinning::by_photon, false, chunks); });
        binning_ = by_photon ? SplatBinning::by_photon : SplatBinning::by_tile;
    }
    const SplatBinning binning = large ? SplatBinning::by_tile : *binning_;
    bin(binning, false, chunks);
    for (const gpu::Program& program : scan_programs_) {
        program.use();
        program.set("chunk_count", chunks.count);
        program.set("tile_count", tiles);
        program.set("list_capacity", static_cast<int>(statistics_.capacity));
        program.dispatch(tiles, 32);
        wait_for_lists();
    }
    totals_.begin(starts_, sizeof(Totals), statistics_.capacity);
    lists_.bind_storage(4);
    bin(binning, true, chunks);
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

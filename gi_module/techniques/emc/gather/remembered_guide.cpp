#include "gi_module/techniques/emc/gather/remembered_guide.h"

#include <algorithm>

#include "gi_module/techniques/emc/gather/remembered_hits.h"
#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

constexpr int kTile = 8;  // points a side: remembered_guide.glsl
constexpr std::size_t kCells = kTile * kTile;

ivec2 tiles_of(ivec2 grid) {
    return (grid + kTile - 1) / kTile;
}

}  // namespace

void RememberedGuide::build_programs() {
    if (!begin_) {
        begin_ = gpu::Program({"gi_module/techniques/emc/gather/remembered_guide_begin.comp"});
        add_ = gpu::Program({"gi_module/techniques/emc/gather/remembered_guide_add.comp"});
        level_ = gpu::Program({"gi_module/techniques/emc/gather/remembered_guide_level.comp"});
        rays_ = gpu::Program({"gi_module/techniques/emc/gather/remembered_guide_rays.comp"});
    }
}

void RememberedGuide::resize(ivec2 grid, std::size_t starts) {
    const ivec2 tiles = tiles_of(grid);
    const auto count = static_cast<std::size_t>(tiles.x) * static_cast<std::size_t>(tiles.y);
    cells_ = gpu::Buffer(count * kCells * 2 * sizeof(std::uint32_t));
    means_ = gpu::Buffer(count * sizeof(float));
    levels_ = gpu::Buffer(count * kCells * sizeof(float));
    starts_.resize(starts);
    forget();
}

void RememberedGuide::update(const Hits& hits, const gpu::Buffer& radiosity, int slot) {
    const bool all = frames_ < RememberedHits::kFrames;
    begin_.use();
    irradiance_view_.bind(0, hits.irradiance, GL_RGBA32F);
    counts_view_.bind(1, hits.counts, GL_R32UI);
    begin_.set("irradiance", 0);
    begin_.set("counts", 1);
    begin_.set("grid", hits.grid);
    begin_.set("slots", all ? 1u : static_cast<std::uint32_t>(hits.slots));
    cells_.bind_storage(2);
    means_.bind_storage(3);
    const ivec2 tiles = tiles_of(hits.grid);
    glDispatchCompute(static_cast<GLuint>(tiles.x), static_cast<GLuint>(tiles.y), 1);
    wait_for_shaders();
    hits.use(add_);
    radiosity_view_.bind(0, radiosity, GL_RGBA32F);
    cells_view_.bind(1, hits.cells, GL_RG32UI);
    means_view_.bind(2, means_, GL_R32F);
    add_.set("radiosity", 0);
    add_.set("cells", 1);
    add_.set("means", 2);
    add_.set("row", hits.grid.x);
    add_.set("slot", all ? -1 : slot);
    dispatch_rows(hits.grid.x * hits.grid.y, all ? hits.slots : 1);
    wait_for_shaders();
    level_.use();
    cells_view_.bind(0, cells_, GL_RG32UI);
    means_view_.bind(1, means_, GL_R32F);
    level_.set("guide", 0);
    level_.set("means", 1);
    levels_.bind_storage(2);
    glDispatchCompute(static_cast<GLuint>(tiles.x), static_cast<GLuint>(tiles.y), 1);
    wait_for_shaders();
    frames_ = std::min(frames_ + 1, RememberedHits::kFrames);
}

void RememberedGuide::bind(const gpu::Program& program, GLuint unit, GLuint starts_binding) {
    starts_.clear();
    starts_.bind_storage(starts_binding);
    means_view_.bind(unit, means_, GL_R32F);
    program.set("guide_means", static_cast<int>(unit));
}

void RememberedGuide::guide(const Hits& hits, std::uint32_t seed) {
    hits.use(rays_);
    levels_view_.bind(0, levels_, GL_R32F);
    rays_.set("guide", 0);
    rays_.set("row", hits.grid.x);
    rays_.set("seed", seed);
    rays_.set("pass", 0);
    starts_.bind_storage(6);
    starts_.dispatch();
    wait_for_shaders();
}

}  // namespace lanthorn::gi

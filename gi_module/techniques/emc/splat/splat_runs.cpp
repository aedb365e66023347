#include "gi_module/techniques/emc/splat/splat_runs.h"

#include <algorithm>

#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

constexpr int kBlock = 8;  // pixels a side of what a work group sums
constexpr int kRun = 32'768;

}  // namespace

void SplatRuns::find(SplatTiles& tiles, int photons, ivec2 size) {
    if (!program_) {
        program_ = gpu::Program({"gi_module/techniques/emc/splat/splat_runs.comp"});
    }
    runs_ = std::max(1, (photons + kRun - 1) / kRun);
    const std::size_t bytes = 3 * sizeof(GLuint) * static_cast<std::size_t>(runs_);
    if (groups_.bytes() < bytes) {
        groups_ = gpu::Buffer(bytes);
    }
    program_.use();
    tiles.bind(program_, 0);
    groups_.bind_storage(0);
    program_.set("dispatch_count", runs_);
    program_.set("run", kRun);
    program_.set("blocks", (size + kBlock - 1) / kBlock);
    program_.dispatch(runs_, 64);
    wait_for_shaders();
}

void SplatRuns::dispatch(const gpu::Program& program) const {
    program.use();
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, groups_.id());
    program.set("entries", kRun);
    for (int run = 0; run < runs_; ++run) {
        program.set("first_entry", run * kRun);
        glDispatchComputeIndirect(static_cast<GLintptr>(run) * 3 * static_cast<GLintptr>(sizeof(GLuint)));
        wait_for_shaders();
    }
}

}  // namespace lanthorn::gi

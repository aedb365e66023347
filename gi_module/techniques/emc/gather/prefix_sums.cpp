#include "gi_module/techniques/emc/gather/prefix_sums.h"

#include <cstdint>

#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {
constexpr std::size_t kBlock = 2048;  // prefix_sums.glsl
}

void PrefixSums::resize(std::size_t count) {
    count_ = count;
    sums_ = gpu::Buffer(count * sizeof(std::uint32_t));
    blocks_ = gpu::Buffer((count + kBlock - 1) / kBlock * sizeof(std::uint32_t));
}

void PrefixSums::add_up(const gpu::Buffer& counts) {
    if (!add_up_) {
        add_blocks_ = gpu::Program({"gi_module/techniques/emc/gather/prefix_blocks.comp"});
        add_up_ = gpu::Program({"gi_module/techniques/emc/gather/prefix_sums.comp"});
    }
    const auto blocks = static_cast<GLuint>((count_ + kBlock - 1) / kBlock);
    counts_view_.bind(0, counts, GL_R32UI);
    for (const gpu::Program* program : {&add_blocks_, &add_up_}) {
        program->set("counts", 0);
        program->set("count", static_cast<int>(count_));
    }
    add_blocks_.use();
    blocks_.bind_storage(2);
    glDispatchCompute(blocks, 1, 1);
    wait_for_shaders();
    add_up_.use();
    blocks_view_.bind(1, blocks_, GL_R32UI);
    add_up_.set("blocks", 1);
    sums_.bind_storage(2);
    glDispatchCompute(blocks, 1, 1);
    wait_for_shaders();
}

}  // namespace lanthorn::gi

// Programs that ask what movers have crossed (swept_boxes.glsl), one for each power of two of boxes.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "gi_module/techniques/emc/gather/swept_boxes.h"
#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"

namespace lanthorn::gi {

class MoverPrograms {
  public:
    MoverPrograms(std::vector<std::filesystem::path> stages, std::vector<std::string> defines)
        : stages_(std::move(stages)), defines_(std::move(defines)) {}

    // The program for so many boxes, at most SweptBoxes::kMost, compiled when first asked for, in use, with
    // these widened by `margin` metres.
    const gpu::Program& use(const std::vector<Aabb>& swept, float margin);
    // The same by the cells that many movers sweep, which is bound to a texture unit (GRID 1).
    const gpu::Program& use(const SweptGrid& grid, GLuint unit);

  private:
    static constexpr std::size_t kKinds = 5;
    static_assert(1u << (kKinds - 1) == SweptBoxes::kMost);

    std::vector<std::filesystem::path> stages_;
    std::vector<std::string> defines_;
    std::array<gpu::Program, kKinds> programs_;
    gpu::Program grid_program_;
    gpu::Buffer grid_columns_;
    gpu::BufferTexture grid_view_;
};

}  // namespace lanthorn::gi

// Programs that ask what movers have crossed (swept_boxes.glsl), one for each power of two of boxes.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "lanthorn/gi/emc/swept_boxes.h"
#include "lanthorn/gpu/program.h"

namespace lanthorn::gi {

class MoverPrograms {
  public:
    MoverPrograms(std::vector<std::filesystem::path> stages, std::vector<std::string> defines)
        : stages_(std::move(stages)), defines_(std::move(defines)) {}

    // The program for so many boxes, at most SweptBoxes::kMost, compiled when first asked for, in use, with
    // these widened by `margin` metres.
    const gpu::Program& use(const std::vector<Aabb>& swept, float margin);

  private:
    static constexpr std::size_t kKinds = 5;
    static_assert(1u << (kKinds - 1) == SweptBoxes::kMost);

    std::vector<std::filesystem::path> stages_;
    std::vector<std::string> defines_;
    std::array<gpu::Program, kKinds> programs_;
};

}  // namespace lanthorn::gi

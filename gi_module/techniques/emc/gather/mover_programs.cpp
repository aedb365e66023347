#include "gi_module/techniques/emc/gather/mover_programs.h"

#include <algorithm>
#include <bit>
#include <span>

namespace lanthorn::gi {

namespace {

// Of a box that no ray gets to.
constexpr float kFarAway = 1e12f;  // metres

}  // namespace

const gpu::Program& MoverPrograms::use(const std::vector<Aabb>& swept, float margin) {
    const std::size_t boxes = std::bit_ceil(std::max<std::size_t>(swept.size(), 1));
    gpu::Program& program = programs_.at(static_cast<std::size_t>(std::countr_zero(boxes)));
    if (!program) {
        std::vector<std::string> defines = defines_;
        defines.push_back("GRID 0");
        defines.push_back("BOXES " + std::to_string(boxes));
        program = gpu::Program(stages_, defines);
    }
    std::vector<vec4> lower(boxes, vec4(kFarAway)), upper(boxes, vec4(kFarAway));
    for (std::size_t i = 0; i < swept.size(); ++i) {
        lower[i] = vec4(swept[i].lower - margin, 0);
        upper[i] = vec4(swept[i].upper + margin, 0);
    }
    program.use();
    program.set("box_lower", lower);
    program.set("box_upper", upper);
    return program;
}

const gpu::Program& MoverPrograms::use(const SweptGrid& grid, GLuint unit) {
    if (!grid_program_) {
        std::vector<std::string> defines = defines_;
        defines.push_back("GRID 1");
        grid_program_ = gpu::Program(stages_, defines);
        grid_columns_ = gpu::Buffer(grid.columns().size() * sizeof(std::uint32_t));
    }
    grid_columns_.write(0, std::span<const std::uint32_t>(grid.columns()));
    grid_view_.bind(unit, grid_columns_, GL_R32UI);
    grid_program_.use();
    grid_program_.set("grid_columns", static_cast<int>(unit));
    grid_program_.set("grid_lower", grid.lower());
    grid_program_.set("grid_scale", grid.cells_a_metre());
    grid_program_.set("grid_up", grid.up());
    return grid_program_;
}

}  // namespace lanthorn::gi

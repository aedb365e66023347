#include "engine/render/scene_program.h"

namespace lanthorn::render {

SceneProgram::SceneProgram(const std::filesystem::path& vertex, const std::filesystem::path& fragment)
    : variants_{gpu::Program({vertex, fragment}, {"UNTEXTURED"}), gpu::Program({vertex, fragment}),
                gpu::Program({vertex, fragment}, {"MASKED"})} {}

std::string SceneProgram::reload_if_changed() {
    std::string messages;
    for (gpu::Program& program : variants_) {
        messages += program.reload_if_changed();
    }
    return messages;
}

}  // namespace lanthorn::render

#include "lanthorn/render/scene_program.h"

#include <utility>

namespace lanthorn::render {

SceneProgram::SceneProgram(std::filesystem::path vertex, std::filesystem::path fragment,
                           std::vector<std::string> defines)
    : vertex_(std::move(vertex)), fragment_(std::move(fragment)), defines_(std::move(defines)) {
    prepare(std::vector<MaterialVariant>{0});
}

void SceneProgram::prepare(std::span<const MaterialVariant> variants) {
    for (const MaterialVariant variant : variants) {
        if (variants_.contains(variant)) {
            continue;
        }
        std::vector<std::string> defines = defines_;
        defines.push_back("TEXTURES " + std::to_string(variant & 0xffu) + "u");
        if ((variant & kMaskedVariant) != 0) {
            defines.push_back("MASKED");
        }
        variants_.emplace(variant, gpu::Program({vertex_, fragment_}, defines));
    }
}

}  // namespace lanthorn::render

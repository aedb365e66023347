#include "lanthorn/render/scene_program.h"

#include <utility>
#include <vector>

namespace lanthorn::render {

SceneProgram::SceneProgram(std::filesystem::path vertex, std::filesystem::path fragment)
    : vertex_(std::move(vertex)), fragment_(std::move(fragment)) {
    prepare(std::vector<MaterialVariant>{0});
}

void SceneProgram::prepare(std::span<const MaterialVariant> variants) {
    for (const MaterialVariant variant : variants) {
        if (variants_.contains(variant)) {
            continue;
        }
        std::vector<std::string> defines{"TEXTURES " + std::to_string(variant & 0xffu) + "u"};
        if ((variant & kMaskedVariant) != 0) {
            defines.push_back("MASKED");
        }
        variants_.emplace(variant, gpu::Program({vertex_, fragment_}, defines));
    }
}

}  // namespace lanthorn::render

#include "engine/render/display_pass.h"

#include <string>
#include <utility>
#include <vector>

#include "engine/render/composite_state.h"
#include "engine/render/fullscreen.h"

namespace lanthorn::render {

void DisplayPass::draw(const Inputs& inputs, const RenderSettings& settings, const Target& target) {
    const auto& [scattered, fuzzy] = inputs.over;
    std::vector<std::string> defines;
    for (const auto& [there, define] :
         {std::pair(scattered != nullptr, "WITH_BLOOM"), std::pair(fuzzy != nullptr, "WITH_RIM"),
          std::pair(settings.shoulder > 0, "WITH_SHOULDER")}) {
        if (there) {
            defines.emplace_back(define);
        }
    }
    const bool compute = in_compute(settings.pixel_stage);
    const gpu::Program& program = (compute ? compute_ : fragments_).with(defines);
    inputs.state.bind_storage(kCompositeStateBinding);
    program.set("radiance", 0);
    inputs.radiance.bind(0);
    if (scattered != nullptr) {
        program.set("scattered", 1);
        program.set("scattered_share", settings.bloom_share);
        scattered->bind(1);
    }
    if (fuzzy != nullptr) {
        fuzzy->gbuffer.distance().bind(2);
        fuzzy->gbuffer.normals().bind(3);
        fuzzy->gbuffer.material().bind(4);
        program.set("gbuffer_distance", 2);
        program.set("gbuffer_normals", 3);
        program.set("gbuffer_material", 4);
        program.set("rim_depth", settings.rim);
        fuzzy->camera.set(program);
    }
    if (settings.shoulder > 0) {
        program.set("shoulder", settings.shoulder);
    }
    program.set("tone_map", static_cast<int>(settings.tone_map));
    if (compute) {
        compute_fullscreen(program, target.final, target.size);
    } else {
        draw_fullscreen(program, target.framebuffer, target.size);
    }
}

}  // namespace lanthorn::render

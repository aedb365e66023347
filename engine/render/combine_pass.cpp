#include "engine/render/combine_pass.h"

#include <string>
#include <utility>
#include <vector>

#include "engine/render/composite_state.h"
#include "engine/render/fullscreen.h"

namespace lanthorn::render {

void CombinePass::draw(const Inputs& inputs, PixelStage stage, const Target& target) {
    const GBuffer& gbuffer = inputs.gbuffer;
    const Composite::Parts& parts = inputs.parts;
    struct Sampled {
        const char* name;
        const gpu::Texture* texture;
    };
    const Sampled textures[] = {{"gbuffer_distance", &gbuffer.distance()},
                                {"gbuffer_normals", &gbuffer.normals()},
                                {"gbuffer_albedo", &gbuffer.albedo()},
                                {"gbuffer_material", &gbuffer.material()},
                                {"gbuffer_emissive", &gbuffer.emissive()},
                                {"direct_radiance", parts.direct},
                                {"indirect_irradiance", parts.indirect_irradiance},
                                {"indirect_specular", parts.indirect_specular}};
    std::vector<std::string> defines;
    for (const auto& [there, define] : {std::pair(!inputs.sky.empty(), "WITH_SKY"),
                                        std::pair(parts.indirect_irradiance != nullptr, "WITH_IRRADIANCE"),
                                        std::pair(parts.indirect_specular != nullptr, "WITH_SPECULAR")}) {
        if (there) {
            defines.emplace_back(define);
        }
    }
    const bool compute = in_compute(stage);
    const gpu::Program& program = (compute ? compute_ : fragments_).with(defines);
    inputs.state.bind_storage(kCompositeStateBinding);
    GLuint unit = 0;
    for (const Sampled& sampled : textures) {
        (sampled.texture != nullptr ? sampled.texture : parts.direct)->bind(unit);
        program.set(sampled.name, static_cast<int>(unit++));
    }
    if (!inputs.sky.empty()) {
        inputs.sky.bind(program, unit++);
    }
    inputs.brdf_table.bind(program, unit++);
    inputs.camera.set(program);
    program.set("emissive_scale", gbuffer.emissive_scale());
    if (compute) {
        compute_fullscreen(program, target.radiance, target.size);
    } else {
        draw_fullscreen(program, target.framebuffer, target.size);
    }
}

}  // namespace lanthorn::render

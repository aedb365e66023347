#include "gi_module/techniques/drm/drm_gather.h"

#include <string>
#include <vector>

#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

const gpu::Program& DrmGather::program(bool lobes, bool in_block, bool hidden) {
    gpu::Program& program = programs_[{lobes, in_block, hidden}];
    if (!program) {
        std::vector<std::string> defines{std::string("GLOSSY ") + (lobes ? "1" : "0")};
        if (in_block) {
            defines.emplace_back("SAMPLES_IN_BLOCK 1");
        }
        if (hidden) {
            defines.emplace_back("SAMPLES_ARE_HIDDEN 1");
        }
        program = gpu::Program({"gi_module/techniques/drm/drm_gather.comp"}, defines);
    }
    return program;
}

render::IndirectLight DrmGather::light(const render::FrameInputs& inputs, const RadianceMap& map, bool lobes,
                                       const gpu::Texture* mirrored, float most_roughness,
                                       const gpu::Buffer& bad_values) {
    const ivec2 size = inputs.gbuffer.size();
    if (!irradiance_ || ivec2(irradiance_.size()) != size) {
        irradiance_ = gpu::Texture::make_2d(GL_RGBA32F, size);
        specular_ = gpu::Texture();
    }
    const bool in_block = map.fits_block();
    const gpu::Program& gather = program(lobes, in_block, map.hides());
    use_surfaces(gather, inputs);
    map.bind(gather, in_block);
    bad_values.bind_storage(5);
    irradiance_.bind_image(0, GL_WRITE_ONLY);
    if (lobes) {
        if (!specular_) {
            specular_ = gpu::Texture::make_2d(GL_RGBA32F, size);
        }
        specular_.bind_image(1, GL_WRITE_ONLY);
        inputs.gbuffer.albedo().bind(2);
        inputs.gbuffer.material().bind(3);
        gather.set("gbuffer_albedo", 2);
        gather.set("gbuffer_material", 3);
        table_.bind(gather, 4);
        gather.set("most_roughness", most_roughness);
        gather.set("has_mirrored", mirrored != nullptr ? 1 : 0);
        gather.set("mirrored", 5);
        if (mirrored != nullptr) {
            mirrored->bind(5);
        }
    }
    gather.dispatch(size, ivec2(8));
    wait_for_shaders();
    return {.irradiance = &irradiance_, .specular = lobes ? &specular_ : mirrored};
}

}  // namespace lanthorn::gi

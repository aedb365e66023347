#include "lanthorn/gi/emc/lit_texels.h"

#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

void LitTexels::list(const EnvironmentMaps& maps, const GiSettings& settings, const FrameScene& scene) {
    if (!program_) {
        program_ = gpu::Program({"gi_module/emc/lit_texels.comp"});
    }
    const int resolution = settings.emc_resolution >= 64 ? 64 : settings.emc_resolution >= 32 ? 32 : 16;
    const int faces = 6 * maps.slots();
    const int texels = faces * resolution * resolution;
    if (resolution != resolution_ || faces != faces_) {
        resolution_ = resolution;
        faces_ = faces;
        index_ = gpu::Buffer(static_cast<std::size_t>(texels) * sizeof(std::uint32_t));
        albedo_ = gpu::Buffer(static_cast<std::size_t>(texels) * sizeof(vec4));
    }
    points_.resize(texels, resolution_, 1);
    program_.use();
    maps.bind(program_, 0, 1, settings, scene);
    program_.set("lit_resolution", resolution_);
    program_.set("rays", 1);
    points_.bind_storage();
    index_.bind_storage(4);
    albedo_.bind_storage(5);
    dispatch_items(texels);
    wait_for_shaders();
}

void LitTexels::bind(const gpu::Program& program, gpu::BufferTexture& index, gpu::BufferTexture& points,
                     GLuint unit) const {
    index.bind(unit, index_, GL_R32UI);
    points.bind(unit + 1, points_.points(), GL_RGBA32F);
    program.set("lit_index", static_cast<int>(unit));
    program.set("lit_points", static_cast<int>(unit + 1));
    program.set("lit_resolution", resolution_);
}

}  // namespace lanthorn::gi

#include "lanthorn/gi/emc/lit_texels.h"

#include <algorithm>

#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

bool LitTexels::resize(const EnvironmentMaps& maps, const GiSettings& settings) {
    const int resolution = std::max(16, std::min(settings.gather_texels, settings.emc_resolution) / 16 * 16);
    const int faces = 6 * maps.slots();
    if (resolution == resolution_ && faces == faces_) {
        return false;
    }
    resolution_ = resolution;
    faces_ = faces;
    const int texels = faces * resolution * resolution;
    index_ = gpu::Buffer(static_cast<std::size_t>(texels) * sizeof(std::uint32_t));
    albedo_ = gpu::Buffer(static_cast<std::size_t>(texels) * sizeof(vec4));
    shown_ = gpu::Buffer(static_cast<std::size_t>(texels) * sizeof(vec4));
    changed_ = gpu::Buffer(static_cast<std::size_t>(texels) * sizeof(std::uint32_t));
    points_.resize(texels, resolution_, 1);
    return true;
}

void LitTexels::list(const EnvironmentMaps& maps, const GiSettings& settings, const FrameScene& scene,
                     const gpu::Buffer& radiosity) {
    if (!program_) {
        program_ = gpu::Program({"gi_module/emc/lit_texels.comp"});
    }
    const int texels = points_.capacity();
    points_.clear();
    program_.use();
    maps.bind(program_, 0, 1, settings, scene);
    program_.set("lit_resolution", resolution_);
    program_.set("rays", 1);
    points_.bind_storage();
    index_.bind_storage(4);
    albedo_.bind_storage(5);
    changed_.bind_storage(2);
    radiosity.bind_storage(6);
    shown_.bind_storage(7);
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

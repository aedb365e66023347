#include "gi_module/techniques/coarse-path/svgf_filter.h"

#include <utility>

namespace lanthorn::gi {

namespace {

void wait_for_level() {
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

}  // namespace

const gpu::Texture& SvgfFilter::filter(const render::FrameInputs& inputs, ivec2 cells,
                                       const gpu::Buffer& points, const gpu::Buffer& estimates, int levels,
                                       float sigma) {
    if (!variance_program_) {
        planes_program_ = gpu::Program({"gi_module/techniques/coarse-path/svgf_planes.comp"});
        variance_program_ = gpu::Program({"gi_module/techniques/coarse-path/svgf_variance.comp"});
        guided_program_ = gpu::Program({"gi_module/techniques/coarse-path/svgf_atrous.comp"}, {"GUIDED 1"});
        atrous_program_ = gpu::Program({"gi_module/techniques/coarse-path/svgf_atrous.comp"}, {"GUIDED 0"});
    }
    if (!planes_ || ivec2(planes_.size()) != cells) {
        for (gpu::Texture& light : light_) {
            light = gpu::Texture::make_2d(GL_RGBA32F, cells);
        }
        planes_ = gpu::Texture::make_2d(GL_RGBA32F, cells);
        guide_ = gpu::Texture::make_2d(GL_R32F, cells);
    }
    points_.bind(2, points, GL_RGBA32F);
    estimates_.bind(3, estimates, GL_RGBA32F);
    planes_program_.use();
    inputs.camera.set(planes_program_);
    planes_program_.set("points", 2);
    planes_program_.set("cells", cells);
    planes_.bind_image(0, GL_WRITE_ONLY);
    planes_program_.dispatch(cells, ivec2(8));
    wait_for_level();

    variance_program_.use();
    inputs.camera.set(variance_program_);
    planes_.bind(4);
    variance_program_.set("points", 2);
    variance_program_.set("estimates", 3);
    variance_program_.set("planes", 4);
    variance_program_.set("cells", cells);
    light_[0].bind_image(0, GL_WRITE_ONLY);
    guide_.bind_image(1, GL_WRITE_ONLY);
    variance_program_.dispatch(cells, ivec2(8));
    wait_for_level();

    guide_.bind(5);
    for (int level = 0; level < levels; ++level) {
        const gpu::Program& program = level == 0 ? guided_program_ : atrous_program_;
        program.use();
        inputs.camera.set(program);
        light_[0].bind(3);
        program.set("points", 2);
        program.set("light", 3);
        program.set("planes", 4);
        program.set("guide", 5);
        program.set("cells", cells);
        program.set("sigma", sigma);
        program.set("step_size", 1 << level);
        light_[1].bind_image(0, GL_WRITE_ONLY);
        program.dispatch(cells, ivec2(8));
        wait_for_level();
        std::swap(light_[0], light_[1]);
    }
    return light_[0];
}

}  // namespace lanthorn::gi

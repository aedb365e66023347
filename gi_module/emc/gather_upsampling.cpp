#include "lanthorn/gi/emc/gather_upsampling.h"

#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

void GatherUpsampling::use(const gpu::Program& program, const render::FrameInputs& inputs,
                           const SurfacePoints& points) {
    use_surfaces(program, inputs, 2);
    points_view_.bind(0, points.points(), GL_RGBA32F);
    program.set("points", 0);
    program.set("grid", grid_);
    program.set("stride", stride_);
}

void GatherUpsampling::place(const render::FrameInputs& inputs, const SurfacePoints& points,
                             const gpu::Buffer& walls, ivec2 grid, int stride) {
    if (!fits_program_) {
        fits_program_ = gpu::Program({"gi_module/emc/gather_fits.comp"});
        upsample_program_ = gpu::Program({"gi_module/emc/gather_upsample.comp"});
        lone_program_ = gpu::Program({"gi_module/emc/gather_lone.comp"});
    }
    if (inputs.gbuffer.size() != size_) {
        size_ = inputs.gbuffer.size();
        fits_ = gpu::Texture::make_2d(GL_R32UI, size_);
        picture_ = gpu::Texture::make_2d(GL_RGBA32F, size_);
        lone_.resize(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y));
    }
    grid_ = grid;
    stride_ = stride;
    use(fits_program_, inputs, points);
    walls_view_.bind(1, walls, GL_R32UI);
    fits_program_.set("walls", 1);
    fits_.bind_image(0, GL_WRITE_ONLY);
    fits_program_.dispatch(size_, ivec2(8));
    wait_for_shaders();
}

const gpu::Texture& GatherUpsampling::irradiance(const render::FrameInputs& inputs,
                                                 const SurfacePoints& points, const gpu::Buffer& irradiance) {
    lone_.clear();
    use(upsample_program_, inputs, points);
    irradiance_view_.bind(1, irradiance, GL_RGBA32F);
    upsample_program_.set("irradiance", 1);
    fits_.bind(4);
    upsample_program_.set("fits", 4);
    picture_.bind_image(0, GL_WRITE_ONLY);
    lone_.bind_storage(7);
    upsample_program_.dispatch(size_, ivec2(8));
    wait_for_shaders();
    use(lone_program_, inputs, points);
    lone_program_.set("irradiance", 1);
    lone_.bind_storage(6);
    lone_.dispatch();
    wait_for_shaders();
    return picture_;
}

}  // namespace lanthorn::gi

#include "gi_module/techniques/emc/gather/gather_upsampling.h"

#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

void GatherUpsampling::use(const gpu::Program& program, const render::FrameInputs& inputs) {
    use_surfaces(program, inputs, 2);
    points_view_.bind(0, points_->points(), GL_RGBA32F);
    program.set("points", 0);
    program.set("grid", grid_);
    program.set("stride", stride_);
}

void GatherUpsampling::place(const SurfacePoints& points, const gpu::Buffer& walls, ivec2 grid, int stride) {
    placed_ = false;
    points_ = &points;
    walls_ = &walls;
    grid_ = grid;
    stride_ = stride;
}

void GatherUpsampling::allocate(ivec2 size) {
    if (!lone_program_) {
        place_program_ = gpu::Program({"gi_module/techniques/emc/gather/gather_upsample.comp"}, {"PLACED 0"});
        upsample_program_ =
            gpu::Program({"gi_module/techniques/emc/gather/gather_upsample.comp"}, {"PLACED 1"});
        lone_program_ = gpu::Program({"gi_module/techniques/emc/gather/gather_lone.comp"});
    }
    if (size != size_) {
        size_ = size;
        fits_ = gpu::Texture::make_2d(GL_R32UI, size_);
        picture_ = gpu::Texture::make_2d(GL_RGBA32F, size_);
        lone_.resize(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y));
    }
}

const gpu::Texture& GatherUpsampling::irradiance(const render::FrameInputs& inputs,
                                                 const gpu::Buffer& irradiance) {
    allocate(inputs.gbuffer.size());
    lone_.clear();
    const gpu::Program& program = placed_ ? upsample_program_ : place_program_;
    use(program, inputs);
    irradiance_view_.bind(1, irradiance, GL_RGBA32F);
    program.set("irradiance", 1);
    if (placed_) {
        fits_.bind(4);
        program.set("fits", 4);
    } else {
        walls_view_.bind(5, *walls_, GL_R32UI);
        program.set("walls", 5);
        fits_.bind_image(1, GL_WRITE_ONLY);
    }
    picture_.bind_image(0, GL_WRITE_ONLY);
    lone_.bind_storage(7);
    program.dispatch(grid_ + 1, ivec2(8));
    wait_for_shaders();
    use(lone_program_, inputs);
    lone_program_.set("irradiance", 1);
    lone_.bind_storage(6);
    lone_.dispatch();
    wait_for_shaders();
    placed_ = true;
    return picture_;
}

}  // namespace lanthorn::gi

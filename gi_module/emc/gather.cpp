#include "lanthorn/gi/emc/gather.h"

#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

// Deviations that luminances on one surface may differ by: of one frame's rays, whose deviation is uncertain,
// and of all that are remembered.
constexpr float kSigmaFirst = 4;
constexpr float kSigmaLast = 2;
constexpr int kFewRays = 48;  // of a point

// The more a point knows itself, the less it asks its neighbours.
int filter_levels(int rays) {
    return rays < 12 ? 4 : rays < kFewRays ? 3 : 2;
}

}  // namespace

void Gather::allocate(ivec2 size, const GiSettings& settings) {
    if (!points_program_) {
        points_program_ = gpu::Program({"gi_module/emc/gather_points.comp"});
        prefilter_programs_[0] = gpu::Program({"gi_module/emc/gather_prefilter.comp"}, {"FIRST 1"});
        prefilter_programs_[1] = gpu::Program({"gi_module/emc/gather_prefilter.comp"}, {"FIRST 0"});
        filter_program_ = gpu::Program({"gi_module/emc/gather_filter.comp"});
        upsample_program_ = gpu::Program({"gi_module/emc/gather_upsample.comp"});
    }
    if (size != size_ || settings.gather_grid != stride_) {
        size_ = size;
        stride_ = settings.gather_grid;
        grid_ = (size + stride_ - 1) / stride_;
        const std::size_t count = static_cast<std::size_t>(grid_.x) * static_cast<std::size_t>(grid_.y);
        for (gpu::Buffer& guide : guides_) {
            guide = gpu::Buffer(count * sizeof(vec2));
        }
        for (gpu::Buffer& filtered : filtered_) {
            filtered = gpu::Buffer(count * sizeof(vec4));
        }
        picture_ = gpu::Texture::make_2d(GL_RGBA32F, size);
    }
    points_.resize(grid_.x * grid_.y, grid_.x, settings.gather_rays);
}

void Gather::place(const render::FrameInputs& inputs) {
    points_.fill();
    use_surfaces(points_program_, inputs);
    points_program_.set("stride", stride_);
    points_program_.set("grid", grid_);
    points_.bind_storage();
    dispatch_items(points_.capacity());
    wait_for_shaders();
}

void Gather::use(const gpu::Program& program, const gpu::Buffer& irradiance) {
    program.use();
    points_view_.bind(0, points_.points(), GL_RGBA32F);
    irradiance_view_.bind(1, irradiance, GL_RGBA32F);
    program.set("points", 0);
    program.set("irradiance", 1);
    program.set("grid", grid_);
}

const gpu::Buffer& Gather::filter(const gpu::Buffer& irradiance) {
    const int rays = hits_.frames() * points_.rays();
    // Few rays are pooled over more points.
    const int pooled = rays < kFewRays ? 2 : 1;
    for (int level = 0; level < pooled; ++level) {
        use(prefilter_programs_[level], irradiance);
        guide_view_.bind(2, guides_[0], GL_RG32F);
        prefilter_programs_[level].set("before", 2);
        prefilter_programs_[level].set("step_width", 1 << level);
        guides_[level].bind_storage(4);
        dispatch_items(points_.capacity());
        wait_for_shaders();
    }
    const float known = static_cast<float>(hits_.frames() - 1) / (RememberedHits::kFrames - 1);
    const gpu::Buffer* from = &irradiance;
    for (int level = 0; level < filter_levels(rays); ++level) {
        use(filter_program_, *from);
        guide_view_.bind(2, guides_[pooled - 1], GL_RG32F);
        filter_program_.set("guide", 2);
        filter_program_.set("step_width", 1 << level);
        filter_program_.set("rays", static_cast<float>(rays));
        filter_program_.set("sigma", glm::mix(kSigmaFirst, kSigmaLast, known));
        filtered_[level % 2].bind_storage(4);
        dispatch_items(points_.capacity());
        wait_for_shaders();
        from = &filtered_[level % 2];
    }
    return *from;
}

void Gather::upsample(const render::FrameInputs& inputs, const gpu::Buffer& irradiance) {
    use(upsample_program_, irradiance);
    use_surfaces(upsample_program_, inputs, 2);
    upsample_program_.set("stride", stride_);
    picture_.bind_image(0, GL_WRITE_ONLY);
    upsample_program_.dispatch(size_, ivec2(8));
    wait_for_shaders();
}

const gpu::Texture& Gather::irradiance(const render::FrameInputs& inputs, const EnvironmentMaps& maps,
                                       const LitMaps& lit, const GiSettings& settings, Work work) {
    inputs.gpu_scene.bind_materials();
    const gpu::Buffer* gathered = nullptr;
    {
        const gpu::PassTimer::Scope scope(inputs.timer, "gather");
        if (work.points) {
            allocate(inputs.gbuffer.size(), settings);
            place(inputs);
            hits_.forget();
        }
        if (work.shoot) {
            const gpu::PassTimer::Scope rays(inputs.timer, "gather_rays");
            hits_.shoot(points_, lit.texels(), maps, settings, inputs.scene);
        }
        gathered = &hits_.shade(points_, lit.radiosity());
    }
    {
        const gpu::PassTimer::Scope scope(inputs.timer, "filter");
        gathered = &filter(*gathered);
    }
    const gpu::PassTimer::Scope scope(inputs.timer, "upsampling");
    upsample(inputs, *gathered);
    return picture_;
}

}  // namespace lanthorn::gi

#include "lanthorn/gi/emc/gather.h"

#include <algorithm>

#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

constexpr int kLevels = 4;  // filter_levels() of gather_trust.glsl at most, and with all rays
constexpr int kLastLevels = 2;

}  // namespace

void Gather::allocate(ivec2 size, const GiSettings& settings) {
    if (!points_program_) {
        points_program_ = gpu::Program({"gi_module/emc/gather_points.comp"});
        prefilter_programs_[0] = gpu::Program({"gi_module/emc/gather_prefilter.comp"}, {"FIRST 1"});
        prefilter_programs_[1] = gpu::Program({"gi_module/emc/gather_prefilter.comp"}, {"FIRST 0"});
        filter_program_ = gpu::Program({"gi_module/emc/gather_filter.comp"});
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
    known_view_.bind(4, hits_.known(), GL_R32F);
    program.set("points", 0);
    program.set("irradiance", 1);
    program.set("known", 4);
    program.set("grid", grid_);
}

const gpu::Buffer& Gather::filter(const gpu::Buffer& irradiance) {
    // Once all is remembered the wide levels have nothing left to do.
    const bool settled = frames_ == RememberedHits::kFrames && points_.rays() >= 4;
    const int pooled = settled ? 1 : 2;
    for (int level = 0; level < pooled; ++level) {
        use(prefilter_programs_[level], irradiance);
        guide_view_.bind(2, guides_[0], GL_RG32F);
        prefilter_programs_[level].set("before", 2);
        prefilter_programs_[level].set("step_width", 1 << level);
        guides_[level].bind_storage(4);
        dispatch_items(points_.capacity());
        wait_for_shaders();
    }
    const gpu::Buffer* from = &irradiance;
    for (int level = 0; level < (settled ? kLastLevels : kLevels); ++level) {
        use(filter_program_, *from);
        guide_view_.bind(2, guides_[pooled - 1], GL_RG32F);
        filter_program_.set("guide", 2);
        filter_program_.set("level", level);
        filter_program_.set("least_sigma", settled ? 2.0f : 4.0f);
        filtered_[level % 2].bind_storage(4);
        dispatch_items(points_.capacity());
        wait_for_shaders();
        from = &filtered_[level % 2];
    }
    return *from;
}

const gpu::Texture& Gather::irradiance(const render::FrameInputs& inputs, const EnvironmentMaps& maps,
                                       const LitMaps& lit, const SweptBoxes& movers, ExactRays* exact,
                                       const GiSettings& settings, Work work) {
    inputs.gpu_scene.bind_materials();
    const RayScene rays{maps, lit.texels(), movers, exact, settings, inputs.scene, inputs.timer};
    const gpu::Buffer* gathered = nullptr;
    {
        const gpu::PassTimer::Scope scope(inputs.timer, "gather");
        if (work.points) {
            allocate(inputs.gbuffer.size(), settings);
            place(inputs);
            frames_ = 0;
        }
        if (work.forget) {
            hits_.forget();
        }
        if (work.points) {
            const gpu::PassTimer::Scope follow(inputs.timer, "gather_follow");
            hits_.follow(points_, grid_, stride_, movers, inputs);
        }
        if (work.verify && !work.forget) {
            const gpu::PassTimer::Scope verify(inputs.timer, "gather_verify");
            hits_.verify(points_, rays, nullptr);
        }
        if (work.shoot) {
            const gpu::PassTimer::Scope shoot(inputs.timer, "gather_rays");
            hits_.shoot(points_, rays);
            frames_ = std::min(frames_ + 1, RememberedHits::kFrames);
        }
        gathered = &hits_.shade(points_, lit.radiosity());
    }
    {
        const gpu::PassTimer::Scope scope(inputs.timer, "filter");
        gathered = &filter(*gathered);
    }
    const gpu::PassTimer::Scope scope(inputs.timer, "upsampling");
    if (work.points) {
        upsampling_.place(inputs, points_, grid_, stride_);
    }
    return upsampling_.irradiance(inputs, points_, *gathered);
}

std::uint64_t Gather::remembered() const {
    double sum = 0;
    for (const float rays : hits_.known().read<float>(static_cast<std::size_t>(points_.capacity()))) {
        sum += static_cast<double>(rays);
    }
    return static_cast<std::uint64_t>(sum);
}

}  // namespace lanthorn::gi

#include "gi_module/techniques/emc/gather/gather.h"

#include <algorithm>

#include "engine/gpu/pass_end.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

// Frames of rays until the filter begins to become narrow, and again as many until it is: a narrow one errs
// less after some eight.
constexpr int kNarrowing = 5;

}  // namespace

void Gather::allocate(ivec2 size, const GiSettings& settings) {
    if (!points_program_) {
        points_program_ = gpu::Program({"gi_module/techniques/emc/gather/gather_points.comp"});
    }
    unseen_.prepare();
    if (size != size_ || settings.of<EmcSettings>().gather_grid != stride_) {
        size_ = size;
        stride_ = settings.of<EmcSettings>().gather_grid;
        grid_ = (size + stride_ - 1) / stride_;
    }
    points_.resize(grid_.x * grid_.y, grid_.x, settings.of<EmcSettings>().gather_rays);
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

const gpu::Buffer& Gather::filter(const gpu::Buffer& irradiance) {
    // Once most is remembered the wide levels only blur.
    const float narrow = glm::clamp(static_cast<float>(frames_ - kNarrowing) / kNarrowing, 0.0f, 1.0f);
    const bool enough = points_.rays() >= 4;
    return filter_.run(filtered_points(irradiance), {enough ? narrow : 0, enough && by_rays_});
}

const gpu::Texture& Gather::irradiance(const render::FrameInputs& inputs, const EnvironmentMaps& maps,
                                       LitMaps& lit, const SweptBoxes& movers, ExactRays* exact,
                                       const GiSettings& settings, const GatherWork& work,
                                       const gpu::Buffer& bad_values) {
    inputs.gpu_scene.bind_materials();
    error_parts_.reset();
    RayScene rays{maps, lit.texels(), movers, exact, settings, inputs.scene, inputs.timer};
    const bool closely = closely_ && exact != nullptr;
    if (closely) {
        close_.begin(inputs, lit.texels().all_places());
        rays.close = &close_;
        rays.nearness = &lit.nearness();
    }
    const gpu::Buffer* gathered = nullptr;
    {
        const gpu::PassTimer::Scope scope(inputs.timer, "gather");
        if (work.points) {
            by_rays_ = !work.other_view;
            allocate(inputs.gbuffer.size(), settings);
            place(inputs);
            frames_ = 0;
        }
        if (work.forget) {
            hits_.forget();
        }
        if (work.points) {
            const gpu::PassTimer::Scope follow(inputs.timer, "gather_follow");
            hits_.follow(points_, grid_, stride_, rays, inputs);
        }
        if (work.verify && !work.forget) {
            const gpu::PassTimer::Scope verify(inputs.timer, "gather_verify");
            hits_.verify(points_, rays, nullptr);
        }
        if (work.shoot) {
            const gpu::PassTimer::Scope shoot(inputs.timer, "gather_rays");
            hits_.shoot(points_, rays, settings.of<EmcSettings>().gather_guide ? &lit.radiosity() : nullptr);
            frames_ = std::min(frames_ + 1, RememberedHits::kFrames);
        }
        if (work.survey) {
            const gpu::PassTimer::Scope survey(inputs.timer, "gather_survey");
            unseen_.find(hits_, grid_, rays);
        }
        if (closely) {
            const gpu::PassTimer::Scope close(inputs.timer, "gather_close");
            hits_.collect(rays);
            lit.light_close(inputs, maps, settings, close_, bad_values);
        }
        gathered = &hits_.shade(points_, lit.radiosity());
    }
    {
        const gpu::PassTimer::Scope scope(inputs.timer, "filter");
        if (work.points) {
            const gpu::PassTimer::Scope links(inputs.timer, "gather_links");
            links_.find(inputs, maps, settings, points_.points(), grid_);
        }
        gathered = filtered_ = &filter(*gathered);
    }
    const gpu::PassTimer::Scope scope(inputs.timer, "upsampling");
    // A picture that looks through other places of its pixels in each frame (render.upscale) keeps its
    // points.
    if (work.points || inputs.camera.shift != vec2(0)) {
        upsampling_.place(points_, links_.walls(), grid_, stride_);
    }
    const gpu::Texture& picture = upsampling_.irradiance(inputs, *gathered);
    if (!closely) {
        near_.forget();
        return picture;
    }
    const gpu::PassTimer::Scope near(inputs.timer, "gather_near");
    if (work.points) {
        near_.shoot(inputs, rays, lit, points_, grid_, stride_);
    }
    near_.show(inputs, rays, lit, picture, bad_values);
    return picture;
}

std::vector<vec4> Gather::known() const {
    std::vector<vec4> result;
    for (const float rays : hits_.known().read<float>(static_cast<std::size_t>(points_.capacity()))) {
        result.emplace_back(rays);
    }
    return result;
}

std::vector<vec4> Gather::unfiltered(const LitMaps& lit) {
    return hits_.shade(points_, lit.radiosity()).read<vec4>(static_cast<std::size_t>(points_.capacity()));
}

const GatherError::Parts& Gather::error_parts(const LitMaps& lit) {
    if (error_parts_) {
        return *error_parts_;
    }
    if (filtered_ == nullptr) {
        return error_parts_.emplace();
    }
    const gpu::Buffer& halves = hits_.halves(points_, lit.radiosity());
    gpu::PassEnd::tell();
    const gpu::Buffer& irradiance = hits_.irradiance();
    const gpu::Buffer& noise = filter_.again(filtered_points(irradiance), halves);
    return error_parts_.emplace(
        error_.measure({grid_, points_.points(), irradiance, *filtered_, halves, noise}));
}

std::uint64_t Gather::remembered() const {
    double sum = 0;
    for (const float rays : hits_.known().read<float>(static_cast<std::size_t>(points_.capacity()))) {
        sum += static_cast<double>(rays);
    }
    return static_cast<std::uint64_t>(sum);
}

}  // namespace lanthorn::gi

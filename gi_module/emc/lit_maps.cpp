#include "lanthorn/gi/emc/lit_maps.h"

#include <algorithm>
#include <chrono>

#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

constexpr int kCoarser = 4;  // lit texels a side of one of E1
constexpr int kLeastCoarse = 8;
constexpr int kTexelRays = 2;  // a texel of E1 and frame
constexpr int kFilterLevels = 2;
constexpr std::uint32_t kUnlit = 0xbf800000u;  // the bits of -1
// Of endless bounces: those that the first frame begins with, and what keeps light from growing for ever.
constexpr int kFirstSweeps = 3;
constexpr float kMostAlbedo = 0.95f;

}  // namespace

void LitMaps::build_programs() {
    if (!coarse_program_) {
        coarse_program_ = gpu::Program({"gi_module/emc/lit_coarse_texels.comp"});
        filter_program_ = gpu::Program({"gi_module/emc/lit_coarse_filter.comp"});
        reflect_program_ = gpu::Program({"gi_module/emc/lit_reflect.comp"});
    }
}

void LitMaps::update(const render::LightInputs& inputs, const EnvironmentMaps& maps, const SweptBoxes& movers,
                     ExactRays* exact, const GiSettings& settings, int bounces, Work work,
                     const gpu::Buffer& bad_values) {
    build_programs();
    RayScene rays{maps, texels_, movers, exact, settings, inputs.scene, inputs.timer};
    inputs.gpu_scene.bind_materials();
    if (work.list) {
        const gpu::PassTimer::Scope scope(inputs.timer, "lit_texels");
        list(maps, settings, inputs.scene);
    }
    bounces_ = settings.gather_endless ? std::max(bounces, 2) : bounces;
    if (work.forget) {
        hits_.forget();
        radiosity_holds_ = false;
    }
    if (work.compare && exact != nullptr) {
        rays.exact = nullptr;
        times_.maps = time_of(rays);
        rays.exact = exact;
        times_.exact = time_of(rays);
        rays.exact = times_.exact < times_.maps ? exact : nullptr;
    }
    if (work.light) {
        const gpu::PassTimer::Scope scope(inputs.timer, "lit_direct");
        light(inputs, bad_values);
    }
    if (bounces_ < 2) {
        return;
    }
    if (work.verify && !work.forget) {
        const gpu::PassTimer::Scope scope(inputs.timer, "lit_verify");
        hits_.verify(coarse_, rays, &coarse_index_);
    }
    if (work.shoot) {
        const gpu::PassTimer::Scope scope(inputs.timer, "lit_rays");
        hits_.shoot(coarse_, rays);
        frames_ = std::min(frames_ + 1, RememberedHits::kFrames);
    }
    const gpu::PassTimer::Scope scope(inputs.timer, "lit_indirect");
    const bool goes_on = settings.gather_endless && radiosity_holds_;
    const int sweeps = goes_on ? 1 : settings.gather_endless ? kFirstSweeps : bounces - 1;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        reflect(inputs, maps, settings, hits_.shade(coarse_, sweep == 0 && !goes_on ? first_ : radiosity_),
                settings.gather_endless ? kMostAlbedo : 1);
    }
    radiosity_holds_ = true;
}

void LitMaps::list(const EnvironmentMaps& maps, const GiSettings& settings, const FrameScene& scene) {
    if (texels_.resize(maps, settings)) {
        const std::size_t bytes = static_cast<std::size_t>(texels_.points().capacity()) * sizeof(vec4);
        direct_ = gpu::Buffer(bytes);
        first_ = gpu::Buffer(bytes);
        radiosity_ = gpu::Buffer(bytes);
        radiosity_holds_ = false;
    }
    texels_.list(maps, settings, scene, radiosity_);
    first_.fill(kUnlit);
    list_coarse();
    frames_ = 0;
}

// From no memory, which is forgotten again; the second time, since programs are compiled when they run first.
double LitMaps::time_of(const RayScene& rays) {
    std::chrono::duration<double, std::milli> time{0};
    for (int run = 0; run < 2; ++run) {
        hits_.forget();
        glFinish();
        const auto start = std::chrono::steady_clock::now();
        hits_.shoot(coarse_, rays);
        glFinish();
        time = std::chrono::steady_clock::now() - start;
    }
    hits_.forget();
    return time.count();
}

void LitMaps::list_coarse() {
    coarse_resolution_ = std::max(kLeastCoarse, texels_.resolution() / kCoarser);
    const int places = texels_.faces() * coarse_resolution_ * coarse_resolution_;
    if (coarse_.capacity() != places) {
        coarse_index_ = gpu::Buffer(static_cast<std::size_t>(places) * sizeof(std::uint32_t));
        for (gpu::Buffer& filtered : filtered_) {
            filtered = gpu::Buffer(static_cast<std::size_t>(places) * sizeof(vec4));
        }
    }
    coarse_.resize(places, coarse_resolution_, kTexelRays);
    coarse_program_.use();
    coarse_program_.set("lit_resolution", texels_.resolution());
    coarse_program_.set("coarse_resolution", coarse_resolution_);
    coarse_program_.set("faces", texels_.faces());
    coarse_program_.set("rays", kTexelRays);
    coarse_.bind_storage();
    texels_.index().bind_storage(4);
    texels_.points().points().bind_storage(5);
    coarse_index_.bind_storage(6);
    dispatch_items(places);
    wait_for_shaders();
}

void LitMaps::light(const render::LightInputs& inputs, const gpu::Buffer& bad_values) {
    if (inputs.light_maps.light_count() == 0) {
        direct_.clear();
        first_.clear();
        return;
    }
    const gpu::Program& program = direct_programs_.bind(inputs.light_maps, 0);
    program.use();
    texels_.points().bind_storage();
    texels_.albedo().bind_storage(4);
    direct_.bind_storage(5);
    first_.bind_storage(6);
    bad_values.bind_storage(7);
    texels_.points().dispatch();
    wait_for_shaders();
}

void LitMaps::bind_coarse(const gpu::Program& program, const gpu::Buffer& irradiance) {
    index_view_.bind(2, coarse_index_, GL_R32UI);
    points_view_.bind(3, coarse_.points(), GL_RGBA32F);
    irradiance_view_.bind(4, irradiance, GL_RGBA32F);
    program.set("coarse_index", 2);
    program.set("coarse_points", 3);
    program.set("coarse_irradiance", 4);
    program.set("coarse_resolution", coarse_resolution_);
}

void LitMaps::reflect(const render::LightInputs& inputs, const EnvironmentMaps& maps,
                      const GiSettings& settings, const gpu::Buffer& irradiance, float most_albedo) {
    const gpu::Buffer* e1 = &irradiance;
    for (int level = 0; level < kFilterLevels; ++level) {
        filter_program_.use();
        maps.bind(filter_program_, 0, 1, settings, inputs.scene);
        bind_coarse(filter_program_, *e1);
        filter_program_.set("step_width", 1 << level);
        coarse_.bind_storage();
        filtered_[level % 2].bind_storage(4);
        coarse_.dispatch();
        wait_for_shaders();
        e1 = &filtered_[level % 2];
    }
    reflect_program_.use();
    maps.bind(reflect_program_, 0, 1, settings, inputs.scene);
    bind_coarse(reflect_program_, *e1);
    reflect_program_.set("lit_resolution", texels_.resolution());
    reflect_program_.set("most_albedo", most_albedo);
    texels_.points().bind_storage();
    texels_.albedo().bind_storage(4);
    direct_.bind_storage(5);
    radiosity_.bind_storage(6);
    texels_.points().dispatch();
    wait_for_shaders();
}

std::size_t LitMaps::bytes() const {
    return direct_.bytes() + first_.bytes() + radiosity_.bytes() + texels_.albedo().bytes() +
           texels_.index().bytes() + hits_.bytes();
}

}  // namespace lanthorn::gi

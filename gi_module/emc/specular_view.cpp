#include "lanthorn/gi/emc/specular_view.h"

#include <algorithm>

#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

constexpr std::uint32_t kHeader[4] = {0, 0, 1, 1};  // no rays; groups x, y, z
constexpr float kOriginOffset = 2e-5f;              // of the scene's diagonal: scatter.glsl
constexpr std::size_t kSampleBytes = 32;            // SpecularSample
constexpr GLuint kFirstUnit = 4;                    // after the light maps

}  // namespace

bool any_specular(const FrameScene& scene, const GiSettings& settings) {
    return std::ranges::any_of(scene.instances, [&](const Instance& instance) {
        const Material& m = scene.material(instance);
        const bool smooth =
            m.roughness < settings.specular_roughness || m.metallic_roughness_texture.present();
        const bool reflects = m.metallic > 0 || m.specular > 0;
        return m.alpha_mode != AlphaMode::blend && !m.unlit && (m.transmission > 0 || (smooth && reflects));
    });
}

void SpecularView::allocate(ivec2 size) {
    if (!rays_program_) {
        rays_program_ = gpu::Program({"gi_module/emc/specular_rays.comp"});
        trace_program_ = gpu::Program({"gi_module/emc/specular_trace.comp"});
        resolve_program_ = gpu::Program({"gi_module/emc/specular_resolve.comp"});
        header_ = gpu::Buffer(sizeof(kHeader));
    }
    if (size != size_) {
        size_ = size;
        const std::size_t rays = 2 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
        rays_ = gpu::Buffer(rays * sizeof(SpecularRay));
        hits_ = gpu::Buffer(rays * sizeof(SpecularHit));
        samples_ = gpu::Buffer(rays * kSampleBytes);
        picture_ = gpu::Texture::make_2d(GL_RGBA32F, size);
    }
}

const gpu::Texture& SpecularView::radiance(const render::FrameInputs& inputs, const EnvironmentMaps& maps,
                                           const LitMaps* lit, const gpu::Texture* irradiance,
                                           const CausticPhotons* caustics, ExactRays* exact,
                                           const GiSettings& settings, bool shoot_anew,
                                           const gpu::Buffer& bad_values) {
    const gpu::PassTimer::Scope scope(inputs.timer, "specular");
    inputs.gpu_scene.bind_materials();
    if (shoot_anew || inputs.gbuffer.size() != size_) {
        allocate(inputs.gbuffer.size());
        const gpu::PassTimer::Scope rays(inputs.timer, "specular_rays");
        shoot(inputs, maps, lit, exact, settings);
    }
    {
        const gpu::PassTimer::Scope shading(inputs.timer, "specular_shade");
        shade(inputs, maps, lit, irradiance, caustics, settings, bad_values);
    }
    const gpu::PassTimer::Scope resolve(inputs.timer, "specular_resolve");
    use(resolve_program_, inputs);
    resolve_program_.set("most_roughness", settings.specular_roughness);
    samples_.bind_storage(2);
    picture_.bind_image(0, GL_WRITE_ONLY);
    resolve_program_.dispatch(size_, ivec2(8));
    wait_for_shaders();
    return picture_;
}

void SpecularView::use(const gpu::Program& program, const render::FrameInputs& inputs) {
    use_surfaces(program, inputs, 0);
    inputs.gbuffer.albedo().bind(2);
    inputs.gbuffer.material().bind(3);
    inputs.gbuffer.emissive().bind(4);
    program.set("gbuffer_albedo", 2);
    program.set("gbuffer_material", 3);
    program.set("gbuffer_emissive", 4);
    table_.bind(program, 5);
}

void SpecularView::shoot(const render::FrameInputs& inputs, const EnvironmentMaps& maps, const LitMaps* lit,
                         ExactRays* exact, const GiSettings& settings) {
    header_.write_bytes(0, kHeader, sizeof(kHeader));
    use(rays_program_, inputs);
    rays_program_.set("most_roughness", settings.specular_roughness);
    rays_program_.set("origin_offset", kOriginOffset * inputs.scene.diagonal());
    header_.bind_storage(0);
    rays_.bind_storage(1);
    samples_.bind_storage(2);
    rays_program_.dispatch(size_, ivec2(8));
    wait_for_shaders();
    if (exact != nullptr) {
        trace_exactly(*exact);
    } else {
        march(inputs, maps, lit, settings);
    }
}

std::uint32_t SpecularView::rays() const {
    return header_ ? header_.read<std::uint32_t>(1).front() : 0;
}

void SpecularView::trace_exactly(ExactRays& exact) {
    const std::vector<SpecularRay> rays = rays_.read<SpecularRay>(this->rays());
    const std::vector<SpecularHit> hits = exact.trace(rays);
    if (const std::size_t bytes = hits.size() * sizeof(SpecularHit); bytes > hits_.bytes()) {
        hits_ = gpu::Buffer(bytes + bytes / 4);
    }
    hits_.write(0, std::span<const SpecularHit>(hits));
}

void SpecularView::dispatch_rays() const {
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, header_.id());
    glDispatchComputeIndirect(sizeof(std::uint32_t));
}

void SpecularView::march(const render::FrameInputs& inputs, const EnvironmentMaps& maps, const LitMaps* lit,
                         const GiSettings& settings) {
    trace_program_.use();
    maps.bind(trace_program_, 0, 1, settings, inputs.scene);
    if (lit != nullptr) {
        lit->texels().bind(trace_program_, points_view_, 2);
    }
    trace_program_.set("lit_points", 2);
    header_.bind_storage(0);
    rays_.bind_storage(1);
    hits_.bind_storage(3);
    dispatch_rays();
    wait_for_shaders();
}

void SpecularView::shade(const render::FrameInputs& inputs, const EnvironmentMaps& maps, const LitMaps* lit,
                         const gpu::Texture* irradiance, const CausticPhotons* caustics,
                         const GiSettings& settings, const gpu::Buffer& bad_values) {
    if (caustics != nullptr) {
        cells_.sort(*caustics, 1e-5f * inputs.scene.diagonal());
    }
    const gpu::Program& program = shade_programs_.bind(inputs.light_maps, 0);
    program.use();
    maps.bind(program, kFirstUnit, kFirstUnit + 1, settings, inputs.scene);
    program.set("has_lit", lit != nullptr ? 1 : 0);
    if (lit != nullptr) {
        lit->texels().bind(program, points_view_, kFirstUnit + 2);
        radiosity_view_.bind(kFirstUnit + 3, lit->radiosity(), GL_RGBA32F);
        albedo_view_.bind(kFirstUnit + 4, lit->texels().albedo(), GL_RGBA32F);
        direct_view_.bind(kFirstUnit + 5, lit->direct(), GL_RGBA32F);
    }
    // Units of their own also where there is nothing to read: two samplers of different types in one unit see
    // each other's.
    program.set("lit_points", static_cast<int>(kFirstUnit + 2));
    program.set("lit_radiosity", static_cast<int>(kFirstUnit + 3));
    program.set("lit_albedo", static_cast<int>(kFirstUnit + 4));
    program.set("lit_direct", static_cast<int>(kFirstUnit + 5));
    program.set("has_sky", inputs.sky.empty() ? 0 : 1);
    inputs.camera.set(program);
    inputs.gbuffer.distance().bind(kFirstUnit + 7);
    inputs.gbuffer.normals().bind(kFirstUnit + 8);
    program.set("gbuffer_distance", static_cast<int>(kFirstUnit + 7));
    program.set("gbuffer_normals", static_cast<int>(kFirstUnit + 8));
    program.set("picture_irradiance", static_cast<int>(kFirstUnit + 9));
    program.set("has_picture", irradiance != nullptr ? 1 : 0);
    if (irradiance != nullptr) {
        irradiance->bind(kFirstUnit + 9);
    }
    program.set("sky_image", static_cast<int>(kFirstUnit + 6));
    if (!inputs.sky.empty()) {
        inputs.sky.bind(program, kFirstUnit + 6);
    }
    program.set("caustic_words", static_cast<int>(kFirstUnit + 10));
    program.set("caustic_samples", static_cast<int>(kFirstUnit + 11));
    program.set("has_caustics", caustics != nullptr ? 1 : 0);
    if (caustics != nullptr) {
        cells_.bind(program, kFirstUnit + 10);
    }
    header_.bind_storage(0);
    rays_.bind_storage(1);
    hits_.bind_storage(3);
    samples_.bind_storage(5);
    bad_values.bind_storage(7);
    dispatch_rays();
    wait_for_shaders();
}

}  // namespace lanthorn::gi

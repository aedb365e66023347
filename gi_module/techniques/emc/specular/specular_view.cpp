#include "gi_module/techniques/emc/specular/specular_view.h"

#include "lanthorn/emc/emc_settings.h"

namespace lanthorn::gi {

namespace {

constexpr GLuint kFirstUnit = MirrorView::kFirstUnit;

}  // namespace

const gpu::Texture& SpecularView::radiance(const render::FrameInputs& inputs, const EnvironmentMaps& maps,
                                           const LitMaps* lit, const gpu::Texture* irradiance,
                                           const CausticPhotons* caustics, ExactRays* exact,
                                           const GiSettings& settings, bool shoot,
                                           const gpu::Buffer& bad_values) {
    const gpu::PassTimer::Scope scope(inputs.timer, "specular");
    inputs.gpu_scene.bind_materials();
    if (shoot || !view_.has(inputs.gbuffer.size())) {
        const gpu::PassTimer::Scope rays(inputs.timer, "specular_rays");
        view_.shoot(inputs, settings.specular_roughness, settings.of<EmcSettings>().specular_grid);
        if (exact != nullptr) {
            view_.set_hits(exact->trace(std::span<const SpecularRay>(view_.read_rays())));
        } else {
            march(inputs, maps, lit, settings);
        }
    }
    if (caustics != nullptr) {
        cells_.sort(*caustics, 1e-5f * inputs.scene.diagonal());
    }
    return view_.shade(inputs, settings.specular_roughness, bad_values, [&](const gpu::Program& program) {
        bind(program, inputs, maps, lit, irradiance, caustics, settings);
    });
}

void SpecularView::march(const render::FrameInputs& inputs, const EnvironmentMaps& maps, const LitMaps* lit,
                         const GiSettings& settings) {
    if (!trace_program_) {
        trace_program_ = gpu::Program({"gi_module/techniques/emc/specular/specular_trace.comp"});
    }
    trace_program_.use();
    maps.bind(trace_program_, 0, 1, settings, inputs.scene);
    if (lit != nullptr) {
        lit->texels().bind(trace_program_, points_view_, 2);
    }
    trace_program_.set("lit_points", 2);
    view_.find_hits();
}

// Units of their own also where there is nothing to read: two samplers of different types in one unit see
// each other's.
void SpecularView::bind(const gpu::Program& program, const render::FrameInputs& inputs,
                        const EnvironmentMaps& maps, const LitMaps* lit, const gpu::Texture* irradiance,
                        const CausticPhotons* caustics, const GiSettings& settings) {
    maps.bind(program, kFirstUnit, kFirstUnit + 1, settings, inputs.scene);
    program.set("has_lit", lit != nullptr ? 1 : 0);
    if (lit != nullptr) {
        lit->texels().bind(program, points_view_, kFirstUnit + 2);
        radiosity_view_.bind(kFirstUnit + 3, lit->radiosity(), GL_RGBA32F);
        albedo_view_.bind(kFirstUnit + 4, lit->texels().albedo(), GL_RGBA32F);
        direct_view_.bind(kFirstUnit + 5, lit->direct(), GL_RGBA32F);
    }
    program.set("lit_points", static_cast<int>(kFirstUnit + 2));
    program.set("lit_radiosity", static_cast<int>(kFirstUnit + 3));
    program.set("lit_albedo", static_cast<int>(kFirstUnit + 4));
    program.set("lit_direct", static_cast<int>(kFirstUnit + 5));
    inputs.camera.set(program);
    inputs.gbuffer.distance().bind(kFirstUnit + 6);
    inputs.gbuffer.normals().bind(kFirstUnit + 7);
    program.set("gbuffer_distance", static_cast<int>(kFirstUnit + 6));
    program.set("gbuffer_normals", static_cast<int>(kFirstUnit + 7));
    program.set("picture_irradiance", static_cast<int>(kFirstUnit + 8));
    program.set("has_picture", irradiance != nullptr ? 1 : 0);
    if (irradiance != nullptr) {
        irradiance->bind(kFirstUnit + 8);
    }
    program.set("caustic_words", static_cast<int>(kFirstUnit + 9));
    program.set("caustic_samples", static_cast<int>(kFirstUnit + 10));
    program.set("has_caustics", caustics != nullptr ? 1 : 0);
    if (caustics != nullptr) {
        cells_.bind(program, kFirstUnit + 9);
    }
}

}  // namespace lanthorn::gi

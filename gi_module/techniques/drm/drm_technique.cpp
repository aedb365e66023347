#include "gi_module/techniques/drm/drm_technique.h"
#include "lanthorn/drm/drm.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "engine/render/light_sensors.h"
#include "gi_module/techniques/drm/drm_views.h"
#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

void DrmTechnique::plan(const FrameScene& scene, ivec2 size, const GiSettings& settings) {
    const DrmSettings& before = settings_.of<DrmSettings>();
    const DrmSettings& now = settings.of<DrmSettings>();
    history_.same_samples = same_samples(before, now);
    history_.same_pixels = size == size_ && before.mirrors == now.mirrors &&
                           settings_.specular_roughness == settings.specular_roughness;
    history_.can_trace = has_exact_rays();
    settings_ = settings;
    size_ = size;
    plan_ = make_drm_plan(scene, settings, history_);
    statistics_.faces_drawn = 0;
    statistics_.sampled = statistics_.gathered = false;
    if (plan_.bounces == 0) {
        light_version_ += history_.has_samples ? 1 : 0;
        history_ = {};
        shown_ = {};
        statistics_ = {};
        exact_.reset();  // it follows from change to change, and would miss this one
    }
}

render::TracedLobes DrmTechnique::traced_lobes() const {
    return {plan_.mirrors ? settings_.specular_roughness : 0};
}

void DrmTechnique::update(const render::LightInputs& inputs) {
    if (plan_.bounces == 0) {
        return;
    }
    if (!map_) {
        map_ = std::make_unique<RadianceMap>();
        bad_values_ = gpu::Buffer(sizeof(std::uint32_t));
    }
    follow_light_maps(inputs);
    follow_rays(inputs);
    if (plan_.on(DrmPass::samples)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "samples");
        map_->make(inputs, settings_.of<DrmSettings>(), exact_.get(), bad_values_);
        history_.has_samples = true;
        statistics_.sampled = true;
        statistics_.pictures = map_->pictures().count();
        statistics_.left_out = map_->pictures().left_out;
        statistics_.dark = map_->pictures().dark;
        statistics_.samples = map_->samples();
        statistics_.sample_pictures = map_->sample_pictures();
        statistics_.faces_drawn = map_->faces_drawn();
        statistics_.mirrored = map_->mirrored();
        ++light_version_;
    }
    gpu::Program& sensors = sensor_programs_[map_->hides() ? 1 : 0];
    if (!inputs.scene.sensors.empty() && !sensors) {
        using Defines = std::vector<std::string>;
        sensors = gpu::Program({"gi_module/techniques/drm/sensor_samples.comp"},
                               map_->hides() ? Defines{"SAMPLES_ARE_HIDDEN 1"} : Defines());
    }
}

// Samples are of the light maps: where those are others though nothing in the scene has changed
// (render.shadow.resolution), the frame does more than was planned before they were drawn.
void DrmTechnique::follow_light_maps(const render::LightInputs& inputs) {
    const std::uint64_t before = std::exchange(light_maps_, inputs.light_maps.version());
    if (before != light_maps_ && !plan_.on(DrmPass::samples)) {
        history_.other_light_maps = true;
        plan_ = make_drm_plan(inputs.scene, settings_, history_);
        history_.other_light_maps = false;
    }
}

void DrmTechnique::follow_rays(const render::LightInputs& inputs) {
    if (!plan_.mirrors) {
        exact_.reset();
        history_.has_mirrors = false;
        return;
    }
    if (!exact_) {
        exact_ = make_exact_rays();
    }
    const gpu::PassTimer::Scope scope(inputs.timer, "acceleration_structure");
    exact_->follow(inputs.scene, RayDetail::full);
}

render::IndirectLight DrmTechnique::indirect(const render::FrameInputs& inputs) {
    if (plan_.bounces == 0) {
        return {};
    }
    const gpu::Texture* mirrored = shown_.specular;
    if (plan_.on(DrmPass::mirrors)) {
        mirror(inputs);
        mirrored = &mirrors_->picture();
    }
    if (plan_.on(DrmPass::gather)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "gather");
        mirrored = plan_.mirrors ? &mirrors_->picture() : nullptr;
        shown_ = {nullptr, mirrored};
        if (map_->samples() > 0) {
            shown_ = gather_.light(inputs, *map_, plan_.lobes, mirrored,
                                   plan_.mirrors ? settings_.specular_roughness : 0, bad_values_);
        }
        statistics_.gathered = true;
        history_.has_picture = true;
    }
    return shown_;
}

// Where the paper draws a mirrored scene for every planar mirror and a cube map for every curved one (Frisvad
// et al. 2005, sec. 4: light paths L D D S* E), rays are followed, and lit by the samples: without what those
// techniques get wrong, near things in curved mirrors and mirrors in mirrors.
void DrmTechnique::mirror(const render::FrameInputs& inputs) {
    const gpu::PassTimer::Scope scope(inputs.timer, "mirrors");
    if (!mirrors_ || hidden_mirrors_ != map_->hides()) {
        hidden_mirrors_ = map_->hides();
        mirrors_ = std::make_unique<MirrorView>(hidden_mirrors_
                                                    ? "gi_module/techniques/drm/specular_shade_hidden.comp"
                                                    : "gi_module/techniques/drm/specular_shade.comp");
    }
    const DrmMirrors shows = settings_.of<DrmSettings>().mirrors;
    if (plan_.shoot || !mirrors_->has(inputs.gbuffer.size())) {
        const gpu::PassTimer::Scope rays(inputs.timer, "specular_rays");
        mirrors_->shoot(inputs, settings_.specular_roughness);
        mirrors_->set_hits(exact_->trace(std::span<const SpecularRay>(mirrors_->read_rays())));
    }
    const gpu::Texture& picture =
        mirrors_->shade(inputs, settings_.specular_roughness, bad_values_, [&](const gpu::Program& program) {
            program.set("has_indirect", shows == DrmMirrors::all && map_->samples() > 0 ? 1 : 0);
            map_->bind(program, false);
        });
    // With no share of the lobe the mirror is lit by irradiance as well.
    glTextureParameteri(picture.id(), GL_TEXTURE_SWIZZLE_A, shows == DrmMirrors::trick ? GL_ZERO : GL_ALPHA);
    history_.has_mirrors = true;
}

// What falls on each sensor's disc, by the samples.
void DrmTechnique::add_irradiance(const render::LightInputs& /*inputs*/,
                                  const render::SensorTargets& targets) {
    if (plan_.bounces == 0 || !map_ || map_->samples() == 0) {
        return;
    }
    const gpu::Program& program = sensor_programs_[map_->hides() ? 1 : 0];
    if (!program) {
        return;  // the frame had no sensor
    }
    program.use();
    targets.sensors.bind_storage(render::kSensorsBinding);
    targets.irradiances.bind_storage(render::kSensorIrradianceBinding);
    map_->bind(program, false);
    program.set("sensor_count", targets.count);
    program.dispatch(targets.count, 64);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

gpu::Texture DrmTechnique::debug_view(std::string_view name, const render::FrameInputs& inputs) {
    const bool sampled = plan_.bounces > 0 && map_ && map_->samples() > 0;
    return sampled ? draw_drm_view(name, *map_, settings_.of<DrmSettings>(), inputs) : gpu::Texture();
}

GiStatistics DrmTechnique::statistics(bool) {
    GiStatistics result;
    result.plan = in_words(plan_, settings_, statistics_);
    result.nan_count = bad_values_ ? bad_values_.read<std::uint32_t>(1).front() : 0;
    result.add(statistics_);
    return result;
}

namespace {

std::string statistics_json(const GiStatistics& statistics) {
    const DrmStatistics& s = statistics.of<DrmStatistics>();
    return nlohmann::ordered_json{{"pictures", s.pictures},
                                  {"left_out", s.left_out},
                                  {"dark", s.dark},
                                  {"samples", s.samples},
                                  {"sample_pictures", s.sample_pictures},
                                  {"faces_drawn", s.faces_drawn},
                                  {"mirrored", s.mirrored}}
        .dump();
}

}  // namespace

TechniqueKind add_drm() {
    TechniqueEntry entry;
    entry.name = "drm";
    entry.docs = "direct radiance mapping, one bounce without shadows (Frisvad et al. 2005)";
    entry.has_presets = true;
    entry.reads = {"gi.drm.", "gi.specular.roughness"};
    entry.turns = {{"gi.drm.samples", {"1", "2", "3", "4", "6", "8", "12", "16"}},
                   {"gi.drm.solid_angle", {"14", "disc", "15", "11"}}};
    entry.debug_views = drm_views();
    entry.declare = declare_drm_settings;
    entry.make = []() -> std::unique_ptr<Technique> { return std::make_unique<DrmTechnique>(); };
    entry.first_plan = first_drm_plan;
    entry.statistics_json = statistics_json;
    return add_technique(std::move(entry));
}

}  // namespace lanthorn::gi

#include "gi_module/techniques/splat/splat_technique.h"
#include "lanthorn/splat/splat.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "gi_module/techniques/splat/splat_views.h"

namespace lanthorn::gi {

namespace {

std::string statistics_in_json(const GiStatistics& gi) {
    const auto& splat = gi.of<SplatStatistics>();
    nlohmann::ordered_json json{{"walks", splat.walks},
                                {"photons", splat.photons},
                                {"caustic_photons", splat.caustic_photons},
                                {"rays", splat.rays},
                                {"surfaces", splat.surfaces},
                                {"splatted", splat.splatted},
                                {"mirror_rays", splat.mirror_rays},
                                {"rounds", splat.rounds},
                                {"memory", splat.memory},
                                {"on_disk", splat.on_disk},
                                {"builds", splat.builds}};
    if (!splat.error.empty()) {
        json["error"] = splat.error;
    }
    return json.dump();
}

}  // namespace

void SplatTechnique::follow(const GiSettings& settings, ivec2 size) {
    const auto& own = settings.of<SplatSettings>();
    if (!workers_ || own.threads != settings_.of<SplatSettings>().threads) {
        workers_ = std::make_unique<reference::TileWorkers>(own.threads);
    }
    traced_by_.follow({own.photons, own.batch, own.scattering, own.memory, settings.bounces, settings.seed,
                       settings.accumulate, settings.photons});
    splatted_by_.follow({own.bandwidth, own.caustic_bandwidth, own.kernel, own.boundaries, own.adaptive,
                         own.levels, own.least, own.most, own.bias});
    size_.follow(size);
    now_ = {traced_by_.version(), splatted_by_.version(), size_.version()};
}

void SplatTechnique::plan(const FrameScene& scene, ivec2 size, const GiSettings& settings) {
    follow(settings, size);
    SplatHistory history;
    history.walks = photons_.walks();
    history.splatted = splatted_walks_;
    history.has_photons = !traced_.due(now_);
    history.has_picture = irradiance_ != nullptr && !splatted_.due(now_);
    history.has_view = !seen_.due(now_);
    history.full = full_;
    history.has_mirrors = mirrors_.has(size) && settings_.specular_roughness == settings.specular_roughness;
    // Other photons tell of it themselves, once they are traced.
    light_version_ += !traced_.empty() && splatted_.other(now_) == Input::picture ? 1 : 0;
    settings_ = settings;
    plan_ = make_splat_plan(scene, settings, history);
    if (plan_.unlit != Unlit::no) {
        light_version_ += traced_.empty() ? 0 : 1;
        photons_.clear();
        scene_.clear();
        mirrors_.clear();
        traced_.forget();
        seen_.forget();
        full_ = false;
        splatted_walks_ = 0;
        irradiance_ = nullptr;
        error_.clear();
    }
}

render::TracedLobes SplatTechnique::traced_lobes() const {
    return {plan_.mirrors ? settings_.specular_roughness : 0};
}

void SplatTechnique::update(const render::LightInputs& inputs) {
    if (plan_.unlit != Unlit::no) {
        return;
    }
    const auto& own = settings_.of<SplatSettings>();
    // Mirrors show what the light maps light, too: where those are others though nothing in the scene has
    // changed (render.shadow.resolution), the frame does more than was planned before they were drawn.
    if (std::exchange(light_maps_, inputs.light_maps.version()) != inputs.light_maps.version() &&
        plan_.mirrors) {
        plan_.set(SplatPass::mirrors, true, SplatReason::mirrors_show_more);
    }
    sensors_ = inputs.scene.sensors;
    {
        const gpu::PassTimer::Scope scope(inputs.timer, "surfaces");
        scene_.follow(inputs.scene,
                      own.scattering);  // the frame's own lights and instances, even if they hold
        if (plan_.on(SplatPass::surfaces)) {
            surfaces_.follow(inputs.scene, *workers_);
        }
    }
    if (plan_.anew) {
        photons_.clear();
        const std::size_t all = static_cast<std::size_t>(own.memory) << 20;
        photons_.store().limit(all - std::min(all / 2, PhotonCollection::kTracing));
        splatted_walks_ = 0;
        full_ = false;
        error_.clear();
    }
    if (plan_.on(SplatPass::photons)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "photons");
        const PhotonSettings traced{plan_.bounces, settings_.seed, own.scattering};
        full_ = !photons_.grow(scene_, surfaces_, traced, plan_.grow, *workers_);
        if (full_) {
            error_ = photons_.store().error();
        }
        ++light_version_;
    }
    traced_.made(now_);
}

void SplatTechnique::lose_photons() {
    error_ = photons_.store().error();
    traced_.forget();
}

void SplatTechnique::add_irradiance(const render::LightInputs& /*inputs*/,
                                    const render::SensorTargets& targets) {
    if (plan_.unlit != Unlit::no || sensors_.empty()) {
        return;
    }
    const std::vector<SensorPoint> points = sensor_points(scene_.surfaces(), sensors_);
    std::vector<vec4> light;
    if (!on_sensors_.light(points, surfaces_, photons_, photons_.powers(scene_.sources()),
                           settings_.of<SplatSettings>(), *workers_, light)) {
        lose_photons();
        return;
    }
    sensor_light_.add(points, light, targets);
}

void SplatTechnique::mirror(const render::FrameInputs& inputs) {
    if (plan_.on(SplatPass::mirror_rays)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "mirror_rays");
        mirrors_.shoot(inputs, scene_.followed(), settings_.specular_roughness, *workers_);
    }
    const gpu::PassTimer::Scope scope(inputs.timer, "mirrors");
    std::vector<PixelSurface> places;
    for (std::size_t i = 0; i < mirrors_.hits().size(); ++i) {
        const ChainSurface& on = mirrors_.surfaces()[i];
        const bool met = mirrors_.hits()[i].kind == kMetSurface;
        places.push_back({mirrors_.hits()[i].position,
                          met ? surfaces_.side(on.instance, on.primitive, on.front) : kNoSide});
    }
    std::vector<vec4> light;
    if (!mirrored_.light(places, surfaces_, photons_, photons_.powers(scene_.sources()),
                         settings_.of<SplatSettings>(), *workers_, light)) {
        lose_photons();
    }
    mirrors_.shade(inputs, settings_.specular_roughness, light);
}

render::IndirectLight SplatTechnique::indirect(const render::FrameInputs& inputs) {
    if (plan_.unlit != Unlit::no) {
        return {};
    }
    if (plan_.on(SplatPass::item_buffer)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "item_buffer");
        picture_.find(inputs, scene_, surfaces_, *workers_);
        seen_.made(now_);
    }
    if (plan_.on(SplatPass::splats)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "splats");
        irradiance_ = splats_.draw(picture_, surfaces_, photons_, photons_.powers(scene_.sources()),
                                   settings_.of<SplatSettings>(), *workers_);
        splatted_walks_ = photons_.walks();
        bad_ += splats_.counts().bad;
        if (irradiance_ == nullptr) {
            lose_photons();
        } else {
            splatted_.made(now_);
        }
    }
    if (!plan_.mirrors) {
        mirrors_.clear();
    } else if (plan_.on(SplatPass::mirrors)) {
        mirror(inputs);
    }
    return {.irradiance = irradiance_, .specular = plan_.mirrors ? &mirrors_.picture() : nullptr};
}

gpu::Texture SplatTechnique::debug_view(std::string_view name, const render::FrameInputs& inputs) {
    return plan_.unlit != Unlit::no || traced_.empty()
               ? gpu::Texture()
               : draw_splat_view(name, photons_, photons_.powers(scene_.sources()), picture_, surfaces_,
                                 settings_.of<SplatSettings>(), inputs);
}

GiStatistics SplatTechnique::statistics(bool) {
    GiStatistics result;
    result.plan = in_words(plan_, settings_);
    SplatStatistics counted;
    counted.walks = photons_.walks();
    counted.photons = photons_.all(false) + photons_.all(true);
    counted.caustic_photons = photons_.all(true);
    counted.rays = photons_.rays();
    counted.surfaces = surfaces_.count();
    counted.splatted = plan_.on(SplatPass::splats) ? splats_.counts().splatted : 0;
    counted.mirror_rays = plan_.on(SplatPass::mirror_rays) ? mirrors_.rays() : 0;
    counted.rounds = splats_.counts().rounds;
    counted.memory = photons_.store().most_memory();
    counted.on_disk = photons_.store().on_disk();
    counted.builds = scene_.builds();
    counted.error = error_;
    result.nan_count = photons_.bad() + bad_ + mirrored_.bad() + on_sensors_.bad() + mirrors_.bad();
    result.add(counted);
    return result;
}

TechniqueKind add_splat() {
    TechniqueEntry entry;
    entry.name = "splat";
    entry.docs = "photons traced exactly and splatted onto the picture (Lavignotte and Paulin 2003)";
    entry.has_presets = true;
    entry.reads = {"gi.splat.", "gi.specular.roughness", "gi.bounces", "gi.photons", "gi.seed"};
    entry.turns = {{"gi.photons", {"5000", "100000", "400000"}},
                   {"gi.splat.bandwidth", {"8", "12", "30"}},
                   {"gi.splat.kernel", {"epanechnikov"}},
                   {"gi.splat.boundaries", {"false"}}};
    entry.debug_views = splat_views();
    entry.declare = declare_splat_settings;
    entry.make = []() -> std::unique_ptr<Technique> { return std::make_unique<SplatTechnique>(); };
    entry.first_plan = first_splat_plan;
    entry.statistics_json = statistics_in_json;
    return add_technique(std::move(entry));
}

}  // namespace lanthorn::gi

#include "gi_module/techniques/path/path_technique.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/gpu/pass_end.h"
#include "gi_module/techniques/path/path.h"
#include "gi_module/techniques/path/path_views.h"

namespace lanthorn::gi {

namespace {

using Pass = PathPass;

std::string statistics_in_json(const GiStatistics& gi) {
    const auto& path = gi.of<PathStatistics>();
    return nlohmann::ordered_json{{"spp", path.spp},
                                  {"wanted_spp", path.wanted_spp},
                                  {"frame_spp", path.frame_spp},
                                  {"noise", path.noise},
                                  {"builds", path.builds}}
        .dump();
}

constexpr int kSensorSamples = 64;      // of each of the kSensorPoints of a sensor
constexpr float kOffset = 0x1p-16f;     // of its coordinates: how far off its surface a point's rays start
constexpr float kSensorOffset = 1e-4f;  // of the sensor's radius, at least

// Films have their rows from the top, textures from the bottom. `alphas`: by pixel; empty: 1.
void upload(const reference::Film& film, const std::vector<float>& alphas, ivec2 size,
            gpu::Texture& texture) {
    if (!texture || ivec2(texture.size()) != size) {
        texture = gpu::Texture::make_2d(GL_RGBA32F, size);
    }
    const std::vector<float> mean = film.mean();
    std::vector<vec4> texels;
    texels.reserve(mean.size() / 3);
    const auto width = static_cast<std::size_t>(size.x);
    for (auto y = static_cast<std::size_t>(size.y); y-- > 0;) {
        for (std::size_t i = y * width; i < (y + 1) * width; ++i) {
            texels.emplace_back(mean[3 * i], mean[3 * i + 1], mean[3 * i + 2],
                                alphas.empty() ? 1.0f : alphas[i]);
        }
    }
    glTextureSubImage2D(texture.id(), 0, 0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, texels.data());
}

}  // namespace

void PathTechnique::plan(const FrameScene& scene, ivec2 size, const GiSettings& settings) {
    const int threads = settings_.threads;
    settings_ = path_settings(settings);
    if (!workers_ || settings_.threads != threads) {
        workers_ = std::make_unique<reference::TileWorkers>(settings_.threads);
    }
    scene_versions_.follow(scene.changes);
    size_.follow(size);
    sample_settings_.follow({settings_.bounces, settings_.seed, settings_.transport, settings_.caustics,
                             settings_.unlimited, settings_.antialias});
    now_ = {scene_versions_.geometry, scene_versions_.surfaces, scene_versions_.lights,
            scene_versions_.camera + size_.version(), sample_settings_.version()};
    plan_ = make_path_plan(scene, settings_, now_, known_);
    statistics_.frame_spp = 0;
    statistics_.wanted_spp = settings_.spp;
    if (plan_.unlit != Unlit::no) {
        known_ = {};
        statistics_ = {};
        emitters_.reset();
        scene_.clear();
        samples_.reset();
        irradiance_ = {};
        radiance_ = {};
    } else if (!samples_ || samples_->size() != size) {
        samples_ = std::make_unique<reference::PixelSamples>(size, reference::SampleParts{.indirect = true});
    }
    if (plan_.begins_again) {
        ++light_version_;
        samples_->begin_again(
            {.indirect = true, .radiance = settings_.transport == reference::Transport::full});
        known_.noise = std::numeric_limits<double>::infinity();
    }
}

void PathTechnique::update(const render::LightInputs& inputs) {
    if (!plan_.on(Pass::paths) && (plan_.unlit != Unlit::no || inputs.scene.sensors.empty())) {
        return;
    }
    const gpu::PassTimer::Scope scope(inputs.timer, "acceleration_structure");
    const FrameScene& scene = inputs.scene;
    if (scene_.follow(scene) || plan_.begins_again) {
        emitters_.emplace(scene_.scene(), scene_.materials(), &scene_.pieces());
        lights_.emplace(scene);
    }
    if (of_sky_ != scene.sky) {
        of_sky_ = scene.sky;
        sky_ = reference::SkyLight(scene);
    }
    known_.structure.made(now_);
    statistics_.builds = scene_.builds();
}

render::IndirectLight PathTechnique::indirect(const render::FrameInputs& inputs) {
    if (plan_.unlit != Unlit::no) {
        return {};
    }
    if (plan_.on(Pass::paths)) {
        const reference::Integrator integrator(scene_.scene(), scene_.materials(), *emitters_, *lights_, sky_,
                                               settings_);
        const reference::CameraRays camera(inputs.scene.camera, samples_->size());
        const reference::PixelRays rays{integrator, camera, settings_};
        if (plan_.on(Pass::first_surfaces)) {
            const gpu::PassTimer::Scope scope(inputs.timer, "first_surfaces");
            samples_->look(rays, *workers_);
            known_.first_surfaces.made(now_);
        }
        const gpu::PassTimer::Scope scope(inputs.timer, "paths");
        samples_->trace(rays, plan_.frame_spp, *workers_,
                        gpu::PassEnd::is_heard() ? &gpu::PassEnd::tell : nullptr);
        known_.paths.made(now_);
        known_.spp = samples_->spp();
        if (known_.spp == reference::next_noise_check(known_.spp - 1)) {
            known_.noise = settings_.target_noise > 0 ? samples_->largest_noise() : known_.noise;
        }
        statistics_.spp = known_.spp;
        statistics_.frame_spp = plan_.frame_spp;
        show();
    }
    return {.irradiance = &irradiance_, .radiance = radiance_ ? &radiance_ : nullptr};
}

void PathTechnique::show() {
    upload(samples_->films()[0], {}, samples_->size(), irradiance_);
    if (samples_->parts().radiance) {
        upload(samples_->films()[2], samples_->coverage(scene_.scene(), scene_.materials()), samples_->size(),
               radiance_);
    } else {
        radiance_ = {};
    }
}

void PathTechnique::add_irradiance(const render::LightInputs& inputs, const render::SensorTargets& targets) {
    if (plan_.unlit != Unlit::no || !emitters_) {
        return;
    }
    const std::vector<SensorInstance>& sensors = inputs.scene.sensors;
    const std::vector<SensorPoint> points = sensor_points(scene_.scene(), sensors);
    const reference::Integrator integrator(scene_.scene(), scene_.materials(), *emitters_, *lights_, sky_,
                                           settings_);
    std::vector<vec4> irradiances(points.size());
    workers_->run(points.size(), [&](std::size_t i) {
        const SensorPoint& point = points[i];
        const vec3 far = glm::abs(point.position);
        const float offset =
            std::max(kOffset * std::max({far.x, far.y, far.z}), kSensorOffset * sensors[point.sensor].radius);
        std::vector<reference::IrradianceStart> starts;
        starts.reserve(kSensorSamples);
        for (int k = 0; k < kSensorSamples; ++k) {
            starts.push_back({point.position, point.normal, offset,
                              reference::RandomNumbers(settings_.seed, static_cast<std::uint32_t>(i),
                                                       static_cast<std::uint32_t>(k))});
        }
        std::vector<vec3> light(starts.size());
        integrator.irradiance(starts, light);
        vec3 sum(0);
        for (const vec3& l : light) {
            sum += std::isfinite(l.x + l.y + l.z) ? l : vec3(0);
        }
        irradiances[i] = vec4(sum / static_cast<float>(kSensorSamples), 0);
    });
    sensor_light_.add(points, irradiances, targets);
}

SampleProgress PathTechnique::progress() const {
    if (plan_.unlit != Unlit::no) {
        return {};
    }
    const bool quiet =
        settings_.target_noise > 0 && known_.noise <= static_cast<double>(settings_.target_noise);
    return {known_.spp, settings_.spp, known_.spp >= settings_.spp || quiet};
}

GiStatistics PathTechnique::statistics(bool count_photons) {
    GiStatistics result;
    result.plan = in_words(plan_, settings_);
    if (samples_) {
        statistics_.noise = count_photons ? samples_->largest_noise() : 0;
        result.nan_count = samples_->nan_count();
    }
    result.add(statistics_);
    return result;
}

gpu::Texture PathTechnique::debug_view(std::string_view name, const render::FrameInputs&) {
    return samples_ ? draw_path_view(name, *samples_) : gpu::Texture();
}

TechniqueKind add_path() {
    TechniqueEntry entry;
    entry.name = "path";
    entry.docs =
        "the path-traced reference (Kajiya 1986), mirrors and glass with it, a mean that grows while nothing "
        "changes";
    entry.is_reference = true;
    entry.reads = {"path.", "gi.bounces"};
    entry.turns = {{"path.spp", {"1", "4", "16", "64"}}};
    entry.debug_views = path_views();
    entry.declare = declare_path_settings;
    entry.make = []() -> std::unique_ptr<Technique> { return std::make_unique<PathTechnique>(); };
    entry.first_plan = first_path_plan;
    entry.statistics_json = statistics_in_json;
    return add_technique(std::move(entry));
}

}  // namespace lanthorn::gi

#include "lanthorn/workbench/photon_flights.h"

#include <fmt/format.h>

#include "gi_module/techniques/emc/emc_technique.h"
#include "lanthorn/core/error.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/runtime/shown_scene.h"

namespace lanthorn::workbench {

namespace {

constexpr ivec2 kImageSize(64, 64);  // photons do not depend on it

// The photons after each number of bounces from 0, and their arrivals.
class FlightRecorder {
  public:
    void record(const render::LightInputs& inputs, const gi::EnvironmentMaps& maps,
                const gi::GiSettings& settings, int bounces) {
        const auto count = static_cast<std::size_t>(settings.photons);
        for (int b = 0; b <= bounces; ++b) {
            tracing_.trace(inputs, maps, settings, b, 1.0, 0, {});
            rays_.push_back(tracing_.rays().read<gi::PhotonRay>(count));
        }
        hits_ = tracing_.arrived().read();
    }

    void describe(PhotonFlights& result) const {
        const std::size_t photons = rays_.front().size();
        for (std::size_t b = 0; b < rays_.size(); ++b) {
            std::vector<PhotonFlight> flights;
            dvec3 reflected(0);
            for (std::size_t i = 0; i < photons; ++i) {
                const gi::PhotonRay& ray = rays_[b][i];
                const dvec3 power{vec3(ray.power)};
                if (ray.direction.w <= 0) {
                    result.flux_without_surface += b == 0 ? power : dvec3(0);
                    continue;
                }
                reflected += power;
                if (b + 1 < rays_.size()) {
                    const gi::PhotonHit& hit = hits_[b * photons + i];
                    flights.push_back(
                        {vec3(ray.origin), vec3(ray.direction), power, hit.radius > 0, hit.position});
                }
            }
            result.flux_reflected.push_back(reflected);
            if (b + 1 < rays_.size()) {
                result.bounces.push_back(std::move(flights));
            }
        }
    }

  private:
    gi::PhotonTracing tracing_;
    std::vector<std::vector<gi::PhotonRay>> rays_;
    std::vector<gi::PhotonHit> hits_;
};

}  // namespace

PhotonFlights trace_photons(SceneData scene, const Settings& settings, const SceneChoice& choice) {
    const gi::GiSettings gi_settings = gi::gi_settings(settings);
    const std::string& technique_name = gi::technique_entry(gi_settings.technique).name;
    if (technique_name != "emc") {
        throw InputError(fmt::format("gi.technique: found '{}', expected emc, whose photons are measured",
                                     technique_name));
    }
    const std::string source = scene.source;
    std::unique_ptr<gpu::Context> context;  // before what draws in it
    ShownScene shown(std::move(scene), choice);
    App& app = shown.app();
    context = gpu::create_headless_context();
    gi::add_picture_plugins(app, settings);
    app.view().size = kImageSize;
    shown.show_at(choice.time.value_or(0));

    PhotonFlights result;
    result.frame = shown.frame();
    auto& technique = static_cast<gi::EmcTechnique&>(*app.world().resource<gi::ActiveTechnique>().technique);
    result.statistics = technique.statistics(true);
    FlightRecorder recorder;
    const bool recorded = app.world().resource<render::IndirectLight>().irradiance != nullptr;
    if (recorded) {
        const Renderer& renderer = app.world().resource<Renderer>();
        recorder.record(renderer.frame->light_inputs(result.frame, *renderer.timer), technique.maps(),
                        gi_settings, result.statistics.plan.bounces);
    }
    if (!recorded) {
        throw InputError(source, "",
                         "found no light that is reflected, expected some (gi.bounces is above 0)");
    }
    recorder.describe(result);
    for (const int selected : technique.maps().selected()) {
        result.map_centres.push_back(technique.maps().centre(selected));
    }
    result.candidates = technique.maps().candidates();
    return result;
}

}  // namespace lanthorn::workbench

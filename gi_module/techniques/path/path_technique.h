// `path`: the reference's own samples (Kajiya 1986; gi_module/reference), some of them in each frame. The
// picture is the mean of all since the scene, the view or a setting of theirs changed: after N samples a
// pixel it is what reference::PathTracer has after N. By full transport, the default, it makes the whole
// picture (render::IndirectLight::radiance), mirrors and glass with it; by diffuse transport irradiance
// alone.
#pragma once

#include <memory>
#include <optional>
#include <tuple>

#include "gi_module/reference/emitters.h"
#include "gi_module/reference/lights.h"
#include "gi_module/reference/pixel_samples.h"
#include "gi_module/reference/sky_light.h"
#include "gi_module/shared/photons/sensor_points.h"
#include "gi_module/shared/rays/followed_scene.h"
#include "gi_module/techniques/path/path_plan.h"
#include "gi_module/techniques/path/path_statistics.h"
#include "lanthorn/gi/technique.h"

namespace lanthorn::gi {

class PathTechnique final : public Technique {
  public:
    void plan(const FrameScene& scene, ivec2 size, const GiSettings& settings) override;
    // Follows what moved: O(what changed); O(triangles log triangles) when instances come or go.
    void update(const render::LightInputs& inputs) override;
    // O(pixels * path.frame_spp * bounces * log triangles). Memory: at most 300 bytes a pixel, however many
    // samples.
    render::IndirectLight indirect(const render::FrameInputs& inputs) override;
    // O(sensors * 1024 paths).
    void add_irradiance(const render::LightInputs& inputs, const render::SensorTargets& targets) override;
    std::uint64_t light_version() const override { return light_version_; }
    gpu::Texture debug_view(std::string_view name, const render::FrameInputs& inputs) override;
    SampleProgress progress() const override;
    GiStatistics statistics(bool count_photons) override;

  private:
    void show();

    // The settings that samples depend on.
    using SampleSettings = std::tuple<int, std::uint32_t, reference::Transport, bool, bool, bool>;

    reference::PathSettings settings_;
    PathPlan plan_;
    SceneVersions scene_versions_;
    Versioned<SampleSettings> sample_settings_;
    Versioned<ivec2> size_;
    PathStamps::Versions now_{};
    PathPictures known_;
    FollowedScene scene_;
    std::optional<reference::Emitters> emitters_;
    std::optional<reference::PunctualLights> lights_;
    std::optional<SkyInstance> of_sky_;  // what sky_ was made of
    reference::SkyLight sky_;
    std::unique_ptr<reference::TileWorkers> workers_;
    std::unique_ptr<reference::PixelSamples> samples_;
    gpu::Texture irradiance_;
    gpu::Texture radiance_;  // of full transport
    SensorLight sensor_light_;
    std::uint64_t light_version_ = 0;  // of what the samples are of
    PathStatistics statistics_;
};

}  // namespace lanthorn::gi

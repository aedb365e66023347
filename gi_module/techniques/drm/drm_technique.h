// `drm`: direct radiance mapping (Frisvad et al. 2005, "Direct Radiance Mapping: Scene Independent Real-Time
// Indirect Illumination"): one bounce, gathered by every pixel from a few samples of what each light sees.
// Nothing hides a sample, unless gi.drm.visibility asks.
#pragma once

#include <array>
#include <memory>

#include "gi_module/shared/mirrors/mirror_view.h"
#include "gi_module/techniques/drm/drm_gather.h"
#include "gi_module/techniques/drm/drm_plan.h"
#include "gi_module/techniques/drm/drm_settings.h"
#include "gi_module/techniques/drm/drm_statistics.h"
#include "gi_module/techniques/drm/radiance_map.h"
#include "lanthorn/gi/technique.h"

namespace lanthorn::gi {

class DrmTechnique final : public Technique {
  public:
    void plan(const FrameScene& scene, ivec2 size, const GiSettings& settings) override;
    render::TracedLobes traced_lobes() const override;
    // Pictures of the lights, and samples of them.
    void update(const render::LightInputs& inputs) override;
    render::IndirectLight indirect(const render::FrameInputs& inputs) override;
    void add_irradiance(const render::LightInputs& inputs, const render::SensorTargets& targets) override;
    std::uint64_t light_version() const override { return light_version_; }
    gpu::Texture debug_view(std::string_view name, const render::FrameInputs& inputs) override;
    GiStatistics statistics(bool count_photons) override;

    // Of the last frame that made any.
    const RadianceMap& map() const { return *map_; }

  private:
    void follow_light_maps(const render::LightInputs& inputs);
    void follow_rays(const render::LightInputs& inputs);
    void mirror(const render::FrameInputs& inputs);

    GiSettings settings_;
    DrmPlan plan_;
    DrmHistory history_;
    DrmStatistics statistics_;
    ivec2 size_{0};
    std::unique_ptr<RadianceMap> map_;  // null before the first frame with light
    DrmGather gather_;
    std::unique_ptr<MirrorView> mirrors_;  // null before the first frame with mirrors
    bool hidden_mirrors_ = false;          // what they show is lit by samples that something may hide
    std::unique_ptr<ExactRays> exact_;
    std::array<gpu::Program, 2> sensor_programs_;  // where nothing hides samples, and where something may
    gpu::Buffer bad_values_;
    std::uint64_t light_maps_ = 0;  // LightMaps::version()
    std::uint64_t light_version_ = 0;
    render::IndirectLight shown_;
};

}  // namespace lanthorn::gi

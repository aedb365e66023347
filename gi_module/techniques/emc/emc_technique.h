// `emc`: multi-image photon tracing (Yao et al. 2010): photons bounce through environment maps. They are
// counted on what the maps show, and rays gather that light (EmcFinal::gather, the default), or are splatted
// onto the picture, as published.
#pragma once

#include "gi_module/techniques/emc/caustics/caustic_photons.h"
#include "gi_module/techniques/emc/caustics/caustic_splats.h"
#include "gi_module/techniques/emc/emc_plan.h"
#include "gi_module/techniques/emc/emc_views.h"
#include "gi_module/techniques/emc/gather/gather.h"
#include "gi_module/techniques/emc/gather/still_gather.h"
#include "gi_module/techniques/emc/lit_maps/lit_maps.h"
#include "gi_module/techniques/emc/maps/environment_maps.h"
#include "gi_module/techniques/emc/maps/reserved_centres.h"
#include "gi_module/techniques/emc/photons/photon_tracing.h"
#include "gi_module/techniques/emc/photons/sensor_photons.h"
#include "gi_module/techniques/emc/specular/specular_view.h"
#include "gi_module/techniques/emc/splat/accumulation.h"
#include "gi_module/techniques/emc/splat/glossy_splats.h"
#include "gi_module/techniques/emc/splat/splatting.h"
#include "lanthorn/gi/technique.h"

namespace lanthorn::gi {

class EmcTechnique final : public Technique {
  public:
    void plan(const FrameScene& scene, ivec2 size, const GiSettings& settings) override;
    render::TracedLobes traced_lobes() const override;
    void update(const render::LightInputs& inputs) override;
    render::IndirectLight indirect(const render::FrameInputs& inputs) override;
    void add_eyes(DetailHints& hints, const dvec3& origin) const override { maps_.add_eyes(hints, origin); }
    void add_irradiance(const render::LightInputs& inputs, const render::SensorTargets& targets) override;
    std::uint64_t light_version() const override { return light_version_; }
    gpu::Texture debug_view(std::string_view name, const render::FrameInputs& inputs) override;
    ErrorEstimate estimate_error() override;
    GiStatistics statistics(bool count_photons) override;

    const EnvironmentMaps& maps() const { return maps_; }
    const PhotonTracing& photons() const { return photons_; }
    const CausticPhotons& caustics() const { return caustics_; }

  private:
    // Nothing is traced in this frame: there is no light, or no map to trace it in.
    bool idle() const { return plan_.bounces == 0 || results_.no_map; }
    bool gathers() const { return settings_.of<EmcSettings>().final_stage == EmcFinal::gather; }
    void reserve(const render::LightInputs& inputs);
    void update_maps(const render::LightInputs& inputs);
    void emit(const render::LightInputs& inputs);
    void trace_photons(const render::LightInputs& inputs, int pass);
    void update_lit_maps(const render::LightInputs& inputs);
    void splat(const render::FrameInputs& inputs);
    void gather(const render::FrameInputs& inputs);
    void gather_blended(const render::FrameInputs& inputs);
    void refine(const render::FrameInputs& inputs);
    void splat_glossy(const render::FrameInputs& inputs);
    void mirror(const render::FrameInputs& inputs);
    // The picture's irradiance, caustics and all.
    const gpu::Texture* shown() const { return with_caustics_ != nullptr ? with_caustics_ : irradiance_; }
    // Whether diffuse and mirrored light is followed through the maps (gi.emc.rays).
    bool through_maps() const;
    void follow_rays(const render::LightInputs& inputs);
    void trace_caustics(const render::LightInputs& inputs);
    void splat_caustics(const render::FrameInputs& inputs);
    void measure_area(const FrameScene& scene);
    void show_nothing() { irradiance_ = with_caustics_ = traced_ = specular_ = glossy_ = nullptr; }

    EnvironmentMaps maps_;
    PhotonTracing photons_;
    Splatting splatting_;
    Accumulation accumulation_;
    GlossySplats glossy_splats_;
    Accumulation glossy_accumulation_;
    LitMaps lit_maps_;
    Gather gather_;
    std::unique_ptr<Gather> blended_gather_;  // null: no blended surface is in view, or nothing gathers
    StillGather still_gather_;
    SpecularView specular_view_;
    UnseenSurvey survey_;  // the last one
    SweptBoxes movers_;
    std::unique_ptr<ExactRays> exact_;  // null: nothing needs them
    ExactRays* gather_rays_ = nullptr;  // exact_; null: the gather's rays go through the maps
    CausticPhotons caustics_;
    CausticSplats caustic_splats_;
    bool compare_rays_ = false;  // gi.emc.rays is fastest, and it is not known yet what is
    bool prefer_maps_ = false;   // it is known, and they are
    SensorPhotons sensor_photons_;
    bool sensors_lack_photons_ = false;  // theirs are of other light, or there are none
    std::uint64_t light_version_ = 0;
    std::uint64_t caustic_version_ = 0;  // CausticPhotons::version() of the last frame; 0: it had none
    EmcInputs inputs_;
    EmcFrame frame_;  // this one
    EmcPlan plan_;    // of it, from update() on; and what became of it
    EmcResults results_;
    EmcKept kept_;
    GiSettings settings_;            // of this frame
    std::uint64_t lit_version_ = 0;  // EnvironmentMaps::version() of the last frame with lit maps
    struct InstanceArea {
        std::uint32_t id = 0;
        std::uint32_t mesh = 0;
        std::uint64_t version = 0;
        std::uint64_t mesh_version = 0;
        mat3 linear{1};   // what turns and scales it
        double area = 0;  // m^2

        bool same_shape(const InstanceArea& o) const {
            return id == o.id && mesh == o.mesh && version == o.version && mesh_version == o.mesh_version &&
                   linear == o.linear;
        }
    };
    std::vector<InstanceArea> areas_;              // in order of instances
    double total_area_ = 0;                        // of all
    bool area_outdated_ = true;                    // measured when photons next ask
    const gpu::Texture* irradiance_ = nullptr;     // of the final stage
    const gpu::Texture* with_caustics_ = nullptr;  // null: there are none
    const gpu::Texture* traced_ = nullptr;         // specular light, by rays
    const gpu::Texture* glossy_ = nullptr;         // by photons
    const gpu::Texture* specular_ = nullptr;       // both
    EmcViews views_;
};

}  // namespace lanthorn::gi

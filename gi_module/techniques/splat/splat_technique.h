// `splat`: photons traced exactly from the lights and splatted onto the picture (Lavignotte and Paulin 2003,
// "Scalable Photon Splatting for Global Illumination"). Coarse at once, better while nothing changes,
// accurate in the end; the camera may move without a photon traced again.
#pragma once

#include <memory>
#include <tuple>
#include <vector>

#include "gi_module/shared/photons/photon_mirrors.h"
#include "gi_module/shared/photons/photon_scene.h"
#include "gi_module/shared/photons/sensor_points.h"
#include "gi_module/shared/stamps.h"
#include "gi_module/techniques/splat/photon_collection.h"
#include "gi_module/techniques/splat/photon_splats.h"
#include "gi_module/techniques/splat/picture_surfaces.h"
#include "gi_module/techniques/splat/point_splats.h"
#include "gi_module/techniques/splat/sensor_splats.h"
#include "gi_module/techniques/splat/splat_plan.h"
#include "gi_module/techniques/splat/splat_settings.h"
#include "gi_module/techniques/splat/splat_statistics.h"
#include "gi_module/techniques/splat/splat_surfaces.h"
#include "lanthorn/gi/technique.h"

namespace lanthorn::gi {

class SplatTechnique final : public Technique {
  public:
    void plan(const FrameScene& scene, ivec2 size, const GiSettings& settings) override;
    render::TracedLobes traced_lobes() const override;
    // Follows what moved, traces photons.
    void update(const render::LightInputs& inputs) override;
    // Waits for the GPU: whose surface a pixel shows is asked of its G-buffer.
    render::IndirectLight indirect(const render::FrameInputs& inputs) override;
    // Photons about points of the sensors' discs, on the processor.
    void add_irradiance(const render::LightInputs& inputs, const render::SensorTargets& targets) override;
    std::uint64_t light_version() const override { return light_version_; }
    gpu::Texture debug_view(std::string_view name, const render::FrameInputs& inputs) override;
    GiStatistics statistics(bool count_photons) override;

  private:
    // What photons, the picture and its item buffer are made from beside the scene.
    enum class Input { photons, picture, size };
    using Made = Stamps<Input, 3>;
    using TracedBy = std::tuple<int, int, PhotonScattering, int, int, std::uint32_t, int, int>;
    using SplattedBy = std::tuple<float, float, PhotonKernel, bool, SplatAdaptive, int, int, int, float>;

    void follow(const GiSettings& settings, ivec2 size);
    void mirror(const render::FrameInputs& inputs);
    // Photons that were on disk are lost: traced anew in the next frame.
    void lose_photons();

    GiSettings settings_;
    SplatPlan plan_;
    Versioned<TracedBy> traced_by_;
    Versioned<SplattedBy> splatted_by_;
    Versioned<ivec2> size_;
    Made::Versions now_{};
    Made traced_{Input::photons};
    Made splatted_{Input::picture, Input::size};
    Made seen_{Input::size};
    std::unique_ptr<reference::TileWorkers> workers_;
    PhotonScene scene_;
    SplatSurfaces surfaces_;
    PhotonCollection photons_;
    PictureSurfaces picture_;
    PhotonSplats splats_;
    PhotonMirrors mirrors_;
    PointSplats mirrored_;
    SensorSplats on_sensors_;
    std::vector<SensorInstance> sensors_;
    SensorLight sensor_light_;
    std::uint64_t light_version_ = 0;
    std::uint64_t light_maps_ = 0;  // LightMaps::version()
    bool full_ = false;
    std::string error_;
    std::uint64_t splatted_walks_ = 0;
    std::uint64_t bad_ = 0;  // pixels that were not numbers so far
    const gpu::Texture* irradiance_ = nullptr;
};

}  // namespace lanthorn::gi

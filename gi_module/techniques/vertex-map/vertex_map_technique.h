// `vertex-map`: photons of several frames in a k-d tree, light estimated from them at the vertices of the
// triangles that are drawn (Jozwowski 2002, "Real Time Photon Mapping"). Traces on the processor by Embree.
#pragma once

#include <memory>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "gi_module/shared/photons/photon_mirrors.h"
#include "gi_module/shared/photons/sensor_points.h"
#include "gi_module/shared/stamps.h"
#include "gi_module/techniques/vertex-map/photon_turns.h"
#include "gi_module/techniques/vertex-map/shot_scene.h"
#include "gi_module/techniques/vertex-map/vertex_map_plan.h"
#include "gi_module/techniques/vertex-map/vertex_map_settings.h"
#include "gi_module/techniques/vertex-map/vertex_map_statistics.h"
#include "gi_module/techniques/vertex-map/vertex_picture.h"
#include "gi_module/techniques/vertex-map/vertex_scene.h"
#include "lanthorn/gi/technique.h"

namespace lanthorn::gi {

class VertexMapTechnique final : public Technique {
  public:
    void plan(const FrameScene& scene, ivec2 size, const GiSettings& settings) override;
    render::TracedLobes traced_lobes() const override;
    // Stages 1 and 2 of fig. 9: shoots the photons, balances the tree.
    void update(const render::LightInputs& inputs) override;
    // Stage 3: estimates and picture. Waits for the GPU where the picture shows other triangles than before.
    render::IndirectLight indirect(const render::FrameInputs& inputs) override;
    // Estimates at points of the sensors' discs.
    void add_irradiance(const render::LightInputs& inputs, const render::SensorTargets& targets) override;
    std::uint64_t light_version() const override { return light_version_; }
    gpu::Texture debug_view(std::string_view name, const render::FrameInputs& inputs) override;
    GiStatistics statistics(bool count_photons) override;

  private:
    const VertexMapSettings& own() const { return settings_.of<VertexMapSettings>(); }
    void forget();
    // What everything, and what the picture alone, is made from beside the scene.
    enum class Input { settings, size, skip };
    using Made = Stamps<Input, 3>;
    using MadeBy = std::tuple<int, int, int, PhotonDistribution, float, float, int, bool, float, int,
                              EstimateKernel, bool, bool, bool, TreeKind, int, std::uint32_t, int>;
    void follow(const GiSettings& settings, ivec2 size);
    // Photons on what has moved go along with it, until they are shot anew.
    void carry_photons(const FrameScene& scene);
    void follow_triangles(const FrameScene& scene);
    void find_seen(const render::FrameInputs& inputs);
    void follow_mirror_rays(const render::FrameInputs& inputs);
    void estimate(const render::FrameInputs& inputs);
    void mirror(const render::FrameInputs& inputs);

    GiSettings settings_;
    VertexMapPlan plan_;
    Versioned<MadeBy> made_by_;
    Versioned<ivec2> size_;
    Versioned<SkippedVertices> skip_;
    Made::Versions now_{};
    Made begun_{Input::settings};
    Made pictured_{Input::size, Input::skip};
    std::unique_ptr<reference::TileWorkers> workers_;
    ShotScene scene_;
    PhotonTurns turns_;
    PhotonStore store_;
    std::unordered_map<SurfaceKey, mat4> placed_;  // where instances stood in the last frame that was shot in
    std::unique_ptr<PhotonTree> tree_;
    std::uint64_t version_ = 0;  // of the photons in the tree
    VertexScene vertices_;
    bool vertices_known_ = false;
    bool refines_ = false;             // the last frame has split triangles otherwise
    bool may_coarsen_ = true;          // light has changed since all photons were of it
    std::uint64_t since_refined_ = 0;  // photons shot
    std::vector<std::uint32_t> seen_;  // by triangle; empty: all
    VertexPicture picture_;
    std::vector<vec4> light_, lamp_light_;  // by corner: indirect; direct, where photons bring it
    const gpu::Texture* irradiance_ = nullptr;
    const gpu::Texture* lamps_ = nullptr;  // IndirectLight::lamps
    FollowedScene unsimplified_;           // what mirrors show, where photons meet coarser shapes
    PhotonMirrors mirrors_;
    std::vector<std::optional<VertexScene::At>> mirrored_;  // by hit of mirrors_
    std::vector<SensorInstance> sensors_;
    SensorLight sensor_light_;
    std::uint64_t light_version_ = 0;
    std::uint64_t light_maps_ = 0;  // LightMaps::version()
    VertexMapStatistics statistics_;
    std::uint64_t bad_ = 0;  // photons left out so far
};

}  // namespace lanthorn::gi

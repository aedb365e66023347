// Caustic photons on their way through maps, where there are no exact rays (Yao et al. 2010, sec. 7): things
// that light goes through have a map of their own, from the middle of their box (Szirmay-Kalos et al. 2005,
// "Approximate Ray-Tracing on the GPU with Distance Impostors").
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gi_module/shared/caustics/caustic_aim.h"
#include "gi_module/shared/caustics/caustic_photon.h"
#include "gi_module/techniques/emc/maps/environment_maps.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/render/frame.h"

namespace lanthorn::gi {

class CausticMaps {
  public:
    // Things with maps of their own, at most: the largest. Light ends at the others that it would go through.
    static constexpr std::size_t kMostCasters = 16;

    // The maps of a frame: those of `maps`, copied, and the targets', drawn. Cost: the targets' triangles,
    // six faces a map.
    void follow(const render::LightInputs& inputs, const EnvironmentMaps& maps,
                const CausticTargets& targets);
    // Where photons land that have met mirrors and glass alone. Waits for the GPU.
    std::vector<PhotonHit> trace(const render::LightInputs& inputs, const EnvironmentMaps& maps,
                                 const GiSettings& settings, std::span<const CausticPhoton> photons);
    std::uint64_t take_bad_values();

  private:
    struct Target {  // caustic_maps.comp
        vec4 lower, upper;
    };

    gpu::Program program_;
    std::optional<MapRenderer> renderer_;
    CubeMaps all_;
    std::vector<vec4> centres_;  // by slot
    std::vector<Target> targets_;
    gpu::Buffer targets_buffer_, bad_values_;
};

}  // namespace lanthorn::gi

// The caustic photons of a scene: sent towards what mirrors light or lets it through, traced there by exact
// rays, kept by light (Yao et al. 2010, sec. 7). Some are sent everywhere, since what they meet first may
// scatter light on to a mirror.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "gi_module/shared/rays/exact_rays.h"
#include "gi_module/techniques/emc/caustics/caustic_emission.h"
#include "gi_module/techniques/emc/caustics/caustic_maps.h"
#include "gi_module/techniques/emc/photons/photon_set.h"
#include "lanthorn/emc/emc_statistics.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/render/frame.h"

namespace lanthorn::gi {

class CausticPhotons {
  public:
    // Traces photons of the lights and the sky; where only lights have changed (`keep`), of those alone that
    // have. `rays` must follow the scene; null: through maps, and none of light that something scatters.
    void trace(const render::LightInputs& inputs, ExactRays* rays, const EnvironmentMaps& maps,
               const GiSettings& settings, bool keep);
    // Where they have landed; radius is the splat's. Those of light that nothing has scattered come first.
    const std::vector<PhotonHit>& hits() const { return hits_; }
    std::size_t straight_hits() const { return straight_hits_; }
    std::uint64_t version() const { return version_; }  // grows whenever hits() may differ
    CausticStatistics statistics() const;

  private:
    struct Flown {
        CausticSource aimed, around;
        int aimed_count = 0, around_count = 0;
        CausticArrivals arrived = {};
    };
    void fly(Flown& flown, const render::LightInputs& inputs, ExactRays* rays, const EnvironmentMaps& maps,
             const CausticTargets& targets, const GiSettings& settings, float widest);

    std::optional<SkyInstance> sky_;  // that sky_source_ is of
    std::shared_ptr<const CausticSky> sky_source_;
    CausticMaps maps_;
    std::vector<Flown> flown_;
    std::vector<PhotonHit> hits_;
    std::size_t straight_hits_ = 0;
    std::uint64_t version_ = 0;
    std::uint64_t bad_values_ = 0;
    int traced_ = 0;  // by the last trace()
};

// How many of `photons` each source sends: by flux, in steps, so that a light that changes a little leaves
// the others theirs. At most `photons` together, and of a source that sends any at least one where there are
// as many.
std::vector<int> shared_out(const std::vector<double>& fluxes, int photons);

}  // namespace lanthorn::gi

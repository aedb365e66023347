// Caustic photons on their way over mirrors and through glass: the surfaces themselves, by Embree, as the
// reference meets them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lanthorn/gi/emc/caustic_photon.h"
#include "lanthorn/gi/emc/photon.h"
#include "lanthorn/reference/material_table.h"
#include "lanthorn/reference/random.h"
#include "lanthorn/reference/trace_scene.h"

namespace lanthorn::gi {

class CausticChains {
  public:
    CausticChains(const reference::TraceScene& scene, const reference::MaterialTable& materials,
                  std::span<const std::uint32_t> target_of, std::uint32_t seed)
        : scene_(scene), materials_(materials), target_of_(target_of), seed_(seed) {}

    // Adds where the photon arrives. At each mirror or glass it goes one of the ways, by Fresnel and a number
    // of its own, and ends there by what is absorbed: power hardly changes on the way.
    void follow(const CausticPhoton& photon, std::vector<PhotonHit>& arrivals) const;

  private:
    struct Flight;
    bool meet(const Flight& flight, reference::SurfaceHit& hit) const;
    bool scatter(const reference::SurfaceHit& hit, const reference::SurfaceMaterial& surface,
                 const reference::RandomNumbers& random, std::uint32_t dimension, Flight& flight) const;

    const reference::TraceScene& scene_;
    const reference::MaterialTable& materials_;
    std::span<const std::uint32_t> target_of_;
    std::uint32_t seed_;
};

}  // namespace lanthorn::gi

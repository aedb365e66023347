// Caustic photons on their way over mirrors and through glass: the surfaces themselves, by Embree, as the
// reference meets them. Every way of light that has a mirror or glass in it is followed here, and no other:
// those belong to the diffuse light, which ends at mirrors and glass.
//
// A photon that is aimed at a target goes over mirrors and through glass to where it lands. One in `kShare`
// of these goes on from there, scattered. A photon that is aimed at none is scattered by what it meets first.
// Wherever a photon is scattered it goes both ways: to a target, aimed as a lamp's would be, and anywhere
// else, with light that has met a mirror or glass already.
#pragma once

#include <cstdint>

#include "gi_module/reference/material_table.h"
#include "gi_module/reference/random.h"
#include "gi_module/reference/trace_scene.h"
#include "gi_module/shared/caustics/caustic_aim.h"
#include "gi_module/shared/caustics/caustic_photon.h"

namespace lanthorn::gi {

class CausticChains {
  public:
    // What scatters light, and mirrors but for those that light meets straight from its lamp, reflect it at
    // most `bounces` times before it arrives. All must outlive this.
    CausticChains(const reference::TraceScene& scene, const reference::MaterialTable& materials,
                  const CausticTargets& targets, int bounces, std::uint32_t seed)
        : scene_(scene), materials_(materials), targets_(targets), bounces_(bounces), seed_(seed) {}

    // Adds where the photon arrives. At each mirror or glass it goes one of the ways, by Fresnel and a number
    // of its own, and ends there by what is absorbed: power hardly changes on the way.
    void follow(const CausticPhoton& photon, CausticArrivals& arrivals) const;

  private:
    struct Flight;
    struct Numbers;
    struct Landing;
    bool meet(const Flight& flight, reference::SurfaceHit& hit) const;
    bool scatter(const reference::SurfaceHit& hit, const reference::SurfaceMaterial& surface,
                 const reference::RandomNumbers& random, std::uint32_t dimension, Flight& flight) const;
    // Over mirrors and through glass, the first of them a part of `target`. False: it lands nowhere.
    bool chain(Flight flight, std::uint32_t target, float range, const reference::RandomNumbers& random,
               std::uint32_t dimension, std::vector<PhotonHit>& arrivals, Landing& landing) const;
    // From a surface that scatters light, whatever it meets.
    void walk(Landing at, Numbers& numbers, std::vector<PhotonHit>& arrivals) const;
    // A direction towards a target from there: power over what arrives, and the target. 0: none.
    float aim(const Landing& at, Numbers& numbers, vec3& direction, std::uint32_t& target) const;

    const reference::TraceScene& scene_;
    const reference::MaterialTable& materials_;
    const CausticTargets& targets_;
    int bounces_;
    std::uint32_t seed_;
};

}  // namespace lanthorn::gi

// Caustic photons leave their lights. Pure functions, no GL.
//
// Each is aimed at one target and counts only if what it meets first belongs to that one: where targets
// overlap as a light sees them nothing is counted twice, and what is hidden from the light gets nothing.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "gi_module/shared/caustics/caustic_aim.h"
#include "gi_module/shared/caustics/caustic_photon.h"
#include "gi_module/shared/caustics/caustic_sky.h"
#include "lanthorn/render/emissive.h"

namespace lanthorn::gi {

// What sends caustic photons: a punctual light, the surface of an emissive instance, or the sky.
class CausticSource {
  public:
    CausticSource(const LightInstance& light, const CausticTargets& targets);
    CausticSource(const render::EmissiveTriangles& triangles, std::size_t surface,
                  const CausticTargets& targets);
    CausticSource(std::shared_ptr<const CausticSky> sky, const CausticTargets& targets);

    // Flux aimed at all targets together, lumen, luminance; of surfaces, spots and the sky an
    // estimate.
    double flux() const { return flux_; }
    // Whether it sends the same photons as `o` does.
    bool operator==(const CausticSource& o) const;

    // `count` photons, split over the targets by flux; pass `pass` goes on with the sequences of the one
    // before. Their power is exact whatever the split: expectation over the random numbers is what the light
    // sends. O(targets + count).
    std::vector<CausticPhoton> emit(int count, std::uint32_t seed, int pass) const;

  private:
    struct Share {
        CausticTarget target;
        double flux;
        std::uint32_t index;  // of the target
    };
    CausticPhoton emit_one(const Share& share, const CausticAim& aim, double weight, const glm::dvec2& u,
                           const glm::dvec2& v) const;
    CausticPhoton from_sky(const Share& share, double weight, const glm::dvec2& u, const glm::dvec2& v) const;

    std::shared_ptr<const CausticSky> sky_;  // null: it is another source
    bool punctual_ = true;
    LightInstance light_;
    std::vector<render::EmissiveTriangleData> triangles_;  // of the surface; p0.w: cumulative, 0..1
    std::uint32_t id_ = 0;                                 // of the light, or of the instance
    double far_ = 0;                                       // metres that a beam starts before a target
    std::vector<Share> shares_;                            // those that it reaches
    double flux_ = 0;
};

}  // namespace lanthorn::gi

// What light sensors read: photons on and about their discs. A sensor is one number, so that no oracle can
// look at neighbours; the bandwidth is the widest whose reading narrower ones do not contradict (Lepskii
// 1991): where light is even it averages as many photons as a pixel does, and light that falls through a
// door's gap is not spread over the wall.
#pragma once

#include <span>
#include <vector>

#include "gi_module/shared/photons/sensor_points.h"
#include "gi_module/techniques/splat/photon_collection.h"
#include "gi_module/techniques/splat/picture_surfaces.h"
#include "gi_module/techniques/splat/splat_settings.h"

namespace lanthorn::gi {

class SensorSplats {
  public:
    // By point, lux: what its sensor reads, the mean over the sensor's points. Points of one sensor follow
    // each other. False where photons could not be read: photons.store().error() says why. No GL.
    // O(points * photons within h of a sensor + sensors * blocks).
    bool light(std::span<const SensorPoint> points, const SplatSurfaces& surfaces, PhotonCollection& photons,
               std::span<const vec3> powers, const SplatSettings& settings, reference::TileWorkers& workers,
               std::vector<vec4>& irradiances);
    std::uint64_t bad() const { return bad_; }  // readings that were not numbers so far

  private:
    std::uint64_t bad_ = 0;
};

// Photons averaged within one bandwidth.
struct SensorLevel {
    dvec3 lux{0};
    double variance = 0;        // of the luminance, lux^2, as photons come by chance
    std::uint64_t photons = 0;  // that make it
};
// The level that is read: the first, widest one that none behind it contradicts beyond chance. Those of fewer
// than `least` photons say nothing. `levels`: from the widest on, at least one. Pure.
std::size_t sensor_level(std::span<const SensorLevel> levels, std::uint64_t least);

}  // namespace lanthorn::gi

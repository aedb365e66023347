// Stage 3 of Jozwowski 2002 (sec. 3.2 and 4.1.3, fig. 7): light at a point from the photons nearest to it.
//
// As there, the flux of the nearest m photons over the area that they were found in. Two things are mended
// that blur or darken it: only photons of the point's own surface count, on the side that it faces (there:
// all within reach, other walls and the backs of thin ones too); and the area is what of the surface lies
// within the radius (there: the whole circle, of which half lies outside at an edge and three quarters at a
// corner).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "gi_module/techniques/vertex-map/photon_tree.h"

namespace lanthorn::gi {

enum class EstimateKernel { constant, epanechnikov };

// What of a circle about a point on a surface is surface, by radius: at kSteps radii up to the largest, which
// lie closer the smaller they are. More than 1 where the surface is folded.
struct SurfaceShares {
    static constexpr std::size_t kSteps = 16;
    std::array<float, kSteps> shares = filled();  // shares[k]: of radius step(k)
    // Of the largest radius.
    static constexpr float step(std::size_t k) {
        const float root = static_cast<float>(k + 1) / kSteps;
        return root * root;
    }

    // `u`: radius over the largest one, 0..1. Linear in its root between the steps; below the first, as
    // there.
    float at(float u) const;

  private:
    static constexpr std::array<float, kSteps> filled() {
        std::array<float, kSteps> ones{};
        for (float& one : ones) {
            one = 1;
        }
        return ones;
    }
};

struct EstimateSettings {
    std::size_t nearest = 100;  // m, at least 1
    float distance = 1;         // metres: photons further away never count
    EstimateKernel kernel = EstimateKernel::constant;
    // As the thesis has it: other surfaces' photons and sides count too. The tree has them together then.
    bool any_surface = false;
};

// Where light is estimated.
struct EstimatePoint {
    vec3 position{0};
    vec3 normal{0, 0, 1};  // unit
    SurfaceKey surface = 0;
};

struct LightEstimate {
    vec3 irradiance{0};         // lux, indirect
    vec3 from_lamps{0};         // lux, direct light, where photons have it
    float radius = 0;           // metres that its photons were found within
    std::uint32_t photons = 0;  // that count
};

// Cosine between the point's normal and that of a photon's triangle from which on they are of one surface.
inline constexpr float kSameSurface = 0.5f;

class RadianceEstimate {
  public:
    // Of the m - 1 nearest photons over the circle that the m-th lies on, which has the right mean (Moore and
    // Yackel 1977; m over it is too bright by m / (m - 1)); where there are fewer within settings.distance,
    // all of them over that circle. `shares`: of circles up to settings.distance. `first_radius`: where to
    // look first, metres, as that of the frame before; changes the time alone. O(m + log n).
    LightEstimate at(const EstimatePoint& point, const SurfaceShares& shares, const PhotonTree& tree,
                     const PhotonStore& store, const EstimateSettings& settings, float first_radius);

  private:
    std::vector<NearPhoton> found_;  // kept for its memory
};

// The nearest photons that count, at most m, in no order: for tests, and what at() begins with.
// `radius`: where to look first. Returns whether all within settings.distance were looked at.
bool nearest_photons(const EstimatePoint& point, const PhotonTree& tree, const PhotonStore& store,
                     const EstimateSettings& settings, float radius, std::vector<NearPhoton>& found);

}  // namespace lanthorn::gi

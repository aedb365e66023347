// The sky as a source of caustic photons: directions by its light and by how much of a box lies across them.
// Pure functions, no GL.
#pragma once

#include <array>
#include <vector>

#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

class CausticSky {
  public:
    // O(pixels of the image).
    explicit CausticSky(const SkyInstance& sky);

    // How much of its light enters a box from all sides, lumen, luminance: an upper bound, above by what a
    // pixel's width adds. 0 for a black sky.
    double flux_towards(const Aabb& box) const;

    struct Entry {
        dvec3 place{0};   // on the box
        dvec3 to_sky{0};  // unit; where it comes from
        dvec3 power{0};   // lumen; the mean over all numbers is what enters the box
    };
    // For u and v in [0, 1)^2, while flux_towards() is not 0. A beam enters a convex box once. O(log pixels).
    Entry enter(const Aabb& box, const glm::dvec2& u, const glm::dvec2& v) const;

  private:
    SkyImage image_;
    glm::dmat3 to_render_{1};
    dvec3 scale_{0};
    std::array<std::vector<double>, 3> cumulative_;  // by axis of a face and pixel: lux on it, luminance
};

}  // namespace lanthorn::gi

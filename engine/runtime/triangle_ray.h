// A ray and triangles that leave no gap where they meet (Woop, Benthin and Wald 2013), in double precision.
#pragma once

#include <optional>

#include "lanthorn/core/math.h"

namespace lanthorn {

class TriangleRay {
  public:
    // `direction` is not zero.
    explicit TriangleRay(const dvec3& direction);

    struct Hit {
        double distance = 0;             // in lengths of the direction; may be negative
        dvec3 barycentric{0};            // of the three corners
        bool counter_clockwise = false;  // as seen from the ray's origin
    };
    // Corners relative to the ray's origin. None for a triangle that is seen edge-on or has no area.
    std::optional<Hit> meet(const dvec3& a, const dvec3& b, const dvec3& c) const;

  private:
    dvec3 sheared(const dvec3& p) const {
        return {p[x_] - shear_.x * p[z_], p[y_] - shear_.y * p[z_], shear_.z * p[z_]};
    }
    int x_ = 0, y_ = 1, z_ = 2;
    dvec3 shear_{0};
};

}  // namespace lanthorn

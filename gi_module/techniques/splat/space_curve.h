// A curve through a box on which places that follow each other lie near each other (Morton 1966).
#pragma once

#include <cstdint>

#include "lanthorn/core/math.h"

namespace lanthorn::gi {

class SpaceCurve {
  public:
    // 2^bits cells each way; at most 10 bits.
    SpaceCurve(const Aabb& box, int bits)
        : lower_(box.lower),
          last_(static_cast<float>((1 << bits) - 1)),
          scale_(last_ / glm::max(box.size(), vec3(1e-30f))) {}

    // Of the cell that the point lies in, 3 * bits long.
    std::uint32_t place(const vec3& point) const {
        const glm::uvec3 cell(glm::clamp((point - lower_) * scale_, vec3(0), vec3(last_)));
        return spread(cell.x) | spread(cell.y) << 1 | spread(cell.z) << 2;
    }

  private:
    // Every third bit of 30 from the lowest ten.
    static std::uint32_t spread(std::uint32_t x) {
        x = (x | x << 16) & 0x030000ffu;
        x = (x | x << 8) & 0x0300f00fu;
        x = (x | x << 4) & 0x030c30c3u;
        return (x | x << 2) & 0x09249249u;
    }

    vec3 lower_;
    float last_;
    vec3 scale_;
};

}  // namespace lanthorn::gi

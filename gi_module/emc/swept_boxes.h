// Where things that move are and have been since the frame before: what a remembered ray must not cross.
#pragma once

#include <cstdint>
#include <vector>

#include "lanthorn/gpu/program.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

class SweptBoxes {
  public:
    static constexpr std::size_t kMost = 16;  // MAX_BOXES of remembered_verify.comp

    // Once a frame. Of each instance that moved, came or went the box around both its bounds; when there are
    // more than kMost, those whose union grows least become one. O(instances), and cubic in what moved beyond
    // kMost.
    void follow(const FrameScene& scene);
    const std::vector<Aabb>& boxes() const { return boxes_; }  // render space

    // box_count, box_lower and box_upper, widened by `margin` metres.
    void set(const gpu::Program& program, float margin) const;

  private:
    struct Placed {
        std::uint32_t id = 0;
        std::uint32_t mesh = 0;
        Aabb bounds;
    };
    std::vector<Placed> placed_;  // of the frame before, in FrameScene's order
    dvec3 origin_{0};
    std::vector<Aabb> boxes_;
};

}  // namespace lanthorn::gi

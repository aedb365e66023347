// Things that move, since the frame before: the boxes that they sweep, which a remembered ray must not cross,
// and how each carries the points on it along.
#pragma once

#include <cstdint>
#include <vector>

#include "lanthorn/gpu/program.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

struct Mover {
    Aabb before{};       // render space, of this frame
    Aabb swept{};        // around where it was and is
    mat4 carry{1};       // from where a point on it was to where it is
    bool rigid = false;  // `carry` holds: one instance, that was there before
};

class SweptBoxes {
  public:
    static constexpr std::size_t kMost = 16;  // MAX_CARRIES of remembered_carry.comp

    // Once a frame. One for each instance that moved, came or went; when there are more than kMost, those
    // whose boxes grow least by it become one. O(instances), and O(kMost^2) for each beyond kMost.
    void follow(const FrameScene& scene);
    const std::vector<Mover>& movers() const { return movers_; }

    // Of remembered_carry.comp: carry_count, and of each rigid one its box before, widened, and the rows of
    // `carry`.
    void set_carries(const gpu::Program& program, float margin) const;

  private:
    struct Placed {
        std::uint32_t id = 0;
        std::uint32_t mesh = 0;
        Aabb bounds;
        mat4 transform{1};
    };
    std::vector<Placed> placed_;  // of the frame before, in FrameScene's order
    dvec3 origin_{0};
    std::vector<Mover> movers_;
};

}  // namespace lanthorn::gi

// Things that move, since the frame before: the boxes that they sweep, which a remembered ray must not cross,
// and how each carries the points on it along.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "gi_module/techniques/emc/gather/limb_boxes.h"
#include "gi_module/techniques/emc/gather/swept_grid.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

struct Mover {
    Aabb before{};                  // render space, of this frame
    Aabb swept{};                   // around where it was and is
    mat4 carry{1};                  // from where a point on it was to where it is
    bool rigid = false;             // `carry` holds: one instance, that was there before and does not deform
    std::vector<LimbMotion> limbs;  // how parts of one that deforms have moved, where that is known
};

class SweptBoxes {
  public:
    static constexpr std::size_t kMost = 16;  // MAX_MOVERS of remembered_carry.comp

    // Once a frame. One mover for each instance that moved, came or went; when there are more than kMost,
    // those whose boxes grow least by it become one. O(instances), and O(kMost^2) for each beyond kMost;
    // O(vertices) of what deforms, while there is room for boxes of limbs.
    void follow(const FrameScene& scene, float local_length);
    const std::vector<Mover>& movers() const { return movers_; }
    // What they all sweep: a box for each mover, or for each limb of one that deforms; at most kMost.
    const std::vector<Aabb>& boxes() const { return boxes_; }
    // The same without limbs: fewer, and larger. What has crossed a mover has met one of these and one of
    // boxes().
    const std::vector<Aabb>& whole() const { return whole_; }
    bool has_limbs() const { return has_limbs_; }  // else the two are the same
    // Whether more than kMost have moved: grid() knows then where they sweep, and where there is air between
    // them.
    bool are_many() const { return !grid_.empty(); }
    const SweptGrid& grid() const { return grid_; }

    // What carries points along: rigid movers, and limbs of those that deform.
    struct Carry {
        Aabb before;
        mat4 carry{1};
        bool bends = false;  // what it carries ends up beside its surface
    };
    // Mover by mover; O(limbs).
    std::vector<std::vector<Carry>> carries() const;

  private:
    using Key = std::pair<std::uint32_t, std::uint32_t>;  // an instance's id and mesh
    struct Placed {
        Key key;
        Aabb bounds;
        mat4 transform{1};
    };
    // What deforms, and where it was when it moved last.
    struct Figure {
        std::uint64_t topology = 0;  // RefinedTopology::serial, or 0
        std::uint64_t mesh = 0;      // version
        std::size_t vertices = 0;
        Limbs limbs;
        std::vector<Aabb> boxes;  // render space, one a limb
        Limbs parts;              // smaller ones, that hardly bend
        std::shared_ptr<const std::vector<VertexFrame>> before;
        mat4 transform{1};
    };
    struct Swept {
        std::vector<Aabb> limbs;
        std::vector<LimbMotion> parts;
    };
    // What the limbs of something that has moved sweep, and how its parts have moved; none if it has none, or
    // if it is not known where they were.
    Swept sweep_limbs(const FrameScene& scene, const Instance& instance);

    std::vector<Placed> placed_;  // of the frame before, in FrameScene's order
    std::map<Key, Figure> figures_;
    dvec3 origin_{0};
    std::vector<Mover> movers_;
    std::vector<Aabb> boxes_, whole_;
    std::vector<Aabb> parts_;  // all of them: of limbs, or of movers without
    SweptGrid grid_;
    bool has_limbs_ = false;
};

}  // namespace lanthorn::gi

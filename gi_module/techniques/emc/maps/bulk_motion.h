// How the things move that environment maps were chosen for. No GL.
#pragma once

#include <cstdint>
#include <unordered_map>

#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

// Follows the instances that lie in a box, by the area of their boxes. Where more than half of that
// area moves by about the same vector (a room that drives, a ship), the box and what was chosen in it move
// along. Once a tenth of the area is outside the box, the box is given up.
class BulkMotion {
  public:
    // From now on, of `scene`: what lies within `box` (render space) and a tenth of its diagonal about it.
    // What is larger (a sky dome, a plain) is not watched. O(instances).
    void watch(const FrameScene& scene, const Aabb& box);

    struct Step {
        vec3 by{0};          // how far box and bulk have come since the last frame, m
        bool apart = false;  // a tenth of what was in the box is outside it: given up
    };
    // Of each frame whose geometry has changed. Turning about its own middle moves no thing. `by` has what
    // the origin of render space has moved as well. O(things that have moved; instances, where the bulk
    // moves).
    Step follow(const FrameScene& scene);

  private:
    struct Thing {
        vec3 middle{0};  // of its box when it was seen first, in its own space
        dvec3 at{0};     // where that is, world space
        float area = 0;  // m^2, of its box
        bool outside = false;
    };
    bool holds(const Aabb& box) const;

    std::unordered_map<std::uint64_t, Thing> things_;  // by id and mesh
    Aabb box_;                                         // render space
    dvec3 origin_{0};
    double area_ = 0;     // of all things
    double outside_ = 0;  // of those that are outside
};

}  // namespace lanthorn::gi

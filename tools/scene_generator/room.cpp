#include "tools/scene_generator/room.h"

namespace lanthorn::scene_generator {

void closed_room(Builder& b, const dvec3& low, const dvec3& high, const RoomSlabs& slabs, double thickness,
                 const std::string& extras) {
    const dvec3 out_low = low - thickness, out_high = high + thickness;
    const auto slab = [&](const RoomSlab& which, const dvec3& from, const dvec3& to) {
        b.solid(which.name, box(from, to), which.material, extras);
    };
    slab(slabs.floor, out_low, {out_high.x, low.y, out_high.z});
    slab(slabs.ceiling, {out_low.x, high.y, out_low.z}, out_high);
    slab(slabs.left, {out_low.x, low.y, low.z}, {low.x, high.y, high.z});
    slab(slabs.right, {high.x, low.y, low.z}, {out_high.x, high.y, high.z});
    slab(slabs.back, {out_low.x, low.y, out_low.z}, {out_high.x, high.y, low.z});
    slab(slabs.front, {out_low.x, low.y, high.z}, {out_high.x, high.y, out_high.z});
}

void wall_with_doorway(Builder& b, const std::string& name, double depth, double height, const Doorway& door,
                       std::uint32_t material, const std::string& extras) {
    constexpr double kHalf = 0.5 * kWallThickness;
    const double end = 0.5 * depth, jamb = 0.5 * door.width;
    b.solid(name + "-left", box({-kHalf, 0, -end}, {kHalf, height, -jamb}), material, extras);
    b.solid(name + "-right", box({-kHalf, 0, jamb}, {kHalf, height, end}), material, extras);
    b.solid(name + "-lintel",
            box({-kHalf + 0.005, door.height, -jamb - 0.01}, {kHalf - 0.005, height, jamb + 0.01}), material,
            extras);
}

}  // namespace lanthorn::scene_generator

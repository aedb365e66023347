#include "tools/scene_generator/room.h"

namespace lanthorn::scene_generator {

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

#include "tools/scene_generator/room.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

// A box of coloured walls under a small flat lamp, and a ball of glass that stands so high that what it
// gathers meets the floor near its focus: half the ball's radius behind it for an index of 1.5.
SceneData glass_ball() {
    Builder b;
    constexpr double kHalf = 0.8, kHeight = 1.6, kRadius = 0.3;
    const std::uint32_t white = b.matte("white", vec3(0.74f), 0);
    const std::uint32_t red = b.matte("red", {0.6f, 0.06f, 0.05f}, 0);
    const std::uint32_t green = b.matte("green", {0.12f, 0.45f, 0.1f}, 0);
    closed_room(b, {-kHalf, 0, -kHalf}, {kHalf, kHeight, kHalf},
                {.floor = {"floor", white},
                 .ceiling = {"ceiling", white},
                 .left = {"red-wall", red},
                 .right = {"green-wall", green},
                 .back = {"back-wall", white},
                 .front = {"front-wall", white}});

    b.solid("ball", icosphere(kRadius, 5), b.glass("glass", 1.5f, static_cast<float>(2 * kRadius)), {},
            at({0.1, 0.42, -0.05}));
    b.panel("lamp", {-0.2, kHeight - 0.005, 0}, {-0.2, 0, 0}, 0.25, 0.25, vec3(1, 0.93f, 0.82f) * 6000.0f);
    b.camera("camera", looking({0, 0.95, 0.78}, {0.02, 0.43, -0.2}), glm::radians(64.0f), 0.02f);
    return b.scene;
}

}  // namespace lanthorn::scene_generator

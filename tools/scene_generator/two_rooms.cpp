#include <string>

#include "tools/scene_generator/room.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

namespace {

// Lit by so many lamps that give as much light together as one.
SceneData rooms_lit_by(int lamps) {
    Builder b;
    const std::uint32_t white = b.matte("white", {0.75f, 0.74f, 0.71f});
    const std::uint32_t wood = b.matte("wood", {0.42f, 0.27f, 0.15f});
    const std::uint32_t floor = b.matte("floorboards", {0.5f, 0.4f, 0.3f});
    const std::uint32_t terracotta = b.matte("terracotta", {0.6f, 0.2f, 0.12f});
    const std::uint32_t blue = b.matte("blue", {0.15f, 0.25f, 0.55f});
    const std::uint32_t green = b.matte("green", {0.2f, 0.45f, 0.2f});

    constexpr double kHeight = 2.6, kDepth = 4.0;
    constexpr double kThick = kWallThickness, kInner = 0.5 * kThick, kEnd = kInner + 4.0,
                     kSide = 0.5 * kDepth;
    constexpr double kOuter = kEnd + kThick, kOuterSide = kSide + kThick;
    b.solid("floor", box({-kOuter, -kThick, -kOuterSide}, {kOuter, 0, kOuterSide}), floor);
    b.solid("ceiling", box({-kOuter, kHeight, -kOuterSide}, {kOuter, kHeight + kThick, kOuterSide}), white);
    b.solid("lit-end", box({-kOuter, 0, -kSide}, {-kEnd, kHeight, kSide}), terracotta);
    b.solid("lit-back", box({-kOuter, 0, -kOuterSide}, {0, kHeight, -kSide}), white);
    b.solid("lit-front", box({-kOuter, 0, kSide}, {0, kHeight, kOuterSide}), green);
    b.solid("dark-end", box({kEnd, 0, -kSide}, {kOuter, kHeight, kSide}), blue);
    b.solid("dark-back", box({0, 0, -kOuterSide}, {kOuter, kHeight, -kSide}), white);
    b.solid("dark-front", box({0, 0, kSide}, {kOuter, kHeight, kOuterSide}), white);
    wall_with_doorway(b, "divider", kDepth, kHeight, {0.9, 2.0}, white);

    b.table("lit-table", {-2.4, 0, -1.1}, 1.4, 0.8, 0.74, wood);
    b.solid("vase", cylinder(0.09, 0.28, 24), blue, {}, at({-2.7, 0.74, -1.1}));
    b.solid("ball", icosphere(0.14, 2), white, {}, at({-2.1, 0.88, -1.0}));
    b.solid("cupboard", box({-4.0, 0, 1.2}, {-3.4, 1.9, 1.95}), wood);
    b.solid("stool", box({-1.5, 0, 0.9}, {-1.1, 0.45, 1.3}), terracotta);
    b.solid("column", cylinder(0.15, kHeight, 24), white, {}, at({-0.6, 0, 1.5}));
    b.solid("bed", box({2.2, 0, -1.9}, {4.0, 0.5, -0.6}), green);
    b.solid("pillow", box({3.5, 0.5, -1.7}, {3.9, 0.62, -0.8}), white);
    b.solid("chest", box({0.6, 0, 1.3}, {1.6, 0.55, 1.85}), wood);
    b.solid("globe", icosphere(0.25, 2), terracotta, {}, at({1.1, 0.8, 1.55}));
    b.table("dark-table", {3.2, 0, 1.2}, 1.0, 0.8, 0.74, wood);

    Light lamp;
    lamp.type = LightType::point;
    lamp.colour = {1, 0.9f, 0.75f};
    lamp.intensity = 400.0f / static_cast<float>(lamps);
    constexpr dvec3 kLamp(-2.2, 2.35, 0.3);
    b.light("lamp", at(kLamp), lamp);
    for (int i = 1; i < lamps; ++i) {  // beside it, in rows of four, each a little lower than the last
        const dvec3 away(0.12 * (i % 4 - 1.5), -0.00125 * i, 0.12 * (i / 4 - 1.5));
        b.light("lamp-" + std::to_string(i), at(kLamp + away), lamp);
    }

    b.camera("lit", looking({-3.8, 1.6, 1.0}, {0, 1.0, -0.2}), glm::radians(60.0f));
    b.camera("dark", looking({3.8, 1.6, 1.7}, {0.4, 0.9, -0.4}), glm::radians(60.0f));
    return b.scene;
}

}  // namespace

SceneData two_rooms() {
    return rooms_lit_by(1);
}
SceneData two_rooms_lamps_4() {
    return rooms_lit_by(4);
}
SceneData two_rooms_lamps_16() {
    return rooms_lit_by(16);
}

}  // namespace lanthorn::scene_generator

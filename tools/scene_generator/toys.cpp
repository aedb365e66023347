// After Yao et al. 2010, Fig. 11 (c), whose text names 101 k triangles, two bounces and the edges at which
// its up-sampling is seen; what lies in it is ours: many small diffuse things with edges, close together.
#include <array>

#include "tools/scene_generator/lathe.h"
#include "tools/scene_generator/room.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

namespace {

// A spinning top, 0.2 m tall, that stands on its point.
Shape top() {
    Outline outline = {{{0, 0}, {0, -1}}, {{0.002, 0}, {0, -1}}};
    add_curve(outline,
              {{0.002, 0},
               {0.02, 0.03},
               {0.09, 0.08},
               {0.095, 0.1},
               {0.05, 0.125},
               {0.012, 0.14},
               {0.01, 0.18},
               {0.014, 0.195},
               {0.004, 0.2}},
              10);
    outline.push_back({{0.004, 0.2}, {0, 1}});
    outline.push_back({{0, 0.2}, {0, 1}});
    return lathe(outline, 62);
}

}  // namespace

SceneData toys() {
    Builder b;
    constexpr double kX = 1.3, kBack = -1.0, kFront = 1.8, kHeight = 1.9;
    const std::uint32_t cream = b.matte("cream", {0.76f, 0.72f, 0.64f}, 0);
    const std::uint32_t sky = b.matte("sky", {0.3f, 0.5f, 0.68f}, 0);
    const std::uint32_t boards = b.matte("boards", {0.52f, 0.36f, 0.22f}, 0);
    closed_room(b, {-kX, 0, kBack}, {kX, kHeight, kFront},
                {.floor = {"floor", boards},
                 .ceiling = {"ceiling", cream},
                 .left = {"left-wall", sky},
                 .right = {"right-wall", cream},
                 .back = {"back-wall", cream},
                 .front = {"front-wall", cream}});

    const std::array<std::uint32_t, 5> paint = {
        b.matte("red", {0.66f, 0.09f, 0.07f}, 0), b.matte("yellow", {0.75f, 0.55f, 0.08f}, 0),
        b.matte("green", {0.12f, 0.45f, 0.16f}, 0), b.matte("blue", {0.1f, 0.2f, 0.6f}, 0),
        b.matte("wood", {0.6f, 0.45f, 0.28f}, 0)};
    // A wall of blocks, each a little out of its row, over two that leave a gate between them.
    const auto block = [&](const std::string& name, const dvec3& centre, const dvec3& half, std::size_t n) {
        b.solid(name, rounded_box(half, 0.012, 4), paint[n % paint.size()], {}, at(centre));
    };
    block("gate-left", {-0.62, 0.15, -0.42}, {0.1, 0.15, 0.1}, 0);
    block("gate-right", {-0.1, 0.15, -0.42}, {0.1, 0.15, 0.1}, 3);
    block("lintel", {-0.36, 0.36, -0.42}, {0.36, 0.06, 0.1}, 4);
    block("upper-left", {-0.54, 0.51, -0.41}, {0.09, 0.09, 0.09}, 1);
    block("upper-right", {-0.2, 0.51, -0.43}, {0.09, 0.09, 0.09}, 2);
    block("bridge", {-0.37, 0.64, -0.42}, {0.28, 0.04, 0.08}, 0);
    block("cap", {-0.36, 0.76, -0.42}, {0.08, 0.08, 0.08}, 3);
    block("tower-0", {0.62, 0.12, -0.5}, {0.12, 0.12, 0.12}, 2);
    block("tower-1", {0.63, 0.34, -0.49}, {0.1, 0.1, 0.1}, 1);
    block("tower-2", {0.61, 0.52, -0.5}, {0.08, 0.08, 0.08}, 0);
    block("plank", {0.36, 0.03, 0.12}, {0.3, 0.03, 0.06}, 4);
    block("loose-0", {-0.72, 0.07, 0.2}, {0.07, 0.07, 0.07}, 1);
    block("loose-1", {0.84, 0.06, 0.32}, {0.06, 0.06, 0.06}, 3);
    b.solid("large-ball", icosphere(0.2, 4), paint[0], {}, at({0.25, 0.2, -0.15}));
    b.solid("small-ball", icosphere(0.11, 4), paint[1], {}, at({-0.36, 0.11, -0.1}));
    b.solid("top", top(), paint[2], {}, at({-0.2, 0, 0.4}));
    b.solid("ring-0", ring_band(0.05, 0.13, 0.06, 0.02, 96), paint[3], {}, at({0.2, 0, 0.5}));
    b.solid("ring-1", ring_band(0.05, 0.11, 0.05, 0.018, 96), paint[1], {}, at({0.205, 0.06, 0.5}));
    b.solid("ring-2", ring_band(0.05, 0.09, 0.04, 0.014, 96), paint[0], {}, at({0.197, 0.11, 0.5}));

    b.panel("lamp", {0.75, kHeight - 0.01, 0.75}, {0.75, 0, 0.75}, 0.3, 0.3, vec3(1, 0.92f, 0.8f) * 4200.0f);
    b.camera("camera", looking({0.1, 0.85, 1.6}, {-0.02, 0.2, -0.3}), glm::radians(54.0f), 0.02f);
    return b.scene;
}

}  // namespace lanthorn::scene_generator

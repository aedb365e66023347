// After Yao et al. 2010, Fig. 11 (a), whose text names 58 k triangles, one bounce, colour bleeding and the
// shapes of indirect shadows; what stands in it is ours.
#include <cmath>
#include <numbers>

#include "tools/scene_generator/lathe.h"
#include "tools/scene_generator/rigged_shape.h"
#include "tools/scene_generator/room.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

namespace {

// A vase on a foot, hollow, 1.15 m tall.
Shape amphora() {
    Outline outline = {{{0, 0}, {0, -1}}, {{0.17, 0}, {0, -1}}};
    add_curve(outline,
              {{0.17, 0},
               {0.18, 0.03},
               {0.1, 0.1},
               {0.09, 0.17},
               {0.26, 0.42},
               {0.32, 0.66},
               {0.22, 0.88},
               {0.11, 0.97},
               {0.12, 1.08},
               {0.17, 1.13},
               {0.14, 1.15},
               {0.09, 1.07},
               {0.08, 0.97},
               {0.18, 0.87},
               {0.27, 0.66},
               {0.22, 0.42},
               {0.06, 0.22}},
              8);
    outline.push_back({{0.06, 0.22}, {0, 1}});
    outline.push_back({{0, 0.22}, {0, 1}});
    return lathe(outline, 84);
}

// A column of five lobes that turns once about itself, 1.5 m tall.
RiggedShape twisted() {
    constexpr int kRings = 160, kSides = 80;
    constexpr double kTall = 1.5;
    RiggedShape shape;
    shape.positions.emplace_back(0);
    for (int i = 0; i <= kRings; ++i) {
        const double u = static_cast<double>(i) / kRings;
        const double middle = 0.2 - 0.07 * u + 0.03 * std::cos(2 * std::numbers::pi * 2 * u);
        for (int k = 0; k < kSides; ++k) {
            const double angle = 2 * std::numbers::pi * k / kSides;
            const double r = middle * (1 + 0.22 * std::cos(5 * angle + 2 * std::numbers::pi * u));
            shape.positions.emplace_back(r * std::cos(angle), kTall * u, r * std::sin(angle));
        }
    }
    shape.positions.emplace_back(0, kTall, 0);
    const auto point = [](int ring, int side) {
        return static_cast<std::uint32_t>(1 + ring * kSides + side % kSides);
    };
    const auto top = static_cast<std::uint32_t>(shape.positions.size() - 1);
    for (int k = 0; k < kSides; ++k) {
        shape.indices.insert(shape.indices.end(), {0, point(0, k), point(0, k + 1)});
        for (int i = 0; i < kRings; ++i) {
            shape.indices.insert(shape.indices.end(), {point(i, k), point(i + 1, k), point(i + 1, k + 1),
                                                       point(i, k), point(i + 1, k + 1), point(i, k + 1)});
        }
        shape.indices.insert(shape.indices.end(), {point(kRings, k), top, point(kRings, k + 1)});
    }
    return shape;
}

}  // namespace

SceneData statues() {
    Builder b;
    constexpr double kX = 2.2, kBack = -1.5, kFront = 3.2, kHeight = 2.8;
    const std::uint32_t white = b.matte("white", {0.77f, 0.75f, 0.71f}, 0);
    const std::uint32_t red = b.matte("red", {0.72f, 0.12f, 0.07f}, 0);
    const std::uint32_t green = b.matte("green", {0.14f, 0.42f, 0.16f}, 0);
    closed_room(b, {-kX, 0, kBack}, {kX, kHeight, kFront},
                {.floor = {"floor", white},
                 .ceiling = {"ceiling", white},
                 .left = {"red-wall", red},
                 .right = {"green-wall", green},
                 .back = {"back-wall", white},
                 .front = {"front-wall", white}});

    const std::uint32_t stone = b.matte("stone", {0.7f, 0.68f, 0.64f}, 0);
    const std::uint32_t clay = b.matte("clay", {0.62f, 0.4f, 0.27f}, 0);
    b.solid("plinth", box({-0.28, 0, -0.98}, {0.28, 0.5, -0.42}), white);
    b.solid("amphora", amphora(), clay, {}, at({0, 0.5, -0.7}));
    const std::uint32_t column = b.node("column", at({-1.15, 0, -0.5}));
    b.scene.meshes.push_back(edged_mesh("column", twisted(), stone));
    b.scene.nodes[column].meshes = {static_cast<std::uint32_t>(b.scene.meshes.size() - 1)};
    b.solid("ball", icosphere(0.42, 4), stone, {}, at({1.2, 0.42, -0.35}));
    b.solid("block", rounded_box({0.26, 0.2, 0.26}, 0.05, 4), stone, {}, at({0.5, 0.2, 0.35}));

    // Lamps that shine on the side walls alone: what stands in the middle has its light from them.
    Light lamp;
    lamp.type = LightType::spot;
    lamp.colour = {1, 0.93f, 0.82f};
    lamp.intensity = 900;
    lamp.inner_cone = glm::radians(14.0f);
    lamp.outer_cone = glm::radians(22.0f);
    b.light("red-lamp", looking({-0.5, 2.6, 1.6}, {-kX, 1.25, 0.3}), lamp);
    b.light("green-lamp", looking({0.5, 2.6, 1.6}, {kX, 1.1, 0.4}), lamp);
    b.camera("camera", looking({0, 1.5, 3.0}, {0, 0.95, -0.6}), glm::radians(58.0f));
    return b.scene;
}

}  // namespace lanthorn::scene_generator

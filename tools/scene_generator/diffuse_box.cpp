#include <cmath>
#include <numbers>

#include "tools/scene_generator/lathe.h"
#include "tools/scene_generator/rigged_shape.h"
#include "tools/scene_generator/room.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

namespace {

// A tube along a torus knot (2, 3) that fits into a ball of about `size` metres radius.
Mesh knot(double size, double thick, std::uint32_t material) {
    constexpr int kSteps = 240, kSides = 15;
    const auto place = [&](double t) {
        const double r = 2 + std::cos(3 * t);
        return size / 3 * dvec3(r * std::cos(2 * t), r * std::sin(2 * t), -1.2 * std::sin(3 * t));
    };
    RiggedShape shape;
    for (int i = 0; i < kSteps; ++i) {
        const double t = 2 * std::numbers::pi * i / kSteps;
        const dvec3 p = place(t), ahead = glm::normalize(place(t + 1e-3) - place(t - 1e-3));
        // Square to the way: from the axis of the torus outwards, so that the last ring meets the first.
        const dvec3 out = glm::normalize(p - dvec3(0, 0, p.z) + dvec3(0, 0, 1e-3));
        const dvec3 across = glm::normalize(glm::cross(ahead, out)), side = glm::cross(across, ahead);
        for (int k = 0; k < kSides; ++k) {
            const double angle = 2 * std::numbers::pi * k / kSides;
            shape.positions.push_back(p + thick * (std::cos(angle) * side + std::sin(angle) * across));
        }
    }
    for (std::uint32_t i = 0; i < kSteps; ++i) {
        for (std::uint32_t k = 0; k < kSides; ++k) {
            const std::uint32_t next = (i + 1) % kSteps, beside = (k + 1) % kSides;
            const std::uint32_t a = i * kSides + k, b = i * kSides + beside;
            const std::uint32_t c = next * kSides + k, d = next * kSides + beside;
            shape.indices.insert(shape.indices.end(), {a, b, d, a, d, c});
        }
    }
    return smooth_mesh("knot", shape, material);
}

// A bellied urn with a rim, hollow.
Shape urn() {
    Outline outline = {{{0, 0}, {0, -1}}, {{0.26, 0}, {0, -1}}};
    add_curve(outline,
              {{0.26, 0},
               {0.27, 0.04},
               {0.17, 0.13},
               {0.2, 0.24},
               {0.4, 0.5},
               {0.44, 0.75},
               {0.33, 1.0},
               {0.21, 1.12},
               {0.23, 1.22},
               {0.29, 1.3},
               {0.25, 1.335},
               {0.19, 1.24},
               {0.165, 1.12},
               {0.28, 0.98},
               {0.38, 0.74},
               {0.34, 0.5},
               {0.15, 0.27}},
              6);
    outline.push_back({{0.15, 0.27}, {0, 1}});
    outline.push_back({{0, 0.27}, {0, 1}});
    return lathe(outline, 36);
}

}  // namespace

// After Yao et al. 2010, Fig. 1 (a): nothing but diffuse surfaces in a box of coloured walls, 15 k triangles.
SceneData diffuse_box() {
    Builder b;
    constexpr double kHalf = 1.8, kHeight = 3.2, kWall = kHalf + kWallThickness, kFront = 3.4;
    const std::uint32_t white = b.matte("white", {0.76f, 0.75f, 0.72f}, 0);
    const std::uint32_t orange = b.matte("orange", {0.78f, 0.3f, 0.06f}, 0);
    const std::uint32_t teal = b.matte("teal", {0.06f, 0.4f, 0.45f}, 0);
    b.solid("floor", box({-kWall, -kWallThickness, -kWall}, {kWall, 0, kFront}), white);
    b.solid("ceiling", box({-kWall, kHeight, -kWall}, {kWall, kHeight + kWallThickness, kFront}), white);
    b.solid("orange-wall", box({-kWall, 0, -kHalf}, {-kHalf, kHeight, kFront}), orange);
    b.solid("teal-wall", box({kHalf, 0, -kHalf}, {kWall, kHeight, kFront}), teal);
    b.solid("back-wall", box({-kWall, 0, -kWall}, {kWall, kHeight, -kHalf}), white);
    b.solid("front-wall", box({-kHalf, 0, kFront - kWallThickness}, {kHalf, kHeight, kFront}), white);

    b.solid("urn", urn(), b.matte("clay", {0.66f, 0.42f, 0.3f}, 0), {}, at({-0.85, 0, -0.65}));
    b.solid("plinth", box({0.45, 0, -0.9}, {1.25, 0.7, -0.1}), white);
    const std::uint32_t shown = b.node("knot", at({0.85, 1.27, -0.5}));
    b.scene.meshes.push_back(knot(0.5, 0.085, b.matte("plaster", {0.8f, 0.79f, 0.76f}, 0)));
    b.scene.nodes[shown].meshes = {static_cast<std::uint32_t>(b.scene.meshes.size() - 1)};
    b.solid("ball", icosphere(0.32, 3), b.matte("blue", {0.15f, 0.25f, 0.6f}, 0), {}, at({0.1, 0.32, 0.55}));

    b.panel("lamp", {0, kHeight - 0.01, 0.2}, {0, 0, 0.2}, 0.9, 0.9, vec3(1, 0.93f, 0.82f) * 1100.0f);
    b.camera("camera", looking({0, 1.6, 3.1}, {0, 1.25, -0.6}), glm::radians(60.0f));
    return b.scene;
}

}  // namespace lanthorn::scene_generator

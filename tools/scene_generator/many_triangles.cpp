// Scenes of any number of triangles, for what opening and showing them costs: one mesh, or one that is shown
// often.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "tools/scene_generator/builder.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

namespace many_triangles_parts {

constexpr double kHalf = 10;  // m, of the ground

// Hills of 4 m from crest to crest, and ripples on them.
double height(double x, double z) {
    return 0.35 * std::sin(1.6 * x) * std::cos(1.3 * z) + 0.06 * std::sin(7 * x + 2 * z);
}

Shape waves(int side) {
    Shape shape;
    shape.corners.reserve(static_cast<std::size_t>(side + 1) * static_cast<std::size_t>(side + 1));
    for (int j = 0; j <= side; ++j) {
        for (int i = 0; i <= side; ++i) {
            const double x = kHalf * (2.0 * i / side - 1), z = kHalf * (2.0 * j / side - 1);
            constexpr double kStep = 1e-3;
            const dvec3 slope((height(x - kStep, z) - height(x + kStep, z)) / (2 * kStep), 1,
                              (height(x, z - kStep) - height(x, z + kStep)) / (2 * kStep));
            shape.corners.push_back({{x, height(x, z), z}, glm::normalize(slope), {x, z}});
        }
    }
    shape.indices.reserve(6 * static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const auto corner = [&](int a, int b) { return static_cast<std::uint32_t>(b * (side + 1) + a); };
            for (const std::uint32_t k : {corner(i, j), corner(i, j + 1), corner(i + 1, j + 1), corner(i, j),
                                          corner(i + 1, j + 1), corner(i + 1, j)}) {
                shape.indices.push_back(k);
            }
        }
    }
    return shape;
}

void add_lamp_and_camera(Builder& b) {
    Light lamp;
    lamp.intensity = 400;
    b.light("lamp", at({1.5, 2.5, 0.5}), lamp);
    b.camera("camera", looking({0, 2.2, 9}, {0, 0, 0}), 0.8f, 0.02f);
}

}  // namespace many_triangles_parts

SceneData wavy_ground(int triangles) {
    using namespace many_triangles_parts;
    Builder b;
    const std::uint32_t clay = b.matte("clay", {0.65f, 0.5f, 0.4f}, 0);
    const int side = std::max(1, static_cast<int>(std::lround(std::sqrt(triangles / 2.0))));
    b.solid("ground", waves(side), clay);
    add_lamp_and_camera(b);
    return b.scene;
}

SceneData many_stones(int count) {
    using namespace many_triangles_parts;
    Builder b;
    const std::uint32_t clay = b.matte("clay", {0.65f, 0.5f, 0.4f}, 0);
    const std::uint32_t grey = b.matte("stone", vec3(0.5f), 0);
    b.solid("ground", waves(16), clay);
    constexpr int kRings = 40;
    Shape stone;
    for (int j = 0; j <= kRings; ++j) {
        for (int i = 0; i <= kRings; ++i) {
            const double u = 2 * std::numbers::pi * (i % kRings) / kRings, v = std::numbers::pi * j / kRings;
            const dvec3 n(std::sin(v) * std::cos(u), std::cos(v), std::sin(v) * std::sin(u));
            const double bump = 1 + 0.1 * std::sin(5 * n.x) * std::sin(4 * n.y) * std::sin(6 * n.z);
            stone.corners.push_back({0.2 * bump * n, n, {u, v}});
        }
    }
    for (int j = 0; j < kRings; ++j) {
        for (int i = 0; i < kRings; ++i) {
            const auto corner = [](int a, int c) { return static_cast<std::uint32_t>(c * (kRings + 1) + a); };
            for (const std::uint32_t k : {corner(i, j), corner(i + 1, j + 1), corner(i, j + 1), corner(i, j),
                                          corner(i + 1, j), corner(i + 1, j + 1)}) {
                stone.indices.push_back(k);
            }
        }
    }
    const std::uint32_t mesh = b.mesh("stone", stone, grey);
    const int side = std::max(1, static_cast<int>(std::ceil(std::sqrt(count))));
    for (int k = 0; k < count; ++k) {
        const double x = kHalf * (2 * (k % side + 0.5) / side - 1);
        const double z = kHalf * (2 * (k / side + 0.5) / side - 1);
        const std::uint32_t node = b.node("stone-" + std::to_string(k), at({x, height(x, z) + 0.1, z}));
        b.scene.nodes[node].meshes = {mesh};
    }
    add_lamp_and_camera(b);
    return b.scene;
}

}  // namespace lanthorn::scene_generator

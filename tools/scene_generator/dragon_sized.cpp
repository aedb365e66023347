// As many triangles as the Stanford Dragon has that Frisvad et al. 2005, sec. 6 render: 871 414 there, 871
// 098 here, a knot with scales in a box with one wall open.
#include <cmath>
#include <numbers>

#include "tools/scene_generator/builder.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

namespace dragon_sized_parts {

constexpr int kAlong = 2'007, kAround = 217;  // quadrilaterals
constexpr int kScalesAlong = 120, kScalesAround = 12;

// A trefoil, metres; about 0.6 across.
dvec3 trefoil(double t) {
    return 0.1 *
           dvec3(std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t), -std::sin(3 * t));
}

dvec3 on_skin(double u, double v) {
    const double t = 2 * std::numbers::pi * u, turn = 2 * std::numbers::pi * v;
    constexpr double kStep = 1e-4;
    const dvec3 way = glm::normalize(trefoil(t + kStep) - trefoil(t - kStep));
    const dvec3 side = glm::normalize(glm::cross(way, dvec3(0, 0, 1)));
    const dvec3 up = glm::cross(side, way);
    const double scale = std::abs(std::sin(std::numbers::pi * kScalesAlong * u) *
                                  std::sin(std::numbers::pi * kScalesAround * v));
    return trefoil(t) + (0.055 + 0.004 * scale) * (std::cos(turn) * side + std::sin(turn) * up);
}

Shape knot() {
    Shape shape;
    for (int i = 0; i <= kAlong; ++i) {
        for (int j = 0; j <= kAround; ++j) {
            const double u = static_cast<double>(i % kAlong) / kAlong,
                         v = static_cast<double>(j % kAround) / kAround;
            constexpr double kStep = 2e-4;
            const dvec3 along = on_skin(u + kStep, v) - on_skin(u - kStep, v);
            const dvec3 around = on_skin(u, v + kStep) - on_skin(u, v - kStep);
            shape.corners.push_back({on_skin(u, v), glm::normalize(glm::cross(along, around)), {u, v}});
        }
    }
    for (int i = 0; i < kAlong; ++i) {
        for (int j = 0; j < kAround; ++j) {
            const auto corner = [](int a, int b) {
                return static_cast<std::uint32_t>(a * (kAround + 1) + b);
            };
            for (const std::uint32_t k : {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j),
                                          corner(i + 1, j + 1), corner(i, j + 1)}) {
                shape.indices.push_back(k);
            }
        }
    }
    return shape;
}

}  // namespace dragon_sized_parts

SceneData dragon_sized() {
    using namespace dragon_sized_parts;
    Builder b;
    const std::uint32_t white = b.matte("white", vec3(0.7f), 0);
    const std::uint32_t red = b.matte("red", {0.6f, 0.08f, 0.06f}, 0);
    const std::uint32_t green = b.matte("green", {0.1f, 0.45f, 0.12f}, 0);
    const std::uint32_t jade = b.matte("jade", {0.35f, 0.6f, 0.45f}, 0);
    constexpr double kHalf = 0.6, kThick = 0.02;
    b.solid("floor", box({-kHalf, -kHalf - kThick, -kHalf}, {kHalf, -kHalf, kHalf}), white);
    b.solid("ceiling", box({-kHalf, kHalf, -kHalf}, {kHalf, kHalf + kThick, kHalf}), white);
    b.solid("back-wall", box({-kHalf, -kHalf, -kHalf - kThick}, {kHalf, kHalf, -kHalf}), white);
    b.solid("red-wall", box({-kHalf - kThick, -kHalf, -kHalf}, {-kHalf, kHalf, kHalf}), red);
    b.solid("green-wall", box({kHalf, -kHalf, -kHalf}, {kHalf + kThick, kHalf, kHalf}), green);
    b.solid("knot", knot(), jade, {}, at({0, -0.15, -0.1}));
    Light lamp;
    lamp.intensity = 40;
    b.light("lamp", at({0, 0.5, 0.1}), lamp);
    b.camera("camera", looking({0, 0, 2.1}, {0, 0, 0}), 0.65f, 0.02f);
    return b.scene;
}

}  // namespace lanthorn::scene_generator

#include <cmath>
#include <numbers>

#include "lanthorn/core/turns.h"
#include "tools/scene_generator/rigged_shape.h"
#include "tools/scene_generator/room.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

namespace nave_parts {

constexpr double kPi = std::numbers::pi;
constexpr int kBays = 8;                                    // between nine pairs of columns
constexpr double kBay = 4, kHalfNave = 4, kHalfHall = 7.5;  // metres; the aisles are beyond the columns
constexpr double kColumn = 5.2, kHeight = 11;               // heights of the columns and of the hall
constexpr double kEnd = 0.5 * kBays * kBay + 2;             // half the hall's length

// A shaft that swells slightly, on a round base and under a round capital, its edges rounded where they stand
// in floor and arches.
Mesh column(std::uint32_t material) {
    constexpr int kSteps = 23, kEdge = 6, kSides = 42;
    constexpr double kRound = 0.12;
    const auto radius = [](double y) {
        const auto swell = [&](double at, double size) {
            return std::exp(-(y - at) * (y - at) / (size * size));
        };
        return 0.36 + 0.03 * std::sin(kPi * y / kColumn) + 0.16 * swell(0, 0.45) +
               0.22 * swell(kColumn, 0.55);
    };
    std::vector<Ring> rings;
    const auto add = [&](double y, double r) { rings.push_back({{0, y, 0}, r, r}); };
    const auto edge = [&](double end, double outwards, int i) {
        const double angle = 0.5 * kPi * i / kEdge;
        add(end + outwards * kRound * std::cos(angle), radius(end) - kRound * (1 - std::sin(angle)));
    };
    add(-kRound - 0.02, 0);
    for (int i = 0; i < kEdge; ++i) {
        edge(0, -1, i);
    }
    for (int i = 0; i <= kSteps; ++i) {
        const double y = kColumn * i / kSteps;
        add(y, radius(y));
    }
    for (int i = kEdge - 1; i >= 0; --i) {
        edge(kColumn, 1, i);
    }
    add(kColumn + kRound + 0.02, 0);
    RiggedShape shape;
    shape.add_tube(rings, kSides, nullptr);
    return smooth_mesh("column", shape, material);
}

// A half circle of `radius` metres in the plane z = 0, from +X over +Y to -X: a round bar.
Mesh arch(const std::string& name, double radius, double thick, int steps, int sides,
          std::uint32_t material) {
    RiggedShape shape;
    shape.add_tube(capsule({0, -thick, 0}, {0, kPi * radius + thick, 0}, thick, thick, 1, steps), sides,
                   nullptr);
    for (dvec3& p : shape.positions) {
        const double angle = p.y / radius;
        const double out = radius + p.x;
        p = {out * std::cos(angle), out * std::sin(angle), p.z};
    }
    return smooth_mesh(name, shape, material);
}

std::uint32_t add(Builder& b, Mesh mesh) {
    b.scene.meshes.push_back(std::move(mesh));
    return static_cast<std::uint32_t>(b.scene.meshes.size() - 1);
}

void place(Builder& b, const std::string& name, std::uint32_t mesh, const Transform& where) {
    b.scene.nodes[b.node(name, where)].meshes = {mesh};
}

void shell(Builder& b) {
    const double outer = kHalfHall + kWallThickness, end = kEnd + kWallThickness;
    const std::uint32_t floor = b.matte("floor", {0.5f, 0.47f, 0.42f});
    const std::uint32_t plaster = b.matte("plaster", {0.72f, 0.7f, 0.64f});
    const std::uint32_t red = b.matte("red", {0.62f, 0.12f, 0.08f});
    const std::uint32_t blue = b.matte("blue", {0.14f, 0.22f, 0.55f});
    b.solid("floor", box({-end, -kWallThickness, -outer}, {end, 0, outer}), floor, kBoxCollider);
    b.solid("ceiling", box({-end, kHeight, -outer}, {end, kHeight + kWallThickness, outer}), plaster,
            kBoxCollider);
    b.solid("left-wall", box({-end, 0, -outer}, {end, kHeight, -kHalfHall}), plaster, kBoxCollider);
    b.solid("right-wall", box({-end, 0, kHalfHall}, {end, kHeight, outer}), plaster, kBoxCollider);
    b.solid("red-end", box({-end, 0, -kHalfHall}, {-kEnd, kHeight, kHalfHall}), red, kBoxCollider);
    b.solid("blue-end", box({kEnd, 0, -kHalfHall}, {end, kHeight, kHalfHall}), blue, kBoxCollider);
}

void columns_and_arches(Builder& b) {
    const std::uint32_t stone = b.matte("stone", {0.66f, 0.62f, 0.54f});
    const std::uint32_t column_mesh = add(b, column(stone));
    const std::uint32_t arcade = add(b, arch("arch", 0.5 * kBay, 0.22, 26, 12, stone));
    const std::uint32_t rib = add(b, arch("rib", kHalfNave, 0.2, 44, 12, stone));
    for (int i = 0; i <= kBays; ++i) {
        const double x = kBay * (i - 0.5 * kBays);
        for (const double side : {-1.0, 1.0}) {
            place(b, "column-" + std::to_string(i) + (side < 0 ? "-left" : "-right"), column_mesh,
                  at({x, 0, side * kHalfNave}));
            if (i < kBays) {
                place(b, "arch-" + std::to_string(i) + (side < 0 ? "-left" : "-right"), arcade,
                      at({x + 0.5 * kBay, kColumn, side * kHalfNave}));
            }
        }
        Transform across = at({x, kColumn, 0});
        across.rotation = quat(about_y(0.5 * kPi));
        place(b, "rib-" + std::to_string(i), rib, across);
    }
}

// Hangs from the middle of the ceiling and swings along the nave, 6 s a period.
void censer(Builder& b) {
    constexpr double kChain = 8.6, kSwing = 0.28, kSeconds = 6;
    constexpr int kKeys = 24;
    const std::uint32_t brass = b.matte("brass", {0.6f, 0.42f, 0.15f});
    const std::uint32_t chain = b.node("chain", at({0, kHeight, 0}));
    b.solid("rod", box({-0.02, -kChain, -0.02}, {0.02, 0, 0.02}), brass, {}, {}, chain);
    b.solid("censer", icosphere(0.45, 3), brass, {}, at({0, -kChain - 0.4, 0}), chain);
    AnimationChannel channel;
    channel.node = chain;
    channel.path = AnimationPath::rotation;
    channel.width = 4;
    for (int k = 0; k <= kKeys; ++k) {
        channel.times.push_back(static_cast<float>(kSeconds * k / kKeys));
        const double half = 0.5 * kSwing * std::sin(2 * kPi * k / kKeys);
        for (const double v : {0.0, 0.0, std::sin(half), std::cos(half)}) {
            channel.values.push_back(static_cast<float>(v));
        }
    }
    AnimationClip swing;
    swing.name = "swing";
    swing.duration = static_cast<float>(kSeconds);
    swing.channels.push_back(std::move(channel));
    b.scene.animations.push_back(std::move(swing));
}

}  // namespace nave_parts

SceneData nave() {
    using namespace nave_parts;
    Builder b;
    shell(b);
    columns_and_arches(b);
    censer(b);
    Light light;
    light.type = LightType::point;
    light.intensity = 2200;
    light.colour = {1, 0.84f, 0.62f};
    for (const double x : {-12.0, -4.0, 4.0, 12.0}) {
        b.light("lamp", at({x, 6.5, 0.4}), light);
    }
    b.camera("camera", looking({16.5, 2.2, 2.6}, {0, 3.2, -0.6}), glm::radians(65.0f));
    return b.scene;
}

}  // namespace lanthorn::scene_generator

#include <cmath>

#include "tools/scene_generator/room.h"
#include "tools/scene_generator/scenes.h"
#include "tools/scene_generator/uniform.h"
#include "tools/scene_generator/water.h"

namespace lanthorn::scene_generator {

namespace pool_parts {

constexpr double kBasin = 3, kHall = 4.5, kHeight = 4;  // half sides and height inside, metres
constexpr double kDepth = 1.2, kLevel = -0.25;          // of the basin, of the water's surface
constexpr double kSeconds = 6;                          // of the loop
constexpr int kCellsX = 164, kCellsZ = 165;             // two triangles each

constexpr Wave kWaves[] = {{0.05, 1.3, 0.6, 3},
                           {0.03, -0.9, 2.1, 4},
                           {0.018, 3.4, 2.6, 6},
                           {0.012, -4.8, 3.9, 8},
                           {0.005, 7.4, -6.1, 10}};

// Sixteen tiles of blue and turquoise with bright joints.
dvec3 tile(double x, double y) {
    constexpr double kJoint = 0.035;
    const double u = 4 * x, v = 4 * y;
    if (u - std::floor(u) < kJoint || v - std::floor(v) < kJoint) {
        return {0.78, 0.8, 0.78};
    }
    const auto which = static_cast<std::uint64_t>(std::floor(u) + 4 * std::floor(v));
    const double shade = 0.1 * (uniform(3, which) - 0.5);
    return dvec3(0.36, 0.68, 0.74) + shade * dvec3(0.6, 1, 0.9);
}

void hall(Builder& b) {
    constexpr double kOuter = kHall + kWallThickness;
    const std::uint32_t white = b.matte("white", {0.76f, 0.75f, 0.72f});
    const std::uint32_t orange = b.matte("orange", {0.75f, 0.32f, 0.08f});
    const std::uint32_t tiles = b.matte("tiles", vec3(1));
    b.texture(tiles, 256, 0.6, tile);
    const std::uint32_t stone = b.matte("stone", {0.55f, 0.52f, 0.46f});
    b.solid("ceiling", box({-kOuter, kHeight, -kOuter}, {kOuter, kHeight + kWallThickness, kOuter}), white);
    b.solid("orange-wall", box({-kOuter, 0, -kHall}, {-kHall, kHeight, kHall}), orange);
    b.solid("right-wall", box({kHall, 0, -kHall}, {kOuter, kHeight, kHall}), white);
    b.solid("back-wall", box({-kOuter, 0, -kOuter}, {kOuter, kHeight, -kHall}), white);
    b.solid("front-wall", box({-kOuter, 0, kHall}, {kOuter, kHeight, kOuter}), white);
    b.solid("bottom", box({-kBasin, -kDepth - kWallThickness, -kBasin}, {kBasin, -kDepth, kBasin}), tiles);
    // Tiled to just below the edge, a slab of stone on top.
    const auto bank = [&](const std::string& name, const dvec3& low, const dvec3& high) {
        constexpr double kSlab = 0.06;
        b.solid(name, box({low.x, -kDepth - kWallThickness, low.z}, {high.x, -kSlab, high.z}), tiles);
        b.solid(name + "-edge", box({low.x, -kSlab, low.z}, {high.x, 0, high.z}), stone);
    };
    bank("bank-left", {-kOuter, 0, -kBasin}, {-kBasin, 0, kBasin});
    bank("bank-right", {kBasin, 0, -kBasin}, {kOuter, 0, kBasin});
    bank("bank-back", {-kOuter, 0, -kOuter}, {kOuter, 0, -kBasin});
    bank("bank-front", {-kOuter, 0, kBasin}, {kOuter, 0, kOuter});
}

}  // namespace pool_parts

SceneData pool() {
    using namespace pool_parts;
    Builder b;
    hall(b);
    // A sheet: what is below it, down to the tiles, is water.
    const std::uint32_t surface =
        b.glass("water", 1.33f, static_cast<float>(kDepth + kLevel), {0.35f, 0.75f, 0.8f}, 3);
    b.scene.materials[surface].double_sided = true;
    b.scene.meshes.push_back(water_mesh(surface, kBasin, kBasin, kCellsX, kCellsZ, kWaves));
    const std::uint32_t water = b.node("water", at({0, kLevel, 0}));
    b.scene.nodes[water].meshes = {static_cast<std::uint32_t>(b.scene.meshes.size() - 1)};

    const dvec3 floats(0.9, kLevel, -0.4);
    const std::uint32_t ball =
        b.solid("ball", icosphere(0.3, 3), b.matte("ball", {0.8f, 0.1f, 0.08f}), {}, at(floats));
    AnimationClip waves;
    waves.name = "waves";
    waves.duration = static_cast<float>(kSeconds);
    waves.channels = {wave_channel(water, kWaves, kSeconds), float_channel(ball, floats, kWaves, kSeconds)};
    b.scene.animations.push_back(std::move(waves));

    b.panel("lamp", {-1.4, kHeight - 0.01, -1.6}, {-1.4, 0, -1.6}, 0.8, 0.8, vec3(1, 0.92f, 0.8f) * 6000.0f);
    b.camera("camera", looking({3.6, 2.3, 3.9}, {-0.6, -0.2, -0.8}), glm::radians(60.0f));
    return b.scene;
}

}  // namespace lanthorn::scene_generator

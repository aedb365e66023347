#include <fmt/format.h>

#include <cmath>

#include "tools/scene_generator/furniture.h"
#include "tools/scene_generator/level_parts.h"
#include "tools/scene_generator/plants.h"
#include "tools/scene_generator/scenes.h"
#include "tools/scene_generator/water.h"

namespace lanthorn::scene_generator {

namespace level_pool_parts {

constexpr dvec3 kHalf{3.7, 3.3, 3.0};
constexpr dvec3 kLamp{-3.3, 1.75, 0};
// The pool stands on the floor: a kerb of stone around it, too high to step over.
constexpr double kWest = -1.25, kEast = 2.35, kSide = 1.1;  // of the water
constexpr double kKerb = 0.25, kKerbHeight = 0.46, kLevel = 0.39;
constexpr double kSeconds = 6;  // of the waves' loop
constexpr Wave kWaves[] = {{0.0045, 5.1, 2.3, 3}, {0.0032, -3.9, 6.2, 4}, {0.0018, 8.6, -5.4, 6}};
// Panes on rails along Z between lamp and pool.
constexpr double kGreenRail = -2.45, kRedRail = -1.9, kTravel = 2.9, kStart = 1.45;

void shell(Builder& b, const Finishes& f) {
    const double t = kLevelWall;
    const std::uint32_t lime = painted_plaster(b, "pale-plaster", {0.62f, 0.6f, 0.55f});
    add_room(b, f, kHalf, {f.ashlar, lime, kNone, f.ashlar});
    add_wall_with_hole(b, f, "back-wall", f.ashlar, {-kHalf.x - t, 0, -kHalf.z - t},
                       {kHalf.x + t, kHalf.y, -kHalf.z}, {0.2, 1.5, -kHalf.z - t}, {1.6, 2.8, -kHalf.z}, 4);
    add_mouldings(b, f, {-kHalf.x, 0, -kHalf.z}, kHalf);
    add_beams(b, f, {-kHalf.x, 0, -kHalf.z}, kHalf, false, 5);
    add_spot(b, "moon", {0.2, 5.6, -6.4}, {1.3, 0, 0.9}, kMoonlight, 2400, 14, 20);
}

dvec3 tile(double x, double y) {
    constexpr double kJoint = 0.05;
    const double u = 4 * x, v = 4 * y;
    if (u - std::floor(u) < kJoint || v - std::floor(v) < kJoint) {
        return {0.75, 0.78, 0.74};
    }
    const double shade = std::fmod(std::floor(u) * 7 + std::floor(v) * 3, 5) / 5 - 0.4;
    return dvec3(0.24, 0.6, 0.62) + 0.16 * shade * dvec3(0.8, 0.9, 0.6);
}

void pool(Builder& b, const Finishes& f) {
    const std::uint32_t tiles = b.matte("tiles", vec3(1), 0.5f);
    b.texture(tiles, 64, 0.5, tile);
    constexpr double kLining = 0.03, kCap = 0.05;
    b.solid("pool-floor", box({kWest, 0, -kSide}, {kEast, kLining, kSide}), tiles);
    const auto kerb = [&](const std::string& name, const dvec3& low, const dvec3& high) {
        const dvec3 top(0, kKerbHeight - kCap, 0);
        b.solid("kerb-" + name, box(low, high + top), f.ashlar);
        b.solid("kerb-" + name + "-cap", box(low + top, high + top + dvec3(0, kCap, 0)), f.trim);
    };
    const double x0 = kWest - kKerb, x1 = kEast + kKerb, z1 = kSide + kKerb;
    kerb("west", {x0, 0, -z1}, {kWest, 0, z1});
    kerb("east", {kEast, 0, -z1}, {x1, 0, z1});
    kerb("north", {kWest, 0, -z1}, {kEast, 0, -kSide});
    kerb("south", {kWest, 0, kSide}, {kEast, 0, z1});
    constexpr double kTop = kKerbHeight - kCap;
    Shape lining;
    add_box(lining, {kWest, kLining, -kSide}, {kWest + kLining, kTop, kSide});
    add_box(lining, {kEast - kLining, kLining, -kSide}, {kEast, kTop, kSide});
    add_box(lining, {kWest + kLining, kLining, -kSide}, {kEast - kLining, kTop, -kSide + kLining});
    add_box(lining, {kWest + kLining, kLining, kSide - kLining}, {kEast - kLining, kTop, kSide});
    b.solid("pool-lining", lining, tiles);
    const std::uint32_t blocks = b.node("pool", at({0.5 * (kWest + kEast), 0, 0}));
    b.scene.nodes[blocks].extras =
        fmt::format(R"({{"collider":{{"shape":"box","size":[{},{},{}],"centre":[0,{},0]}}}})", x1 - x0,
                    kKerbHeight, 2 * z1, 0.5 * kKerbHeight);

    const std::uint32_t material =
        b.glass("water", 1.33f, static_cast<float>(kLevel - kLining), {0.45f, 0.8f, 0.82f}, 2);
    b.scene.materials[material].double_sided = true;
    b.scene.meshes.push_back(water_mesh(material, 0.5 * (kEast - kWest), kSide, 54, 33, kWaves));
    const std::uint32_t water = b.node("water", at({0.5 * (kWest + kEast), kLevel, 0}));
    b.scene.nodes[water].meshes = {static_cast<std::uint32_t>(b.scene.meshes.size() - 1)};
    AnimationClip waves;
    waves.name = "waves";
    waves.duration = static_cast<float>(kSeconds);
    waves.channels = {wave_channel(water, kWaves, kSeconds)};
    b.scene.animations.push_back(std::move(waves));
}

// Under a hood on the west wall; its light meets the water at a grazing angle.
void lamp(Builder& b, const Finishes& f) {
    const double x = -kHalf.x;
    Shape hood;
    add_box(hood, {x, kLamp.y - 0.04, -0.03}, {x + 0.16, kLamp.y + 0.04, 0.03});
    add_box(hood, {x + 0.16, kLamp.y - 0.14, -0.16}, {x + 0.2, kLamp.y + 0.16, 0.16});
    add_box(hood, {x + 0.2, kLamp.y + 0.12, -0.16}, {x + 0.62, kLamp.y + 0.16, 0.16});
    add_box(hood, {x + 0.2, kLamp.y - 0.14, -0.16}, {x + 0.5, kLamp.y + 0.12, -0.12});
    add_box(hood, {x + 0.2, kLamp.y - 0.14, 0.12}, {x + 0.5, kLamp.y + 0.12, 0.16});
    b.solid("lamp-hood", hood, f.brass, kBoxCollider);
    add_spot(b, "lamp", kLamp, {0.6, kLevel, 0}, {1, 0.8f, 0.55f}, 4500, 8, 10);
}

// A pane of coloured glass in a frame that the player pushes along its rail. `left`: of light, behind it.
void pane(Builder& b, const Finishes& f, const std::string& name, double x, double start, double travel,
          const vec3& left) {
    constexpr double kThick = 0.03, kWide = 0.36, kLow = 0.75, kHigh = 1.85;
    const std::uint32_t glass =
        b.glass(name + "-glass", 1.5f, static_cast<float>(kThick), left, static_cast<float>(kThick));
    const std::uint32_t node = b.node(name, at({x, 0, start}));
    b.scene.nodes[node].extras = fmt::format(
        R"({{"pushed":{{"rail":[0,0,{}]}},"body":{{"type":"kinematic","size":[0.4,1.9,0.84],"centre":[0,0.96,0]}}}})",
        travel);
    b.solid(name + "-pane", box({-0.5 * kThick, kLow, -kWide}, {0.5 * kThick, kHigh, kWide}), glass, {}, {},
            node);
    Shape frame;
    add_box(frame, {-0.04, kLow - 0.06, -kWide - 0.06}, {0.04, kLow, kWide + 0.06});
    add_box(frame, {-0.04, kHigh, -kWide - 0.06}, {0.04, kHigh + 0.06, kWide + 0.06});
    for (const double z : {-kWide - 0.06, kWide}) {
        add_box(frame, {-0.04, kLow, z}, {0.04, kHigh, z + 0.06});
        add_box(frame, {-0.03, 0.1, z}, {0.03, kLow - 0.06, z + 0.06});
        add_box(frame, {-0.2, 0.02, z - 0.03}, {0.2, 0.1, z + 0.09});
    }
    b.solid(name + "-frame", frame, f.oak, {}, {}, node);
    for (const double side : {-0.16, 0.14}) {
        b.solid(name + (side < 0 ? "-rail-west" : "-rail-east"),
                box({x + side, 0, -2.4}, {x + side + 0.02, 0.02, 2.4}), f.iron);
    }
}

}  // namespace level_pool_parts

SceneData level_pool() {
    using namespace level_pool_parts;
    Builder b;
    const Finishes f = finishes(b);
    shell(b, f);
    pool(b, f);
    lamp(b, f);
    pane(b, f, "green-pane", kGreenRail, -kStart, kTravel, {0.1f, 0.8f, 0.2f});
    pane(b, f, "red-pane", kRedRail, kStart, -kTravel, {0.85f, 0.06f, 0.04f});
    add_crystal(b, f, "emerald", {kHalf.x, 1.5, -0.62}, {-1, 0, 0}, {0.08f, 0.6f, 0.14f},
                R"("filter":[-1.2,1,-0.8])",
                R"("lux":1.2,"seconds":1.5,"symbol":"triangle","glow":[0.8,11,1.6])");
    add_crystal(b, f, "ruby", {kHalf.x, 1.5, 0.62}, {-1, 0, 0}, {0.75f, 0.08f, 0.06f},
                R"("filter":[1,-1.2,-0.8])",
                R"("lux":1.2,"seconds":1.5,"symbol":"drop","glow":[16,0.7,0.9])");
    for (const double z : {-2.0, 2.0}) {
        add_sconce(b, f, z < 0 ? "sconce-north" : "sconce-south", {-kHalf.x, 2.0, z}, {1, 0, 0}, 45);
    }
    const Fern plant = fern(b);
    add_fern(b, plant, "fern-north", {3.2, 0, -2.5}, 1.25, 0.3);
    add_fern(b, plant, "fern-south", {3.2, 0, 2.5}, 1.15, 2.4);
    add_fern(b, plant, "fern-kerb", {-0.4, 0, -1.75}, 0.85, 4.4);
    b.solid("bench", box({0.2, 0.4, 2.45}, {2.0, 0.46, 2.85}), f.oak, kBoxCollider);
    b.solid("bench-legs",
            whole({{"a", {0.3, 0, 2.5}, {0.38, 0.4, 2.8}}, {"b", {1.82, 0, 2.5}, {1.9, 0.4, 2.8}}}), f.oak);
    b.camera("camera", looking({-0.4, 1.75, 2.62}, {2.6, 0.95, -0.9}), glm::radians(64.0f));
    add_player(b, {-1.03, 0, 2.43}, {3.0, 1.2, 1.2});
    add_level(b, R"("title":"The pool",
        "hints":["The lamp does not shine on the crystals. Its light still gets there.",
                 "Water is a mirror for light that comes in low; glass colours what goes through it.",
                 "Push one pane into the beam at a time. When its crystal is awake, push it out again."],
        "tour":[{"go":[-1.03,0,2.43],"look":[3.0,1.2,1.2],"seconds":1.5},
                {"go":[-2.75,0,2.45],"look":[-2.4,1.2,-1.4],"seconds":1.8},
                {"go":[-2.75,0,-0.3],"look":[-2.4,1.2,-1.4],"seconds":2.3},
                {"go":[-3.15,0,-1.1],"look":[-2.4,1.2,-1.4],"seconds":1},
                {"go":[-3.1,0,-2.3],"look":[-2.4,1.2,-1.4],"seconds":1.3},
                {"go":[-2.45,0,-2.65],"look":[-2.4,1.2,0],"seconds":1.5},
                {"go":[-2.45,0,-0.74],"look":[-2.4,1.2,1],"seconds":2.6},
                {"go":[-2.45,0,-0.74],"look":[3.6,1.4,-0.4],"seconds":3.5},
                {"go":[-2.45,0,0.3],"look":[-2.4,1.2,2],"seconds":2},
                {"go":[-3.15,0,0.4],"look":[-2.4,1.2,2],"seconds":1},
                {"go":[-3.1,0,2.5],"look":[-1.9,1.2,1.6],"seconds":2},
                {"go":[-1.9,0,2.65],"look":[-1.9,1.2,0],"seconds":1.6},
                {"go":[-1.9,0,0.74],"look":[-1.9,1.2,-1],"seconds":2.6},
                {"go":[-1.9,0,0.74],"look":[3.6,1.4,0.4],"seconds":4}])");
    b.camera("wall", looking({-0.9, 1.6, 2.4}, {3.4, 1.2, -0.3}), glm::radians(62.0f));
    return b.scene;
}

}  // namespace lanthorn::scene_generator

#include <cmath>
#include <numbers>

#include "tools/scene_generator/furniture.h"
#include "tools/scene_generator/level_parts.h"
#include "tools/scene_generator/plants.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

namespace level_other_light_parts {

constexpr dvec3 kHalf{3.6, 3.2, 3.0};
constexpr double kRow = -1.0;              // Z of the beacon, the window's middle and the mirror
constexpr dvec3 kBeacon{11.8, 3.2, kRow};  // of another tower
constexpr dvec3 kMirror{0.4, 0, kRow};
constexpr dvec3 kPearl{kHalf.x, 0.82, 1.75};
constexpr double kSeconds = 24, kSwing = 0.2;  // of the beacon's way to and fro; radians to either side

void shell(Builder& b, const Finishes& f) {
    const double t = kLevelWall;
    const std::uint32_t dusk = painted_plaster(b, "dusk-plaster", {0.2f, 0.16f, 0.27f});
    add_room(b, f, kHalf, {f.ashlar, kNone, dusk, f.ashlar});
    add_wall_with_hole(b, f, "east-wall", f.ashlar, {kHalf.x, 0, -kHalf.z}, {kHalf.x + t, kHalf.y, kHalf.z},
                       {kHalf.x, 1.25, kRow - 0.75}, {kHalf.x + t, 2.75, kRow + 0.75}, 2);
    add_mouldings(b, f, {-kHalf.x, 0, -kHalf.z}, kHalf);
    add_beams(b, f, {-kHalf.x, 0, -kHalf.z}, kHalf, false, 5);
}

// The beacon turns to and fro: its light goes by the window.
void beacon(Builder& b) {
    constexpr int kKeys = 24;
    add_spot(b, "beacon", kBeacon, kMirror + dvec3(0, 1.45, 0), {1, 0.86f, 0.62f}, 15000, 3.6f, 5.2f);
    const auto node = static_cast<std::uint32_t>(b.scene.nodes.size() - 1);
    const glm::dquat ahead(b.scene.nodes[node].local.rotation);
    AnimationClip clip;
    clip.name = "beacon";
    clip.duration = static_cast<float>(kSeconds);
    AnimationChannel channel;
    channel.node = node;
    channel.path = AnimationPath::rotation;
    channel.interpolation = Interpolation::linear;
    channel.width = 4;
    for (int k = 0; k <= kKeys; ++k) {
        const double phase = static_cast<double>(k) / kKeys;
        const double aside = kSwing * std::cos(2 * std::numbers::pi * phase);
        const glm::dquat turned = glm::angleAxis(aside, dvec3(0, 1, 0)) * ahead;
        channel.times.push_back(static_cast<float>(kSeconds * phase));
        for (const double v : {turned.x, turned.y, turned.z, turned.w}) {
            channel.values.push_back(static_cast<float>(v));
        }
    }
    clip.channels = {channel};
    b.scene.animations.push_back(std::move(clip));
}

void furniture(Builder& b, const Finishes& f) {
    const std::uint32_t blue = painted_plaster(b, "blue-paint", {0.07f, 0.16f, 0.4f});
    const std::uint32_t ochre = painted_plaster(b, "ochre-paint", {0.6f, 0.33f, 0.06f});
    // Before the pearl.
    add_crate(b, f, "crate-low", {2.75, 0, 0.85}, 1.0, blue, 11);
    add_crate(b, f, "crate-high", {2.73, 1.0, 0.87}, 0.75, ochre, 4);
    add_crate(b, f, "crate-aside", {-0.9, 0, -2.55}, 0.6, ochre, 8);
    b.table("table", {-2.6, 0, -2.4}, 1.3, 0.7, 0.78, f.oak, kBoxCollider);
    b.solid("chart", box({-3.0, 0.78, -2.6}, {-2.3, 0.785, -2.2}), b.matte("paper", {0.72f, 0.64f, 0.46f}));
    b.solid("globe", icosphere(0.15, 3), f.brass, {}, at({-2.15, 0.99, -2.45}));
    b.solid("globe-foot", box({-0.06, 0, -0.06}, {0.06, 0.06, 0.06}), f.oak, {}, at({-2.15, 0.78, -2.45}));
    b.solid("bench", box({-0.2, 0.4, 2.5}, {1.6, 0.46, 2.9}), f.oak, kBoxCollider);
    b.solid("bench-legs",
            whole({{"a", {-0.1, 0, 2.55}, {-0.02, 0.4, 2.85}}, {"b", {1.42, 0, 2.55}, {1.5, 0.4, 2.85}}}),
            f.oak);
    const Fern plant = fern(b);
    add_fern(b, plant, "fern-east", {3.2, 0, -2.55}, 1.1, 0.8);
}

}  // namespace level_other_light_parts

SceneData level_other_light() {
    using namespace level_other_light_parts;
    Builder b;
    const Finishes f = finishes(b, {0.4f, 0.37f, 0.33f});
    shell(b, f);
    beacon(b);
    const std::uint32_t silver = b.metal("silver", {0.93f, 0.92f, 0.9f}, 0.03f);
    add_turning_mirror(b, f, silver, "mirror", kMirror, 30, 0.2);
    add_crystal(b, f, "pearl", kPearl, {-1, 0, 0}, {0.8f, 0.74f, 0.58f}, R"("filter":[0.3,0.7,0])",
                R"("lux":12,"seconds":2,"symbol":"circle","glow":[12,10.5,7])");
    furniture(b, f);
    add_sconce(b, f, "sconce", {-0.4, 2.0, -kHalf.z}, {0, 0, 1}, 38);
    add_sconce(b, f, "sconce-south", {-2.4, 2.0, kHalf.z}, {0, 0, -1}, 38);
    add_contract(b, "floor-is-lit", {0, 0.3, 0}, {7, 0.65, 5.8}, R"("lower":0.3,"share":0.7)");
    add_contract(b, "pearl-is-dark", {kPearl.x, kPearl.y, kPearl.z}, {0.2, 0.9, 0.9}, R"("upper":14)");
    b.camera("camera", looking({-2.6, 1.8, 1.9}, {1.6, 1.2, -0.1}), glm::radians(60.0f));
    add_player(b, {-0.6, 0, 1.0}, {3.6, 1.3, 0.4});
    add_level(b, R"("title":"The other light",
        "hints":["The light of another tower comes by the window. It comes again.",
                 "A mirror hands on what it meets, as long as it is there. What stands in the way can be shoved.",
                 "Shove the crates from before the pearl, turn the mirror towards it, and wait for the light."],
        "tour":[{"go":[-0.6,0,1.0],"look":[3.6,1.3,0.4],"seconds":1.5},
                {"go":[1.5,0,1.9],"look":[2.75,0.8,1.2],"seconds":2.5},
                {"go":[2.75,0,2.3],"look":[2.75,1.0,0],"seconds":1.5},
                {"go":[2.75,0,0.3],"look":[2.75,1.0,-1],"seconds":4},
                {"go":[1.2,0,1.2],"look":[0.4,1.2,-1],"seconds":2},
                {"go":[0.2,0,0.5],"look":[0.4,1.2,-1],"seconds":1.5},
                {"go":[0.2,0,0.5],"look":[0.4,1.2,-1],"seconds":3.5,"deed":"use","hold":true},
                {"go":[0.0,0,1.2],"look":[3.6,1.0,1.1],"seconds":13}])");
    return b.scene;
}

}  // namespace lanthorn::scene_generator

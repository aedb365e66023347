#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "tools/scene_generator/furniture.h"
#include "tools/scene_generator/lathe.h"
#include "tools/scene_generator/level_furnishings.h"
#include "tools/scene_generator/level_parts.h"
#include "tools/scene_generator/plants.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

namespace level_burning_glass_parts {

constexpr dvec3 kHalf{3.8, 3.3, 3.0};
// The lamp, the lens where it is pushed to, and the mirror stand in a row, `kBeam` above the floor.
constexpr double kBeam = 1.45, kRow = -1.75;
constexpr dvec3 kLamp{-3.5, kBeam, kRow};
constexpr double kLensX = -1.3, kMirrorX = 1.6;
constexpr double kRadius = 0.4;                // of the lens
constexpr double kRest = -0.7, kEnd = kRow;    // Z of the lens, as it is found and in the beam
constexpr dvec3 kTopaz{-kHalf.x, kBeam, 1.9};  // on the west wall

// Biconvex, about +Y: what the lamp sends through it comes together at the topaz, by way of the mirror.
// 1 / f = 1 / from + 1 / to, and f is the radius of its faces, as 1 / f = (n - 1) (1 / R + 1 / R) and n
// = 1.5.
Shape lens() {
    const double from = kLensX - kLamp.x;
    const double to = kMirrorX - kLensX + glm::distance(dvec3(kMirrorX, kBeam, kRow), kTopaz);
    const double face = 1 / (1 / from + 1 / to);
    constexpr int kRings = 7, kSides = 40;
    constexpr double kRim = 0.012;  // half of the edge's thickness
    const double centre = std::sqrt(face * face - kRadius * kRadius) - kRim;
    Outline outline;
    const auto add = [&](int ring, double side) {
        const double r = kRadius * ring / kRings;
        const double y = std::sqrt(face * face - r * r);
        outline.push_back({{r, side * (y - centre)}, {r / face, side * y / face}});
    };
    for (int i = 0; i <= kRings; ++i) {
        add(i, -1);
    }
    outline.push_back({outline.back().place, {1, 0}});
    outline.push_back({{kRadius, -outline.back().place.y}, {1, 0}});
    for (int i = kRings; i >= 0; --i) {
        add(i, 1);
    }
    return lathe(outline, kSides);
}

void shell(Builder& b, const Finishes& f) {
    const double t = kLevelWall;
    const std::uint32_t teal = painted_plaster(b, "teal-plaster", {0.07f, 0.19f, 0.2f});
    add_room(b, f, kHalf, {teal, f.ashlar, kNone, f.ashlar});
    add_wall_with_hole(b, f, "back-wall", f.ashlar, {-kHalf.x - t, 0, -kHalf.z - t},
                       {kHalf.x + t, kHalf.y, -kHalf.z}, {-0.75, 1.35, -kHalf.z - t}, {0.55, 2.75, -kHalf.z},
                       3);
    add_mouldings(b, f, {-kHalf.x, 0, -kHalf.z}, kHalf);
    add_beams(b, f, {-kHalf.x, 0, -kHalf.z}, kHalf, false, 5);
    add_spot(b, "moon", {-1.6, 5.4, -6.6}, {0.5, 0, 0.2}, kMoonlight, 1300, 14, 20);
}

// Under a hood on the west wall; nothing of its light goes past the lens.
void lamp(Builder& b, const Finishes& f) {
    const double x = -kHalf.x, y = kLamp.y, z = kLamp.z;
    Shape hood;
    add_box(hood, {x, y - 0.04, z - 0.03}, {x + 0.14, y + 0.04, z + 0.03});
    add_box(hood, {x + 0.14, y - 0.16, z - 0.16}, {x + 0.18, y + 0.16, z + 0.16});
    add_box(hood, {x + 0.18, y + 0.12, z - 0.16}, {x + 0.6, y + 0.16, z + 0.16});
    add_box(hood, {x + 0.18, y - 0.16, z - 0.16}, {x + 0.6, y - 0.12, z + 0.16});
    add_box(hood, {x + 0.18, y - 0.12, z - 0.16}, {x + 0.6, y + 0.12, z - 0.12});
    add_box(hood, {x + 0.18, y - 0.12, z + 0.12}, {x + 0.6, y + 0.12, z + 0.16});
    b.solid("lamp-hood", hood, f.brass, kBoxCollider);
    add_spot(b, "lamp", kLamp, {kMirrorX, kBeam, kRow}, {1, 0.8f, 0.52f}, 1500, 7.5f, 10.2f);
}

// A lens of honey-coloured glass in a ring of brass, on a stand that is pushed along Z.
void lens_on_rail(Builder& b, const Finishes& f) {
    const std::uint32_t glass = b.glass("lens-glass", 1.5f, 0.1f, {1, 0.86f, 0.55f}, 0.1f);
    const std::uint32_t node = b.node("lens", at({kLensX, 0, kRest}));
    b.scene.nodes[node].extras = fmt::format(
        R"({{"pushed":{{"rail":[0,0,{}]}},"body":{{"type":"kinematic","size":[0.4,2,0.94],"centre":[0,1.01,0]}}}})",
        kEnd - kRest);
    Transform across = at({0, kBeam, 0});  // what is about +Y is to be about +X
    across.rotation = quat(glm::angleAxis(-0.5 * std::numbers::pi, dvec3(0, 0, 1)));
    b.solid("lens-disc", lens(), glass, {}, across, node);
    Transform ring = across;
    ring.translation.x = -0.04;
    b.solid("lens-ring", ring_band(kRadius, kRadius + 0.055, 0.08, 0.02, 40), f.brass, {}, ring, node);
    Shape stand;
    const double low = kBeam - kRadius - 0.05;
    add_box(stand, {-0.035, 0.1, -0.05}, {0.035, low, 0.05});
    add_box(stand, {-0.2, 0.02, -0.4}, {0.2, 0.1, 0.4});
    for (const double z : {-0.42, 0.36}) {
        add_box(stand, {-0.03, 0.1, z}, {0.03, kBeam + 0.1, z + 0.06});
    }
    add_box(stand, {-0.028, 0.7, -0.36}, {0.028, 0.76, -0.05});
    add_box(stand, {-0.028, 0.7, 0.05}, {0.028, 0.76, 0.36});
    b.solid("lens-stand", stand, f.oak, {}, {}, node);
    for (const double side : {-0.16, 0.14}) {
        b.solid(side < 0 ? "lens-rail-west" : "lens-rail-east",
                box({kLensX + side, 0, kEnd - 0.5}, {kLensX + side + 0.02, 0.02, kRest + 0.5}), f.iron);
    }
}

void furniture(Builder& b, const Finishes& f) {
    add_bookshelf(b, f, "shelf", {-2.6, 0, -2.96}, {1.3, 2.0, 0.35}, 5, 16);
    b.table("table", {0.6, 0, 2.3}, 1.4, 0.7, 0.78, f.oak, kBoxCollider);
    const std::uint32_t leather = b.matte("leather", {0.2f, 0.06f, 0.03f}, 0.5f);
    b.solid(
        "books",
        whole({{"a", {0.1, 0.78, 2.15}, {0.38, 0.83, 2.35}}, {"b", {0.12, 0.83, 2.17}, {0.36, 0.87, 2.34}}}),
        leather);
    b.solid("globe", icosphere(0.17, 3), f.brass, {}, at({1.0, 1.01, 2.3}));
    b.solid("globe-foot", box({-0.07, 0, -0.07}, {0.07, 0.06, 0.07}), f.oak, {}, at({1.0, 0.78, 2.3}));
    const Fern plant = fern(b);
    add_fern(b, plant, "fern-west", {-3.3, 0, 2.4}, 1.2, 0.6);
    add_fern(b, plant, "fern-east", {3.3, 0, -2.5}, 1.1, 2.9);
}

}  // namespace level_burning_glass_parts

SceneData level_burning_glass() {
    using namespace level_burning_glass_parts;
    Builder b;
    const Finishes f = finishes(b, {0.38f, 0.36f, 0.34f});
    shell(b, f);
    lamp(b, f);
    lens_on_rail(b, f);
    const std::uint32_t silver = b.metal("silver", {0.93f, 0.92f, 0.9f}, 0.03f);
    add_turning_mirror(b, f, silver, "mirror", {kMirrorX, 0, kRow}, -95, 0.2);
    add_crystal(b, f, "topaz", kTopaz, {1, 0, 0}, {0.75f, 0.42f, 0.05f}, R"("filter":[0.3,0.7,0])",
                R"("lux":25,"seconds":1.5,"symbol":"square","glow":[15,7.5,0.6])");
    furniture(b, f);
    add_sconce(b, f, "sconce", {2.6, 2.0, kHalf.z}, {0, 0, -1}, 30);
    add_contract(b, "floor-is-lit", {0, 0.3, 0}, {7.4, 0.65, 5.8}, R"("lower":0.3,"share":0.7)");
    add_contract(b, "topaz-is-dark", kTopaz, {0.2, 0.9, 0.9}, R"("upper":12)");
    b.camera("camera", looking({1.0, 1.75, 1.5}, {-2.7, 1.2, -0.3}), glm::radians(64.0f));
    add_player(b, {1.35, 0, 0.0}, {-3.8, 1.3, -0.7});
    add_level(b, R"("title":"The burning glass",
        "hints":["The lamp lights the mirror already. So wide a light is too thin for the topaz.",
                 "A lens gathers what goes through it.",
                 "Push the lens into the beam, then turn the mirror until the bright spot lies on the topaz."],
        "tour":[{"go":[1.35,0,0],"look":[-3.8,1.3,-0.7],"seconds":1.5},
                {"go":[-1.2,0,1.0],"look":[-1.3,1.3,-0.7],"seconds":3},
                {"go":[-1.3,0,0.3],"look":[-1.3,1.3,-1.75],"seconds":1.5},
                {"go":[-1.3,0,-1.1],"look":[-1.3,1.3,-1.75],"seconds":2.5},
                {"go":[0.7,0,-0.15],"look":[1.6,1.3,-1.75],"seconds":2.5},
                {"go":[0.7,0,-0.15],"look":[1.6,1.3,-1.75],"seconds":1.8,"deed":"use","hold":true},
                {"go":[0.4,0,0.3],"look":[-3.8,1.4,2.1],"seconds":4}])");
    b.camera("topaz-view", looking({1.4, 1.6, 1.6}, {-3.4, 1.3, 0.2}), glm::radians(60.0f));
    return b.scene;
}

}  // namespace lanthorn::scene_generator

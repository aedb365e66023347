#include <cmath>

#include "tools/scene_generator/furniture.h"
#include "tools/scene_generator/level_furnishings.h"
#include "tools/scene_generator/level_parts.h"
#include "tools/scene_generator/plants.h"
#include "tools/scene_generator/scenes.h"
#include "tools/scene_generator/uniform.h"

namespace lanthorn::scene_generator {

namespace level_mirrors_parts {

constexpr dvec3 kHalf{3.6, 3.3, 3.0};
// The room is an L: its corner of -X and -Z, up to here, is solid.
constexpr double kBlockX = -0.8, kBlockZ = -0.45;
constexpr double kBeam = 1.6;    // Z of the moonlight's way in
constexpr double kTurned = 2.3;  // X at which it is turned towards -Z
constexpr double kBack = -1.75;  // Z at which it is turned back, to the crystal

// A night sky painted on plaster: stars of four points, some of gold, some pale.
std::uint32_t painted_stars(Builder& b) {
    const std::uint32_t material = b.matte("night-plaster", vec3(1), 0.5f);
    constexpr int kCells = 5;  // a star each
    b.texture(material, 128, 1.9, [](double x, double y) {
        const double u = x * kCells, v = y * kCells;
        const auto cell = static_cast<std::uint64_t>(std::floor(u) + kCells * std::floor(v));
        const double size = 0.06 + 0.12 * uniform(91, cell);
        const double dx = std::abs(u - std::floor(u) - 0.25 - 0.5 * uniform(92, cell));
        const double dy = std::abs(v - std::floor(v) - 0.25 - 0.5 * uniform(93, cell));
        const bool star = std::max(dx, dy) + 2.2 * std::min(dx, dy) < size;
        const dvec3 paint = uniform(94, cell) < 0.6 ? dvec3(0.78, 0.6, 0.3) : dvec3(0.72, 0.75, 0.82);
        return star ? paint
                    : dvec3(0.36, 0.4, 0.52) *
                          (0.94 + 0.12 * uniform(95, static_cast<std::uint64_t>(997 * x) +
                                                         1000 * static_cast<std::uint64_t>(997 * y)));
    });
    return material;
}

void shell(Builder& b, const Finishes& f) {
    const double t = kLevelWall;
    const std::uint32_t night = painted_stars(b);
    add_room(b, f, kHalf, {kNone, f.plaster, night, f.ashlar});
    add_wall_with_hole(b, f, "west-wall", f.ashlar, {-kHalf.x - t, 0, -kHalf.z}, {-kHalf.x, kHalf.y, kHalf.z},
                       {-kHalf.x - t, 1.2, kBeam - 0.35}, {-kHalf.x, 2.4, kBeam + 0.35}, 0);
    b.solid("block", box({-kHalf.x, 0, -kHalf.z}, {kBlockX, kHalf.y, kBlockZ}), f.ashlar, kBoxCollider);
    b.solid("block-foot", box({-kHalf.x + 0.04, 0, kBlockZ}, {kBlockX + 0.04, 0.16, kBlockZ + 0.04}), f.trim);
    b.solid("block-foot-east", box({kBlockX, 0, -kHalf.z + 0.04}, {kBlockX + 0.04, 0.16, kBlockZ}), f.trim);
    add_mouldings(b, f, {-kHalf.x, 0, -kHalf.z}, kHalf);
    add_beams(b, f, {-kHalf.x, 0, -kHalf.z}, kHalf, false, 5);
    // Nearly level: after two mirrors it is still above the floor.
    add_spot(b, "moon", {-9.6, 1.97, kBeam}, {kTurned, 1.5, kBeam}, kMoonlight, 5500, 2.2f, 3.0f);
    // A surround of the window, inside.
    Shape surround;
    add_box(surround, {-kHalf.x, 1.1, kBeam - 0.5}, {-kHalf.x + 0.1, 1.2, kBeam + 0.5});
    add_box(surround, {-kHalf.x, 2.4, kBeam - 0.5}, {-kHalf.x + 0.08, 2.52, kBeam + 0.5});
    for (const double z : {kBeam - 0.47, kBeam + 0.35}) {
        add_box(surround, {-kHalf.x, 1.2, z}, {-kHalf.x + 0.05, 2.4, z + 0.12});
    }
    b.solid("window-surround", surround, f.trim);
}

// Where the crystal is: between pilasters, under a lintel.
void shrine(Builder& b, const Finishes& f) {
    Shape frame;
    for (const double z : {kBack - 0.86, kBack + 0.68}) {
        add_box(frame, {kBlockX, 0.16, z}, {kBlockX + 0.1, 2.3, z + 0.18});
        add_box(frame, {kBlockX, 2.3, z - 0.03}, {kBlockX + 0.14, 2.4, z + 0.21});
    }
    add_box(frame, {kBlockX, 2.4, kBack - 0.95}, {kBlockX + 0.16, 2.58, kBack + 0.95});
    add_box(frame, {kBlockX, 2.58, kBack - 1.0}, {kBlockX + 0.2, 2.64, kBack + 1.0});
    b.solid("shrine", frame, f.trim);
    add_crystal(b, f, "moonstone", {kBlockX, 1.25, kBack}, {1, 0, 0}, {0.45f, 0.6f, 0.8f},
                R"("filter":[-0.9,-0.2,1])", R"("lux":1.2,"seconds":1.5,"symbol":"moon","glow":[5,8.5,15])");
}

void furniture(Builder& b, const Finishes& f) {
    b.table("table", {-2.2, 0, 0.15}, 1.3, 0.7, 0.78, f.oak, kBoxCollider);
    b.solid("globe", icosphere(0.16, 3), f.brass, {}, at({-1.9, 1.0, 0.1}));
    b.solid("globe-foot", box({-0.06, 0, -0.06}, {0.06, 0.06, 0.06}), f.oak, {}, at({-1.9, 0.78, 0.1}));
    b.solid(
        "books",
        whole({{"a", {-2.7, 0.78, 0}, {-2.42, 0.82, 0.2}}, {"b", {-2.68, 0.82, 0.02}, {-2.43, 0.86, 0.19}}}),
        b.matte("leather", {0.22f, 0.05f, 0.03f}, 0.5f));
    b.solid("chair", whole(chair_parts()), f.oak, kBoxCollider, at({-2.9, 0, 0.65}));
    // Where the first mirror throws the moonlight before anybody turns it.
    const std::uint32_t red = painted_plaster(b, "red-paint", {0.55f, 0.07f, 0.04f});
    const std::uint32_t ochre = painted_plaster(b, "ochre-paint", {0.6f, 0.33f, 0.06f});
    add_crate(b, f, "crate-low", {2.72, 0, 2.62}, 0.6, ochre, 14);
    add_crate(b, f, "crate-middle", {2.75, 0.6, 2.6}, 0.5, red, 8);
    add_crate(b, f, "crate-high", {2.71, 1.1, 2.63}, 0.42, ochre, 5);
    add_crate(b, f, "crate-aside", {2.05, 0, 2.66}, 0.45, red, 6);
    b.solid("ball", icosphere(0.17, 3), b.matte("turquoise", {0.05f, 0.4f, 0.42f}, 0.5f),
            R"({"body":{"type":"dynamic","shape":"sphere","radius":0.17,"mass":2}})", at({0.5, 0.17, 0.2}));
    add_carpet(b, "carpet", {-0.5, 0, -2.55}, {1.5, 0.012, -0.95}, kRedCarpet);
    const Fern plant = fern(b);
    add_fern(b, plant, "fern-corner", {3.2, 0, 1.0}, 1.1, 0.4);
    add_fern(b, plant, "fern-shrine", {-0.4, 0, -0.1}, 0.95, 2.1);
    add_fern(b, plant, "fern-alcove", {3.2, 0, -2.6}, 1.1, 4.0);
}

}  // namespace level_mirrors_parts

SceneData level_mirrors() {
    using namespace level_mirrors_parts;
    Builder b;
    const Finishes f = finishes(b);
    shell(b, f);
    shrine(b, f);
    const std::uint32_t silver = b.metal("silver", {0.93f, 0.92f, 0.9f}, 0.03f);
    add_turning_mirror(b, f, silver, "mirror-south", {kTurned, 0, kBeam}, -35, 0.4);
    add_turning_mirror(b, f, silver, "mirror-north", {kTurned, 0, kBack}, -66, 0.4);
    furniture(b, f);
    add_sconce(b, f, "sconce", {-2.1, 1.95, kBlockZ}, {0, 0, 1}, 30);
    // Beside the crystal: what it is seen by as the level begins.
    add_sconce(b, f, "sconce-shrine", {kBlockX, 1.95, kBlockZ - 0.22}, {1, 0, 0}, 14);
    b.camera("camera", looking({-1.6, 1.75, 2.5}, {2.1, 1.12, -0.35}), glm::radians(62.0f));
    add_player(b, {1.08, 0, 0.3}, {1.25, 1.25, -3});
    add_level(b, R"("title":"Two mirrors",
        "hints":["Moonlight goes straight on until it meets a mirror.",
                 "Mirrors turn as long as they are used. Stand beside the light's way, not in it.",
                 "Turn the first mirror until it lights the second, and that until the moonstone is lit."],
        "tour":[{"go":[1.08,0,0.3],"look":[1.25,1.25,-3],"seconds":1},
                {"go":[1.0,0,0.55],"look":[2.3,1.2,1.6],"seconds":3.5},
                {"go":[1.0,0,0.55],"look":[2.3,1.2,1.6],"seconds":3.49,"deed":"use","hold":true},
                {"go":[1.0,0,-0.6],"look":[2.3,1.2,-1.75],"seconds":2},
                {"go":[1.0,0,-0.6],"look":[2.3,1.2,-1.75],"seconds":0.92,"deed":"use","hold":true},
                {"go":[1.1,0,-0.4],"look":[-0.8,1.3,-1.35],"seconds":4}])");
    b.camera("shrine", looking({2.6, 1.7, 0.3}, {-0.6, 1.15, -1.7}), glm::radians(66.0f));
    return b.scene;
}

}  // namespace lanthorn::scene_generator

#include "tools/scene_generator/furniture.h"
#include "tools/scene_generator/level_furnishings.h"
#include "tools/scene_generator/level_parts.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

namespace level_green_screen_parts {

constexpr dvec3 kHalf{3.6, 3.2, 2.9};
constexpr double kRail = 1.3;  // X of the screen's rail

void shell(Builder& b, const Finishes& f) {
    const double t = kLevelWall;
    add_room(b, f, kHalf, {f.plaster, f.ashlar, kNone, f.ashlar});
    add_wall_with_hole(b, f, "back-wall", f.ashlar, {-kHalf.x - t, 0, -kHalf.z - t},
                       {kHalf.x + t, kHalf.y, -kHalf.z}, {-2.5, 1.1, -kHalf.z - t}, {-1.3, 2.5, -kHalf.z}, 3);
    add_mouldings(b, f, {-kHalf.x, 0, -kHalf.z}, kHalf);
    add_beams(b, f, {-kHalf.x, 0, -kHalf.z}, kHalf, true, 4);
    add_spot(b, "moon", {-2.6, 4.6, -6.0}, {-1.5, 0, -0.9}, kMoonlight, 1500, 16, 22);
    // Panels of oak where the beam ends: they send nearly nothing back.
    b.solid("panelling", box({kHalf.x - 0.06, 0.16, -1.6}, {kHalf.x, 2.5, 1.6}), f.oak);
    b.solid("panelling-cap", box({kHalf.x - 0.1, 2.5, -1.65}, {kHalf.x, 2.58, 1.65}), f.trim);
    for (const double z : {-1.7, 1.7}) {
        b.solid(z < 0 ? "pilaster-north" : "pilaster-south",
                box({kHalf.x - 0.12, 0, z - 0.1}, {kHalf.x, 2.7, z + 0.1}), f.trim);
    }
}

// A lamp under a hood on the west wall, whose beam crosses the room; it lights nothing of its own wall.
void lamp(Builder& b, const Finishes& f) {
    b.solid("lamp-arm", box({-kHalf.x, 2.34, 0.81}, {-kHalf.x + 0.2, 2.4, 0.89}), f.iron);
    Shape hood;
    add_box(hood, {-kHalf.x + 0.2, 2.26, 0.71}, {-kHalf.x + 0.24, 2.5, 0.99});
    add_box(hood, {-kHalf.x + 0.24, 2.46, 0.71}, {-kHalf.x + 0.5, 2.5, 0.99});
    add_box(hood, {-kHalf.x + 0.24, 2.26, 0.71}, {-kHalf.x + 0.5, 2.46, 0.75});
    add_box(hood, {-kHalf.x + 0.24, 2.26, 0.95}, {-kHalf.x + 0.5, 2.46, 0.99});
    b.solid("lamp-hood", hood, f.brass, kBoxCollider);
    add_spot(b, "lamp", {-kHalf.x + 0.34, 2.38, 0.85}, {kRail, 1.2, 0.85}, {1, 0.8f, 0.55f}, 3600, 10, 14);
}

// Stands north of the beam; its rail leads into it.
void screen(Builder& b, const Finishes& f) {
    const std::uint32_t green = painted_plaster(b, "green-lacquer", {0.03f, 0.5f, 0.09f});
    const double start = -1.35, travel = 2;
    const std::uint32_t node = b.node("screen", at({kRail, 0, start}));
    b.scene.nodes[node].extras =
        R"({"pushed":{"rail":[0,0,2]},"body":{"type":"kinematic","size":[0.5,2.2,1.74],"centre":[0,1.11,0]}})";
    b.solid("screen-panel", box({-0.03, 0.24, -0.8}, {0.03, 2.15, 0.8}), green, {}, {}, node);
    Shape frame;
    add_box(frame, {-0.06, 0.1, -0.87}, {0.06, 2.22, -0.8});
    add_box(frame, {-0.06, 0.1, 0.8}, {0.06, 2.22, 0.87});
    add_box(frame, {-0.06, 2.15, -0.8}, {0.06, 2.22, 0.8});
    add_box(frame, {-0.06, 0.16, -0.8}, {0.06, 0.24, 0.8});
    add_box(frame, {-0.25, 0.02, -0.85}, {0.25, 0.1, -0.7});
    add_box(frame, {-0.25, 0.02, 0.7}, {0.25, 0.1, 0.85});
    b.solid("screen-frame", frame, f.oak, {}, {}, node);
    for (const double x : {-0.2, 0.18}) {
        b.solid(x < 0 ? "rail-west" : "rail-east",
                box({kRail + x, 0, -2.3}, {kRail + x + 0.02, 0.02, start + travel + 0.9}), f.iron);
    }
}

}  // namespace level_green_screen_parts

SceneData level_green_screen() {
    using namespace level_green_screen_parts;
    Builder b;
    const Finishes f = finishes(b);
    shell(b, f);
    lamp(b, f);
    screen(b, f);
    add_crystal(b, f, "green-crystal", {-kHalf.x, 1.3, -0.75}, {1, 0, 0}, {0.08f, 0.6f, 0.14f},
                R"("filter":[-1.2,1,-0.8])",
                R"("lux":0.2,"seconds":1.5,"symbol":"triangle","glow":[0.8,11,1.6])");
    b.table("table", {-2.0, 0, -2.3}, 1.1, 0.65, 0.78, f.oak, kBoxCollider);
    b.solid("chair", whole(chair_parts()), f.oak, kBoxCollider, at({-2.1, 0, -1.55}));
    add_bookshelf(b, f, "shelf", {-0.1, 0, -2.86}, {1.0, 1.8, 0.35}, 4, 11);
    add_still_life(b, "still-life", {-2.25, 0.78, -2.35});
    // Weak: it is not to be in the way of the green light.
    add_sconce(b, f, "sconce", {0.75, 1.95, -kHalf.z}, {0, 0, 1}, 8);
    add_carpet(b, "carpet", {-2.9, 0, -0.5}, {-0.9, 0.012, 0.9}, kBlueCarpet);
    b.camera("camera", looking({2.9, 1.8, 2.6}, {-1.4, 1.0, -0.7}), glm::radians(65.0f));
    add_player(b, {-1.3, 0, 0.1}, {-1.5, 1.35, -3});
    add_level(b, R"("title":"The green screen",
        "hints":["The lamp shines past all that is green.",
                 "The screen stands on a rail. Walk against its end.",
                 "Push the green screen into the beam: it lights the crystal across the room."],
        "tour":[{"go":[-1.3,0,0.1],"look":[-1.5,1.35,-3],"seconds":1},
                {"go":[-0.4,0,-1.9],"look":[1.3,1.1,-1.2],"seconds":3},
                {"go":[1.3,0,-2.57],"look":[1.3,1.2,0.5],"seconds":2},
                {"go":[1.3,0,-0.3],"look":[1.3,1.2,2.5],"seconds":4},
                {"go":[0.2,0,-1.4],"look":[-3.6,1.3,-0.35],"seconds":4}])");
    b.camera("beam", looking({-3.2, 1.7, -0.9}, {1.3, 1.1, 0.1}), glm::radians(65.0f));
    return b.scene;
}

}  // namespace lanthorn::scene_generator

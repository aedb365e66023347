#include "tools/scene_generator/furniture.h"
#include "tools/scene_generator/hero_figure.h"
#include "tools/scene_generator/level_furnishings.h"
#include "tools/scene_generator/level_parts.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

namespace level_shutter_parts {

constexpr dvec3 kHalf{3.2, 3.2, 2.8};

void shell(Builder& b, const Finishes& f) {
    const double t = kLevelWall;
    const std::uint32_t blue = painted_plaster(b, "blue-plaster", {0.05f, 0.1f, 0.5f});
    add_room(b, f, kHalf, {kNone, blue, f.ashlar, f.ashlar});
    add_wall_with_hole(b, f, "west-wall", f.ashlar, {-kHalf.x - t, 0, -kHalf.z}, {-kHalf.x, kHalf.y, kHalf.z},
                       {-kHalf.x - t, 1.3, -0.6}, {-kHalf.x, 2.6, 0.6}, 2);
    add_mouldings(b, f, {-kHalf.x, 0, -kHalf.z}, kHalf);
    add_beams(b, f, {-kHalf.x, 0, -kHalf.z}, kHalf, true, 4);
    add_pier(b, f, "pier-north", {kHalf.x - 0.2, 0, -kHalf.z + 0.2}, 0.18, kHalf.y - 0.24);
    add_pier(b, f, "pier-south", {kHalf.x - 0.2, 0, kHalf.z - 0.2}, 0.18, kHalf.y - 0.24);
    // So low that it crosses the room.
    add_spot(b, "moon", {-8, 2.95, 0.5}, {kHalf.x, 1.15, -0.5}, kMoonlight, 5000, 9, 12);
}

// A board before the window; it slides along a rail.
void shutter(Builder& b, const Finishes& f) {
    b.solid("shutter", box({0.002, 1.2, -0.7}, {0.05, 2.7, 0.7}), f.oak,
            R"({"shutter":{"way":[0,0,1.5],"seconds":1.4},"body":{"type":"kinematic"}})",
            at({-kHalf.x, 0, 0}));
    b.solid("shutter-rail", box({-kHalf.x + 0.001, 2.71, -0.8}, {-kHalf.x + 0.06, 2.76, 2.3}), f.iron);
}

}  // namespace level_shutter_parts

SceneData level_shutter() {
    using namespace level_shutter_parts;
    Builder b;
    const Finishes f = finishes(b);
    shell(b, f);
    shutter(b, f);
    add_crystal(b, f, "sapphire", {-kHalf.x, 1.45, -1.75}, {1, 0, 0}, {0.08f, 0.16f, 0.75f},
                R"("filter":[-1.5,-0.8,1])",
                R"("lux":0.14,"seconds":1.5,"symbol":"star","glow":[0.9,2.4,18])");
    b.table("table", {0.3, 0, 1.3}, 1.3, 0.7, 0.78, f.oak, kBoxCollider);
    b.solid("chair", whole(chair_parts()), f.oak, kBoxCollider, at({-0.75, 0, 1.75}));
    add_bookshelf(b, f, "shelf", {-0.6, 0, -2.76}, {1.2, 2.0, 0.35}, 5, 12);
    add_carpet(b, "carpet", {-2.4, 0, -1.5}, {-0.4, 0.012, 0.3}, kRedCarpet);
    add_lantern(b, bronze(b), {0.35, 0.78, 1.2}, kLamplight, 40);
    add_follower(b, "puppet", {2.3, 0, -0.9});
    b.camera("camera", looking({2.0, 1.75, 2.5}, {-2.0, 1.2, -0.6}), glm::radians(62.0f));
    add_player(b, {0.7, 0, 0.58}, {-3.2, 1.35, 0.95});
    add_level(b, R"("title":"The shutter",
        "hints":["The moon is out there, and it is blue enough for a blue wall.",
                 "Open the shutter. Then see what light is in the way.",
                 "Put the lantern out: its warm light keeps the sapphire asleep."],
        "tour":[{"go":[0.7,0,0.58],"look":[-3.2,1.35,0.95],"seconds":1},
                {"go":[-1.7,0,0.1],"look":[-3.2,1.6,0],"seconds":2.8,"deed":"use"},
                {"go":[-1.4,0,-0.4],"look":[3.2,1.3,-0.5],"seconds":2.2},
                {"go":[-0.4,0,0.5],"look":[0.35,0.8,1.2],"seconds":1.5,"deed":"light"},
                {"go":[0.4,0,0.1],"look":[-3.2,1.4,-1.2],"seconds":5}])");
    b.camera("blue", looking({-2.7, 1.7, 1.9}, {2.4, 1.2, -0.6}), glm::radians(66.0f));
    return b.scene;
}

}  // namespace lanthorn::scene_generator

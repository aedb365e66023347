#include "tools/scene_generator/furniture.h"
#include "tools/scene_generator/level_furnishings.h"
#include "tools/scene_generator/level_parts.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

namespace level_two_glasses_parts {

constexpr dvec3 kHalf{3.4, 3.7, 3.0};
constexpr double kPier = 2.1;  // metres high, well above a lantern in a hand

void shell(Builder& b, const Finishes& f) {
    const double t = kLevelWall;
    add_room(b, f, kHalf, {f.ashlar, kNone, f.ashlar, f.ashlar});
    add_wall_with_hole(b, f, "east-wall", f.ashlar, {kHalf.x, 0, -kHalf.z}, {kHalf.x + t, kHalf.y, kHalf.z},
                       {kHalf.x, 1.3, -0.6}, {kHalf.x + t, 2.7, 0.6}, 3);
    add_mouldings(b, f, {-kHalf.x, 0, -kHalf.z}, kHalf);
    add_spot(b, "moon", {6.2, 4.6, 0.9}, {1.1, 0, -0.9}, kMoonlight, 1100, 16, 22);
    // A dado of oak all round but where the window is.
    Shape dado;
    add_box(dado, {-kHalf.x, 0.16, -kHalf.z}, {kHalf.x, 1.0, -kHalf.z + 0.04});
    add_box(dado, {-kHalf.x, 0.16, kHalf.z - 0.04}, {kHalf.x, 1.0, kHalf.z});
    add_box(dado, {-kHalf.x, 0.16, -kHalf.z + 0.04}, {-kHalf.x + 0.04, 1.0, kHalf.z - 0.04});
    b.solid("dado", dado, f.oak);
    Shape rail;
    add_box(rail, {-kHalf.x, 1.0, -kHalf.z}, {kHalf.x, 1.06, -kHalf.z + 0.07});
    add_box(rail, {-kHalf.x, 1.0, kHalf.z - 0.07}, {kHalf.x, 1.06, kHalf.z});
    add_box(rail, {-kHalf.x, 1.0, -kHalf.z + 0.07}, {-kHalf.x + 0.07, 1.06, kHalf.z - 0.07});
    b.solid("dado-rail", rail, f.trim);
}

void crystals(Builder& b, const Finishes& f) {
    add_pier(b, f, "pier-west", {-1.7, 0, -1.5}, 0.24, kPier);
    add_crystal(b, f, "ruby", {-1.7, kPier, -1.5}, {0, 1, 0}, {0.75f, 0.08f, 0.06f},
                R"("filter":[1,-1.2,-0.8])",
                R"("lux":1.1,"seconds":1.5,"symbol":"drop","glow":[16,0.7,0.9])");
    add_pier(b, f, "pier-east", {1.2, 0, -1.9}, 0.24, kPier);
    add_crystal(b, f, "sapphire", {1.2, kPier, -1.9}, {0, 1, 0}, {0.08f, 0.16f, 0.75f},
                R"("filter":[-0.3,-0.8,1])",
                R"("lux":0.25,"seconds":1.5,"symbol":"star","glow":[0.9,2.4,18])");
}

}  // namespace level_two_glasses_parts

SceneData level_two_glasses() {
    using namespace level_two_glasses_parts;
    Builder b;
    const Finishes f = finishes(b);
    shell(b, f);
    crystals(b, f);
    b.table("table", {1.25, 0, 0.05}, 1.3, 0.7, 0.78, f.oak, kBoxCollider);
    b.solid("chair", whole(chair_parts()), f.oak, kBoxCollider, at({1.6, 0, 0.75}));
    add_bookshelf(b, f, "shelf", {-2.2, 0, -2.92}, {1.4, 2.0, 0.35}, 5, 13);
    add_carpet(b, "carpet", {-1.2, 0, -0.9}, {1.2, 0.012, 0.6}, kBlueCarpet);
    add_lantern(b, bronze(b), {0.8, 0.78, 0.1}, {1, 0.85f, 0.7f}, 150,
                R"("brightness":2,"slides":[[1,0.06,0.04],[0.02,0.06,1]])");
    b.camera("camera", looking({-0.2, 1.7, 2.8}, {-0.2, 1.6, -1.0}), glm::radians(68.0f));
    add_player(b, {-0.35, 0, 0.35}, {-0.25, 1.55, -1.7});
    add_level(b, R"("title":"Two glasses",
        "hints":["These crystals lie too high for the lantern. The ceiling is white.",
                 "The lantern has a red glass and a blue one.",
                 "Stand well back from a pier, turn the lantern up, and put in the glass of the crystal's colour."],
        "tour":[{"go":[-0.35,0,0.35],"look":[-0.25,1.7,-1.7],"seconds":1.5},
                {"go":[0.05,0,0.6],"look":[0.8,0.9,0.1],"seconds":1.5,"deed":"carry"},
                {"go":[-0.6,0,0.7],"look":[-1.7,2.2,-1.5],"seconds":1,"deed":"brighter"},
                {"go":[-1.0,0,0.5],"look":[-1.7,2.2,-1.5],"seconds":0.5,"deed":"brighter"},
                {"go":[-1.0,0,0.5],"look":[-1.7,2.2,-1.5],"seconds":0.5,"deed":"colour"},
                {"go":[-1.0,0,0.5],"look":[-1.2,2.2,-1.5],"seconds":3.5},
                {"go":[0,0,1.6],"look":[1.2,2.2,-1.9],"seconds":1.5,"deed":"colour"},
                {"go":[0,0,1.8],"look":[0.6,2.2,-1.9],"seconds":4,"deed":"colour"},
                {"go":[0.25,0,0.6],"look":[0.8,1.2,-0.6],"seconds":0.7,"deed":"darker"},
                {"go":[0.25,0,0.05],"look":[2,0.9,0.05],"seconds":0.6,"deed":"darker"},
                {"go":[0.27,0,0.02],"look":[2,0.9,0.02],"seconds":0.6,"deed":"darker"},
                {"go":[0.27,0,0.02],"look":[2,0.9,0.02],"seconds":0.4,"deed":"carry"},
                {"go":[-0.35,0,0.4],"look":[-0.25,1.75,-1.7],"seconds":3.4}])");
    return b.scene;
}

}  // namespace lanthorn::scene_generator

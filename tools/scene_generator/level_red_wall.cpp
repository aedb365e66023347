#include "tools/scene_generator/curtain.h"
#include "tools/scene_generator/level_furnishings.h"
#include "tools/scene_generator/level_parts.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

namespace level_red_wall_parts {

constexpr dvec3 kHalf{3.6, 3.1, 2.8};

void shell(Builder& b, const Finishes& f) {
    const double t = kLevelWall;
    const std::uint32_t red = painted_plaster(b, "red-plaster", {0.55f, 0.06f, 0.04f});
    add_room(b, f, kHalf, {kNone, red, f.ashlar, f.ashlar});
    add_wall_with_hole(b, f, "west-wall", f.ashlar, {-kHalf.x - t, 0, -kHalf.z}, {-kHalf.x, kHalf.y, kHalf.z},
                       {-kHalf.x - t, 1.15, -0.9}, {-kHalf.x, 2.45, 0.3}, 3);
    add_mouldings(b, f, {-kHalf.x, 0, -kHalf.z}, kHalf);
    add_beams(b, f, {-kHalf.x, 0, -kHalf.z}, kHalf, false, 5);
    add_spot(b, "moon", {-6.2, 4.1, -1.4}, {-1.6, 0, 0.35}, kMoonlight, 1600, 16, 22);
}

// Behind it, on the side of the red wall, is the crystal.
void screen_wall(Builder& b, const Finishes& f) {
    b.solid("screen-wall", box({0.75, 0, -1.38}, {1.15, 2.35, 1.38}), f.ashlar, kBoxCollider);
    b.solid("screen-cap", box({0.7, 2.35, -1.38}, {1.2, 2.45, 1.38}), f.trim);
    b.solid("screen-foot", box({0.71, 0, -1.33}, {1.19, 0.14, 1.33}), f.trim);
    // Well proud of the wall: less would be a dashed line.
    add_pier(b, f, "pier-north", {0.95, 0, -1.58}, 0.26, kHalf.y - 0.24);
    add_pier(b, f, "pier-south", {0.95, 0, 1.58}, 0.26, kHalf.y - 0.24);
    add_crystal(b, f, "red-crystal", {1.15, 1.25, 0}, {1, 0, 0}, {0.75f, 0.08f, 0.06f},
                R"("filter":[1,-1.2,-0.8])",
                R"("lux":0.5,"seconds":1.5,"symbol":"drop","glow":[16,0.7,0.9])");
}

// Two wings of violet in the northern passage.
void curtain(Builder& b, const Finishes& f) {
    constexpr double kHalfTurn = 1.5707963267948966, kBeyond = 10;
    const std::uint32_t cloth = curtain_cloth(b, "violet-cloth", {0.34f, 0.13f, 0.42f});
    add_curtain(b, "curtain-north", cloth, {0.95, 2.3, -kHalf.z + 0.02}, -kHalfTurn, 0.46, 2.22, -0.01,
                kBeyond);
    add_curtain(b, "curtain-south", cloth, {0.95, 2.3, -1.84}, kHalfTurn, 0.46, 2.22, -0.01, kBeyond);
    b.solid("curtain-rail", box({0.93, 2.3, -kHalf.z}, {0.97, 2.34, -1.82}), f.iron);
}

void furniture(Builder& b, const Finishes& f) {
    b.table("table", {-0.9, 0, 1.9}, 1.3, 0.7, 0.78, f.oak, kBoxCollider);
    b.solid("bench", box({-2.5, 0.4, -2.5}, {-0.6, 0.46, -2.1}), f.oak, kBoxCollider);
    b.solid("bench-legs", box({-2.4, 0, -2.45}, {-2.3, 0.4, -2.15}), f.oak);
    b.solid("bench-legs-2", box({-0.8, 0, -2.45}, {-0.7, 0.4, -2.15}), f.oak);
    add_bookshelf(b, f, "shelf", {3.0, 0, -2.76}, {1.0, 1.7, 0.35}, 4, 14);
    add_carpet(b, "carpet", {-3.0, 0, -1.4}, {-1.0, 0.012, 0.6}, kBlueCarpet);
}

}  // namespace level_red_wall_parts

SceneData level_red_wall() {
    using namespace level_red_wall_parts;
    Builder b;
    const Finishes f = finishes(b);
    shell(b, f);
    screen_wall(b, f);
    curtain(b, f);
    furniture(b, f);
    add_lantern(b, bronze(b), {-0.45, 0.78, 1.75}, kLamplight, 80);
    b.camera("camera", looking({-2.75, 1.65, 2.35}, {1.2, 1.1, 1.35}), glm::radians(56.0f));
    add_player(b, {-0.95, 0, 1.1}, {3.4, 1.3, 1.0});
    add_level(b, R"("title":"The red wall",
        "hints":["The crystal sleeps behind the stones. It wants red light.",
                 "A red wall makes red light of any light.",
                 "Carry the lantern round, and hold it where it lights the red wall but not the crystal."],
        "tour":[{"go":[-0.95,0,1.1],"look":[3.4,1.3,1.0],"seconds":1.5},
                {"go":[-0.8,0,1.05],"look":[-0.45,0.9,1.75],"seconds":1.5,"deed":"carry"},
                {"go":[0.2,0,1.1],"look":[1.5,1.1,2.3],"seconds":2},
                {"go":[0.2,0,2.3],"look":[3.6,1.1,1.6],"seconds":2.5},
                {"go":[0.5,0,2.3],"look":[3.6,1.1,1.6],"seconds":2,"deed":"carry"},
                {"go":[2.6,0,2.2],"look":[3,1.3,0.5],"seconds":2},
                {"go":[2.9,0,1.6],"look":[1.2,1.2,0],"seconds":2.5},
                {"go":[2.2,0,-2.3],"look":[0.95,1.2,-2.3],"seconds":3.5},
                {"go":[-0.6,0,-2.3],"look":[-2.5,1.3,-1.5],"seconds":3.5},
                {"go":[-1.0,0,-1.2],"look":[0.95,1.2,-2.3],"seconds":1.2}])");
    b.camera("behind", looking({2.9, 1.6, 2.4}, {1.2, 1.2, -0.5}), glm::radians(65.0f));
    return b.scene;
}

}  // namespace lanthorn::scene_generator

#include "tools/scene_generator/furniture.h"
#include "tools/scene_generator/hero_figure.h"
#include "tools/scene_generator/level_furnishings.h"
#include "tools/scene_generator/level_parts.h"
#include "tools/scene_generator/plants.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

namespace level_lamp_bearer_parts {

constexpr dvec3 kHalf{2.8, 3.0, 3.1};
// A tongue of stone comes out of the back wall, with a hook to the west at its end: behind it is the red bay.
constexpr double kTongueWest = -0.15, kTongueEast = 0.15, kTip = -0.5;    // X, X, Z
constexpr double kHookWest = -1.8, kHookBack = -0.8, kHookFront = -0.65;  // X, Z, Z
constexpr double kRed =
    0.1;  // Z to which the west wall is red: all of it that a lantern behind the hook lights

void shell(Builder& b, const Finishes& f) {
    const double t = kLevelWall;
    const std::uint32_t lime = painted_plaster(b, "pale-plaster", {0.66f, 0.63f, 0.58f});
    const std::uint32_t red = painted_stone(b, "red-stone", {0.7f, 0.05f, 0.04f});
    add_room(b, f, kHalf, {kNone, kNone, kNone, lime});
    b.solid("west-wall", box({-kHalf.x - t, 0, kRed}, {-kHalf.x, kHalf.y, kHalf.z}), lime, kBoxCollider);
    b.solid("red-wall", box({-kHalf.x - t, 0, -kHalf.z}, {-kHalf.x, kHalf.y, kRed}), red, kBoxCollider);
    b.solid("red-back", box({-kHalf.x - t, 0, -kHalf.z - t}, {0, kHalf.y, -kHalf.z}), red, kBoxCollider);
    b.solid("back-wall", box({0, 0, -kHalf.z - t}, {kHalf.x + t, kHalf.y, -kHalf.z}), f.ashlar, kBoxCollider);
    add_wall_with_hole(b, f, "east-wall", lime, {kHalf.x, 0, -kHalf.z}, {kHalf.x + t, kHalf.y, kHalf.z},
                       {kHalf.x, 1.3, -1.9}, {kHalf.x + t, 2.5, -0.9}, 3);
    b.solid("tongue", box({0, 0, -kHalf.z}, {kTongueEast, kHalf.y, kTip}), f.ashlar, kBoxCollider);
    b.solid("hook", box({kHookWest, 0, kHookFront}, {0, kHalf.y, kTip}), f.ashlar, kBoxCollider);
    b.solid("bay-east", box({kTongueWest, 0, -kHalf.z}, {0, kHalf.y, kHookBack}), red, kBoxCollider);
    b.solid("bay-front", box({kHookWest, 0, kHookBack}, {0, kHalf.y, kHookFront}), red, kBoxCollider);
    add_mouldings(b, f, {-kHalf.x, 0, -kHalf.z}, kHalf);
    add_beams(b, f, {-kHalf.x, 0, -kHalf.z}, kHalf, true, 5);
    add_spot(b, "moon", {6.0, 4.4, -0.6}, {1.0, 0, -1.6}, kMoonlight, 400, 14, 20);
}

void furniture(Builder& b, const Finishes& f) {
    b.solid("bench", box({0.6, 0.4, 2.55}, {2.4, 0.46, 2.95}), f.oak, kBoxCollider);
    b.solid("bench-legs",
            whole({{"a", {0.7, 0, 2.6}, {0.78, 0.4, 2.9}}, {"b", {2.22, 0, 2.6}, {2.3, 0.4, 2.9}}}), f.oak);
    add_bookshelf(b, f, "shelf", {1.8, 0, -3.06}, {1.2, 1.9, 0.35}, 5, 15);
    add_carpet(b, "carpet", {0.5, 0, 0.6}, {2.3, 0.012, 2.2}, kRedCarpet);
    const Fern plant = fern(b);
    add_fern(b, plant, "fern-west", {-2.3, 0, 2.6}, 1.15, 0.6);
    add_fern(b, plant, "fern-tip", {2.3, 0, 0.2}, 1.0, 2.2);
}

}  // namespace level_lamp_bearer_parts

SceneData level_lamp_bearer() {
    using namespace level_lamp_bearer_parts;
    Builder b;
    const Finishes f = finishes(b, {0.42f, 0.39f, 0.35f});
    shell(b, f);
    add_crystal(b, f, "ruby", {-0.75, 1.3, kTip}, {0, 0, 1}, {0.75f, 0.08f, 0.06f}, R"("filter":[1,-2.7,0])",
                R"("lux":0.3,"seconds":2,"symbol":"drop","glow":[16,0.7,0.9])");
    furniture(b, f);
    add_lamp_bearer(b, "bearer", {-0.25, 0, 0.05}, kLamplight, 260);
    add_contract(b, "hall-is-lit", {0, 0.9, 1.2}, {5.4, 1.8, 3.4}, R"("lower":1,"share":0.7)");
    add_contract(b, "bay-is-dark", {-0.95, 1.2, -1.95}, {1.6, 2.4, 2.2}, R"("upper":3)");
    b.camera("camera", looking({-1.2, 1.7, 1.6}, {-1.05, 1.15, -0.5}), glm::radians(64.0f));
    add_player(b, {0.2, 0, 1.2}, {-2.8, 1.2, 0.7});
    add_level(b, R"("title":"The lamp bearer",
        "hints":["You carry no light here. Somebody else does.",
                 "The puppet comes when it is told to, and waits where it is told to.",
                 "Lead the puppet into the red bay, round the corner, and tell it to wait behind the stones."],
        "tour":[{"go":[0.2,0,1.2],"look":[-2.8,1.2,0.7],"seconds":1.5},
                {"go":[-0.2,0,1.4],"look":[-0.25,0.6,0.05],"seconds":1.5,"deed":"use"},
                {"go":[-2.0,0,0.6],"look":[-2.3,1.2,-2],"seconds":2.2},
                {"go":[-2.3,0,-1.2],"look":[-2,1.2,-3],"seconds":1.8},
                {"go":[-0.6,0,-2.6],"look":[-0.5,1.0,-2.8],"seconds":3},
                {"go":[-0.6,0,-2.6],"look":[-1.4,0.6,-1.7],"seconds":1.5,"deed":"use"},
                {"go":[-2.2,0,-2.4],"look":[-2.3,1.2,-1],"seconds":1.8},
                {"go":[-2.3,0,-0.5],"look":[-2,1.2,2],"seconds":2},
                {"go":[-1.6,0,1.4],"look":[0.5,1.2,1.6],"seconds":2},
                {"go":[0.3,0,1.5],"look":[-1.5,1.3,-0.5],"seconds":5}])");
    b.camera("bay", looking({-2.0, 1.7, 2.2}, {-1.5, 1.0, -2.4}), glm::radians(62.0f));
    return b.scene;
}

}  // namespace lanthorn::scene_generator

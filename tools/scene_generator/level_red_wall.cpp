#include "tools/scene_generator/level_parts.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

namespace {

constexpr double kX = 3.6, kZ = 2.8, kHeight = 3.1;  // half the room, and its height

void shell(Builder& b, const Finishes& f) {
    const double t = kLevelWall, x = kX + t, z = kZ + t;
    const std::uint32_t red = b.matte("red-wall", {0.62f, 0.075f, 0.05f}, 0.5f);
    b.solid("floor", box({-x, -t, -z}, {x, 0, z}), f.flags, kBoxCollider);
    b.solid("ceiling", box({-x, kHeight, -z}, {x, kHeight + t, z}), f.plaster, kBoxCollider);
    b.solid("back-wall", box({-x, 0, -z}, {x, kHeight, -kZ}), f.ashlar, kBoxCollider);
    b.solid("front-wall", box({-x, 0, kZ}, {x, kHeight, z}), f.ashlar, kBoxCollider);
    b.solid("east-wall", box({kX, 0, -kZ}, {x, kHeight, kZ}), red, kBoxCollider);
    add_wall_with_hole(b, f, "west-wall", f.ashlar, {-x, 0, -kZ}, {-kX, kHeight, kZ}, {-x, 1.15, -0.9},
                       {-kX, 2.45, 0.3}, 3);
    add_mouldings(b, f, {-kX, 0, -kZ}, {kX, kHeight, kZ});
    add_beams(b, f, {-kX, 0, -kZ}, {kX, kHeight, kZ}, false, 5);
}

// Behind it, on the side of the red wall, is the crystal.
void screen_wall(Builder& b, const Finishes& f) {
    b.solid("screen-wall", box({0.75, 0, -1.35}, {1.15, 2.35, 1.35}), f.ashlar, kBoxCollider);
    b.solid("screen-cap", box({0.7, 2.35, -1.4}, {1.2, 2.45, 1.4}), f.trim);
    b.solid("screen-foot", box({0.71, 0, -1.39}, {1.19, 0.14, 1.39}), f.trim);
    add_pier(b, f, "pier-north", {0.95, 0, -1.62}, 0.22, kHeight - 0.24);
    add_pier(b, f, "pier-south", {0.95, 0, 1.62}, 0.22, kHeight - 0.24);
    add_crystal(b, f, "red-crystal", {1.15, 1.25, 0}, {1, 0, 0}, {0.75f, 0.08f, 0.06f},
                R"("filter":[1,-1.2,-0.8])", R"("lux":0.5,"seconds":2,"symbol":"drop","glow":[60,5,3])");
}

void furniture(Builder& b, const Finishes& f) {
    b.table("table", {-1.9, 0, 1.9}, 1.3, 0.7, 0.78, f.oak, kBoxCollider);
    b.solid("bench", box({-2.5, 0.4, -2.5}, {-0.6, 0.46, -2.1}), f.oak, kBoxCollider);
    b.solid("bench-legs", box({-2.4, 0, -2.45}, {-2.3, 0.4, -2.15}), f.oak);
    b.solid("bench-legs-2", box({-0.8, 0, -2.45}, {-0.7, 0.4, -2.15}), f.oak);
}

void moonlight(Builder& b) {
    Light moon;
    moon.type = LightType::spot;
    moon.colour = {0.5f, 0.7f, 1};
    moon.intensity = 1600;
    moon.inner_cone = glm::radians(16.0f);
    moon.outer_cone = glm::radians(22.0f);
    b.light("moon", looking({-6.2, 4.1, -1.4}, {-1.6, 0, 0.35}), moon);
}

}  // namespace

SceneData level_red_wall() {
    Builder b;
    const Finishes f = finishes(b);
    shell(b, f);
    screen_wall(b, f);
    furniture(b, f);
    moonlight(b);
    add_lantern(b, f, {-1.75, 0.78, 1.85}, 60);
    add_player(b, {-2.7, 0, 0.9}, {-0.2, 1.3, 0.9});
    add_level(
        b, R"("title":"The red wall","hints":["The crystal sleeps behind the stones. It wants red light.",)"
           R"("A red wall makes red light of any light.",)"
           R"("Carry the lantern round, and hold it where it lights the red wall but not the crystal."])");
    b.camera("camera", looking({-3.2, 1.75, 2.3}, {0.9, 1.1, -0.4}), glm::radians(65.0f));
    b.camera("behind", looking({2.9, 1.6, 2.4}, {1.2, 1.2, -0.5}), glm::radians(65.0f));
    return b.scene;
}

}  // namespace lanthorn::scene_generator

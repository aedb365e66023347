#include <string>

#include "tools/scene_generator/puppet_figure.h"
#include "tools/scene_generator/room.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

namespace crowd_parts {

constexpr int kFiguresARow = 10;
constexpr double kApart = 2.4, kHalf = 13, kHeight = 5;  // metres

void hall(Builder& b) {
    const std::uint32_t white = b.matte("white", {0.72f, 0.71f, 0.68f});
    const std::uint32_t red = b.matte("red", {0.63f, 0.1f, 0.06f});
    const std::uint32_t green = b.matte("green", {0.12f, 0.45f, 0.1f});
    closed_room(b, {-kHalf, 0, -kHalf}, {kHalf, kHeight, kHalf},
                {.floor = {"floor", white},
                 .ceiling = {"ceiling", white},
                 .left = {"red-wall", red},
                 .right = {"green-wall", green},
                 .back = {"back-wall", white},
                 .front = {"front-wall", white}},
                kWallThickness, kBoxCollider);
}

}  // namespace crowd_parts

SceneData crowd() {
    using namespace crowd_parts;
    Builder b;
    hall(b);
    AnimationClip walk;
    walk.name = "walk";
    const PuppetMeshes meshes = add_puppet_meshes(b);
    for (int i = 0; i < kFiguresARow * kFiguresARow; ++i) {
        PuppetWalk round;
        round.centre = {kApart * (i % kFiguresARow - 0.5 * (kFiguresARow - 1)), 0,
                        kApart * (i / kFiguresARow - 0.5 * (kFiguresARow - 1))};
        round.radius = 0.75;
        round.angle = 2.4 * i;  // about the golden angle: no two neighbours walk alike
        round.seconds = 6;
        round.cycles = 6;
        add_puppet(b, "puppet-" + std::to_string(i), meshes, round, walk);
    }
    b.scene.animations.push_back(std::move(walk));
    Light light;
    light.type = LightType::point;
    light.intensity = 900;
    light.colour = {1, 0.86f, 0.68f};
    for (const double x : {-6.0, 6.0}) {
        for (const double z : {-6.0, 6.0}) {
            b.light("lamp", at({x, 4.2, z}), light);
        }
    }
    b.camera("camera", looking({11.5, 3.6, 12.0}, {-1, 0.6, -1}), glm::radians(60.0f));
    return b.scene;
}

}  // namespace lanthorn::scene_generator

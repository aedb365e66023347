#include "tools/scene_generator/puppet_figure.h"
#include "tools/scene_generator/room.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

namespace {

constexpr double kSide = 2.6, kHeight = 2.8;  // of the room inside: 5.2 x 2.8 x 5.2 m

// Four walls of different colours.
void room(Builder& b) {
    const std::uint32_t white = b.matte("white", {0.74f, 0.73f, 0.7f});
    const std::uint32_t red = b.matte("red", {0.63f, 0.07f, 0.05f});
    const std::uint32_t green = b.matte("green", {0.12f, 0.45f, 0.1f});
    const std::uint32_t blue = b.matte("blue", {0.12f, 0.2f, 0.6f});
    closed_room(b, {-kSide, 0, -kSide}, {kSide, kHeight, kSide},
                {.floor = {"floor", white},
                 .ceiling = {"ceiling", white},
                 .left = {"red-wall", red},
                 .right = {"green-wall", green},
                 .back = {"blue-wall", blue},
                 .front = {"white-wall", white}},
                kWallThickness, kBoxCollider);
}

}  // namespace

SceneData glossy_floor() {
    SceneData scene = puppet();
    Material metal = scene.materials.front();
    metal.name = "metal";
    metal.base_colour = vec4(0.8f, 0.78f, 0.75f, 1);
    metal.metallic = 1;
    metal.roughness = 0.42f;
    scene.materials.push_back(metal);
    for (const NodeData& node : scene.nodes) {
        if (node.name == "floor") {
            scene.meshes[node.meshes.front()].material =
                static_cast<std::uint32_t>(scene.materials.size() - 1);
        }
    }
    return scene;
}

SceneData puppet() {
    Builder b;
    room(b);
    const std::uint32_t wood = b.matte("wood", {0.5f, 0.36f, 0.2f});
    b.solid("pedestal", cylinder(0.28, 0.5, 24), wood, {}, at({0, 0, 0}));
    b.solid("ball", icosphere(0.26, 3), b.matte("ball", {0.72f, 0.7f, 0.66f}), {}, at({0, 0.76, 0}));

    AnimationClip walk;
    walk.name = "walk";
    const PuppetMeshes meshes = add_puppet_meshes(b);
    const std::uint32_t hook = add_puppet(b, "puppet", meshes, {}, walk);
    Light light;
    light.type = LightType::point;
    light.colour = {1, 0.72f, 0.42f};
    light.intensity = 60;
    b.light("lantern-light", at({0, -0.18, 0}), light, hook);
    b.scene.animations.push_back(std::move(walk));
    b.camera("camera", looking({2.3, 2.05, 2.4}, {-0.3, 0.75, -0.4}), glm::radians(62.0f));
    return b.scene;
}

}  // namespace lanthorn::scene_generator

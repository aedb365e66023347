#include "engine/scene/declare_components.h"

#include <gtest/gtest.h>

#include "lanthorn/ecs/component_json.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/light_sensor.h"
#include "lanthorn/scene/spawn.h"

namespace lanthorn {
namespace {

TEST(DeclareSceneComponents, EverySpawnedComponentIsDeclared) {
    ecs::Registry registry;
    declare_scene_components(registry);
    ecs::World world;
    SceneData scene;
    scene.nodes.resize(2);
    scene.nodes[0].name = "root";
    scene.nodes[0].extras = "{}";
    scene.nodes[0].shear[1][0] = 0.5f;
    scene.nodes[0].camera = scene.nodes[0].light = scene.nodes[0].sky = 0;
    scene.cameras.resize(1);
    scene.lights.resize(1);
    scene.skies.resize(1);
    scene.nodes[1].parent = 0;
    scene.nodes[1].meshes = {0};
    scene.nodes[1].skin = 0;
    scene.skins.resize(1);
    scene.skins[0].joints = {0};
    scene.skins[0].inverse_binds = {mat4(1)};
    scene.meshes.resize(1);
    scene.meshes[0].morphs.resize(1);
    scene.materials.resize(1);
    scene.animations.resize(1);
    spawn(world, scene);
    for (const auto& table : world.archetypes()) {
        for (const ecs::ComponentInfo* info : table->components()) {
            EXPECT_NE(registry.find(info->id), nullptr) << info->name;
        }
    }
}

TEST(DeclareSceneComponents, StandingOfEach) {
    ecs::Registry registry;
    declare_scene_components(registry);
    EXPECT_TRUE(registry.find<WorldTransform>()->transient);
    EXPECT_FALSE(registry.find<LocalTransform>()->transient);
    EXPECT_TRUE(registry.find<MeshInstances>()->opaque);
    EXPECT_FALSE(registry.find<LightComponent>()->in_extras);
    EXPECT_TRUE(registry.find<LightSensor>()->in_extras);
}

TEST(DeclareSceneComponents, ATransformsFieldsStandInItsObject) {
    ecs::Registry registry;
    declare_scene_components(registry);
    ecs::World world;
    const ecs::Entity e = world.create(LocalTransform{}, LightComponent{});
    EXPECT_EQ(ecs::get_json(registry, world, e, "local_transform"),
              R"({"translation":[0.0,0.0,0.0],"rotation":[0.0,0.0,0.0,1.0],"scale":[1.0,1.0,1.0]})");
    ecs::set_json(registry, world, e, "local_transform", R"({"translation": [1, 2, 3]})");
    EXPECT_EQ(world.get<LocalTransform>(e).value.translation, dvec3(1, 2, 3));
    ecs::set_json(registry, world, e, "light.type", R"("spot")");
    EXPECT_EQ(world.get<LightComponent>(e).light.type, LightType::spot);
    EXPECT_EQ(ecs::get_json(registry, world, e, "light.range"), "\"inf\"");
}

}  // namespace
}  // namespace lanthorn

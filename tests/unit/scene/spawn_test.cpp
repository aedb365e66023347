#include "lanthorn/scene/spawn.h"

#include <gtest/gtest.h>

#include "engine/scene/declare_components.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/ecs/registry.h"
#include "lanthorn/ecs/snapshot.h"
#include "tests/unit/scene/scenes.h"

namespace lanthorn {
namespace {

using namespace scene_test;

TEST(Spawn, MakesOneEntityANodeWithItsComponents) {
    SceneData scene = room();
    scene.nodes[2].extras = "{\"bounce\": 1}";
    scene.nodes[2].shear[1][0] = 0.5f;
    ecs::World world;
    const std::vector<ecs::Entity> e = spawn(world, scene);
    ASSERT_EQ(e.size(), 3u);
    EXPECT_EQ(world.get<Name>(e[1]).value, "lamp");
    EXPECT_EQ(world.get<Parent>(e[1]).entity, e[0]);
    EXPECT_FALSE(world.has<Parent>(e[0]));
    EXPECT_EQ(dvec3(world.get<WorldTransform>(e[1]).matrix[3]), dvec3(10, 2, 0));
    EXPECT_EQ(world.get<MeshInstances>(e[0]).meshes, (std::vector<MeshHandle>{{0, 0}}));
    EXPECT_TRUE(world.has<LightComponent>(e[1]));
    EXPECT_TRUE(world.has<CameraComponent>(e[1]));
    EXPECT_EQ(world.get<Extras>(e[2]).json, "{\"bounce\": 1}");
    EXPECT_TRUE(world.has<Shear>(e[2]));
    EXPECT_FALSE(world.has<Shear>(e[0]));
    EXPECT_EQ(world.get<WorldTransform>(e[2]).matrix[1][0], 0.5);
    EXPECT_EQ(world.resource<AssetStore>().assets().meshes.size(), 1u);
    const SceneHandle file = world.get<Source>(e[1]).scene;
    EXPECT_EQ(world.get<Source>(e[1]).node, 1u);
    EXPECT_EQ(world.resource<AssetStore>().get(file).nodes[1].name, "lamp");
    EXPECT_EQ(find_by_name(world, "ball"), e[2]);
    EXPECT_EQ(find_by_name(world, "nobody"), ecs::kNullEntity);
    EXPECT_EQ(scene.meshes.size(), 1u);  // copied
}

// Failed when every spawn copied all assets.
TEST(Spawn, TheSameSceneAgainSharesEverything) {
    SceneData scene = room();
    scene.source = "room.glb";
    scene.animations.resize(1);
    ecs::World world;
    const std::vector<ecs::Entity> first = spawn(world, scene);
    const auto before = world.resource<AssetStore>().snapshot();
    const std::vector<ecs::Entity> second = spawn(world, scene);
    EXPECT_EQ(world.resource<AssetStore>().snapshot(), before);
    EXPECT_EQ(world.get<MeshInstances>(second[0]).meshes, world.get<MeshInstances>(first[0]).meshes);
    EXPECT_EQ(world.get<Source>(second[2]), world.get<Source>(first[2]));
    std::vector<const void*> clips;
    world.query<ecs::Read<AnimationSet>>().each(
        [&](const AnimationSet& set) { clips.push_back(set.clips.get()); });
    ASSERT_EQ(clips.size(), 2u);
    EXPECT_EQ(clips[0], clips[1]);
}

SceneData room_of_a_file() {
    SceneData scene = room();
    scene.source = "room.glb";
    scene.file.nodes = {7, 4, kNone};
    scene.file.cameras = {0};
    scene.file.lights = {2};
    scene.file.materials = {5};
    scene.file.meshes = {{3, 1}};
    return scene;
}

TEST(FilePlace, OfEntitiesAndBack) {
    ecs::World world;
    const std::vector<ecs::Entity> e = spawn(world, room_of_a_file());
    const SceneHandle scene = world.get<Source>(e[0]).scene;
    EXPECT_EQ(file_place(world, e[0]).source, "room.glb");
    EXPECT_EQ(file_place(world, e[0]).node, 7u);
    EXPECT_EQ(file_place(world, e[0]).meshes, (std::vector<FileMap::Primitive>{{3, 1}}));
    EXPECT_EQ(file_place(world, e[1]).light, 2u);
    EXPECT_EQ(file_place(world, e[1]).camera, 0u);
    EXPECT_EQ(file_place(world, e[2]).node, kNone);
    EXPECT_EQ(file_place(world, world.create()).source, "");
    EXPECT_EQ(entities_at(world, scene, &FilePlace::node, 4), std::vector{e[1]});
    EXPECT_EQ(entities_at(world, scene, &FilePlace::light, 2), std::vector{e[1]});
    EXPECT_TRUE(entities_at(world, scene, &FilePlace::node, kNone).empty());
    const SceneAsset& asset = asset_store(world).get(scene);
    EXPECT_EQ(file_index(asset, material_at(asset, 5)), 5u);
    EXPECT_FALSE(material_at(asset, 0));
    EXPECT_EQ(file_index(asset, MaterialHandle()), kNone);
    const std::vector<ecs::Entity> again = spawn(world, scene);
    EXPECT_EQ(entities_at(world, scene, &FilePlace::node, 7), (std::vector{e[0], again[0]}));
}

TEST(FilePlace, IsKeptBySnapshots) {
    ecs::Registry registry;
    declare_scene_components(registry);
    ecs::World world;
    const std::vector<ecs::Entity> e = spawn(world, room_of_a_file());
    const ecs::Snapshot before = ecs::Snapshot::save(world, registry);
    world.destroy(e[1]);
    before.restore(world);
    EXPECT_EQ(file_place(world, e[1]).node, 4u);
    ecs::Snapshot::from_bytes(before.to_bytes(), registry, "test").restore(world);
    EXPECT_EQ(file_place(world, e[1]).node, 4u);
}

// A file saved again with its nodes in another order is another scene.
TEST(FilePlace, AnotherMapIsAnotherScene) {
    ecs::World world;
    SceneData scene = room_of_a_file();
    const SceneHandle first = asset_store(world).add(scene);
    scene.file.nodes = {4, 7, kNone};
    EXPECT_NE(asset_store(world).add(scene), first);
}

TEST(Spawn, AnotherSceneJoinsTheFirst) {
    SceneData scene = room();
    scene.images.resize(1);
    scene.textures.resize(1);
    scene.materials[0].emissive_texture.texture = 0;
    ecs::World world;
    spawn(world, scene);
    const auto before = world.resource<AssetStore>().snapshot();
    scene.materials[0].metallic = 0;
    const std::vector<ecs::Entity> second = spawn(world, scene);
    const auto now = world.resource<AssetStore>().snapshot();
    const SceneAssets& assets = *now;
    EXPECT_NE(before->serial, assets.serial);
    EXPECT_EQ(before->meshes.size(), 1u);
    ASSERT_EQ(assets.meshes.size(), 2u);
    EXPECT_EQ(assets.meshes.version(0), before->meshes.version(0));
    EXPECT_EQ(world.get<MeshInstances>(second[0]).meshes, (std::vector<MeshHandle>{{1, 0}}));
    EXPECT_EQ(assets.meshes[1].material, 1u);
    EXPECT_EQ(assets.materials[1].emissive_texture.texture, 1u);
    EXPECT_FALSE(assets.materials[1].normal_texture.present());
    EXPECT_EQ(assets.textures[1].image, 1u);
}

// The joints come after the mesh's node and still are found.
TEST(Spawn, SkinsMorphTargetsAndAnimationsFindTheirEntities) {
    SceneData scene = room();
    scene.skins = {{"rig", {2, 1}, {mat4(2), mat4(3)}}};
    scene.nodes[0].skin = 0;
    scene.meshes[0].morphs.resize(2);
    scene.meshes[0].morph_weights = {0.25f, 0.5f};
    scene.nodes[2].meshes = {0};
    scene.nodes[2].morph_weights = {1, 0};
    scene.animations.resize(1);
    scene.animations[0].name = "walk";
    ecs::World world;
    const std::vector<ecs::Entity> e = spawn(world, scene);
    ASSERT_EQ(e.size(), 3u);
    const auto& skin = world.get<SkinInstance>(e[0]);
    EXPECT_EQ(skin.joints, (std::vector<ecs::Entity>{e[2], e[1]}));
    EXPECT_EQ(skin.inverse_binds, (std::vector<mat4>{mat4(2), mat4(3)}));
    EXPECT_FALSE(world.has<SkinInstance>(e[1]));
    EXPECT_EQ(world.get<MorphWeights>(e[0]).weights, (std::vector<float>{0.25f, 0.5f}));
    EXPECT_EQ(world.get<MorphWeights>(e[2]).weights, (std::vector<float>{1, 0}));
    EXPECT_FALSE(world.has<MorphWeights>(e[1]));
    std::size_t sets = 0;
    world.query<ecs::Read<AnimationSet>>().each([&](ecs::Entity holder, const AnimationSet& set) {
        ++sets;
        EXPECT_EQ(holder, e[0]);
        EXPECT_EQ(set.clips->at(0).name, "walk");
        EXPECT_EQ(set.nodes, e);
    });
    EXPECT_EQ(sets, 1u);
}

// Two roots, the second with a child that a clip moves.
SceneData figure() {
    SceneData scene;
    scene.nodes.resize(3);
    scene.nodes[2].parent = 1;
    AnimationChannel& channel = scene.animations.emplace_back().channels.emplace_back();
    channel.node = 2;
    channel.times = {0};
    channel.values = {1, 2, 3};
    return scene;
}

TEST(Spawn, ClipsAreOnTheFirstRootThatTheyMoveAndGoWithIt) {
    ecs::World world;
    const std::vector<ecs::Entity> one = spawn(world, figure());
    const std::vector<ecs::Entity> two = spawn(world, figure());
    EXPECT_EQ((world.query<ecs::With<AnimationSet>>().entities()), (std::vector{one[1], two[1]}));
    EXPECT_EQ(world.size(), 6u);
    destroy_tree(world, one[0]);
    destroy_tree(world, one[1]);
    EXPECT_EQ((world.query<ecs::With<AnimationSet>>().entities()), std::vector{two[1]});
    EXPECT_EQ(world.size(), 3u);
}

TEST(Spawn, DestroyTreeTakesTheChildrenAlong) {
    ecs::World world;
    const std::vector<ecs::Entity> e = spawn(world, room());
    destroy_tree(world, e[0]);
    EXPECT_FALSE(world.alive(e[0]));
    EXPECT_FALSE(world.alive(e[1]));
    EXPECT_TRUE(world.alive(e[2]));
    EXPECT_THROW(destroy_tree(world, e[0]), ecs::Error);
}

}  // namespace
}  // namespace lanthorn

// Assets go with the last entity that shows them, and neither sooner nor later.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene/declare_components.h"
#include "lanthorn/core/error.h"
#include "lanthorn/ecs/clone.h"
#include "lanthorn/ecs/commands.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/ecs/snapshot.h"
#include "lanthorn/scene/asset_store.h"
#include "lanthorn/scene/spawn.h"
#include "tests/unit/scene/scenes.h"

namespace lanthorn {
namespace {

using namespace scene_test;
using ecs::Entity;

template <class Do>
std::string error_of(const Do& act) {
    try {
        act();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

std::size_t slots(const AssetStore& store) {
    const SceneAssets& assets = store.assets();
    return assets.meshes.size() + assets.materials.size() + assets.textures.size() + assets.images.size();
}

// A room whose material shows an image.
SceneData painted_room() {
    SceneData scene = room();
    scene.source = "room.glb";
    scene.images.push_back({"grey", 1, 1, {128, 128, 128, 255}});
    scene.textures.resize(1);
    scene.materials[0].base_colour_texture.texture = 0;
    return scene;
}

struct AssetLifetime : testing::Test {
    ecs::World world;
    std::vector<Entity> room = spawn(world, painted_room());
    AssetStore& store = asset_store(world);
    SceneHandle scene = world.get<Source>(room[0]).scene;
    MeshHandle mesh = world.get<MeshInstances>(room[0]).meshes.at(0);
    MaterialHandle material = store.material_of(mesh);
    ImageHandle image = store.get(scene).images.at(0);

    bool anything_left() const {
        return store.alive(scene) || store.alive(mesh) || store.alive(material) || store.alive(image);
    }
};

TEST_F(AssetLifetime, EverythingGoesWithTheLastEntity) {
    EXPECT_EQ(store.references(scene), 3u);
    EXPECT_EQ(store.references(mesh), 3u) << "two nodes show it, and it is in the scene";
    destroy_tree(world, room[0]);
    EXPECT_EQ(store.references(scene), 1u);
    EXPECT_TRUE(store.alive(scene) && store.alive(mesh) && store.alive(image));
    const auto frame = store.snapshot();
    world.destroy(room[2]);
    EXPECT_FALSE(anything_left());
    EXPECT_EQ(frame->images[image.slot].name, "grey") << "a frame under way keeps what it shows";
}

TEST_F(AssetLifetime, ClearingTheWorldReleasesAll) {
    world.clear();
    EXPECT_FALSE(anything_left());
}

// Without a file: what is shown by hand.
TEST_F(AssetLifetime, RemovingAndReplacingLetGo) {
    Mesh box = cube();
    box.material = store.add(Material()).slot;
    const MeshHandle one = store.add(box), two = store.add(box);
    const MaterialHandle paint = store.material_of(one);
    const Entity e = world.create(MeshInstances{{one}});
    EXPECT_EQ(store.references(one), 1u);
    world.insert(e, MeshInstances{{one, two}});
    EXPECT_TRUE(store.references(one) == 1 && store.references(two) == 1);
    world.insert(e, MeshInstances{{two, two}});
    EXPECT_FALSE(store.alive(one));
    EXPECT_EQ(store.references(two), 2u);
    world.insert(e, MeshInstances(world.get<MeshInstances>(e)));
    EXPECT_EQ(store.references(two), 2u) << "the same again";
    ecs::Commands commands(world);
    commands.remove<MeshInstances>(e);
    EXPECT_TRUE(store.alive(two));
    commands.apply();
    EXPECT_FALSE(store.alive(two) || store.alive(paint));
    world.remove<Source>(room[0]);
    EXPECT_EQ(store.references(scene), 2u);
}

TEST_F(AssetLifetime, SpawningAThousandTimesDoesNotGrowTheStore) {
    for (const Entity e : {room[0], room[2]}) {
        destroy_tree(world, e);
    }
    const std::size_t before = slots(store);
    for (int i = 0; i < 1000; ++i) {
        SceneData other = painted_room();
        other.nodes[0].name = std::to_string(i % 7);
        for (const Entity e : spawn(world, std::move(other))) {
            world.destroy(e);
        }
    }
    EXPECT_EQ(slots(store), before);
    EXPECT_EQ(world.size(), 0u);
    const std::vector<Entity> last = spawn(world, painted_room());
    EXPECT_EQ(world.get<Source>(last[0]).scene.slot, scene.slot);
    EXPECT_NE(world.get<Source>(last[0]).scene, scene);
}

TEST_F(AssetLifetime, ASceneThatIsHeldStays) {
    std::optional<AssetHold<SceneAsset>> held = store.hold(scene);
    AssetHold<SceneAsset> moved = *std::move(held);
    world.clear();
    held.reset();
    EXPECT_EQ(moved.asset(), scene);
    EXPECT_EQ(store.references(scene), 1u);
    EXPECT_EQ(spawn(world, scene).size(), 3u);
    moved = {};
    EXPECT_TRUE(store.alive(scene));
    world.clear();
    EXPECT_FALSE(anything_left());
}

TEST_F(AssetLifetime, TheHandleOfWhatIsGoneIsOneLine) {
    world.clear();
    EXPECT_EQ(error_of([&] { spawn(world, scene); }),
              "scene 0 of generation 0 is not in the store: it has been released; expected the handle of an "
              "asset that somebody refers to");
    EXPECT_EQ(error_of([&] { world.create(MeshInstances{{mesh}}); }),
              "mesh_instances of a new entity: mesh 0 of generation 0 is not in the store: it has been "
              "released; expected the handle of an asset that somebody refers to");
    const Entity e = world.create(Name{"ball"});
    EXPECT_EQ(error_of([&] {
                  world.add(e, Source{scene, 0});
              }),
              "source of entity 0v2 'ball': scene 0 of generation 0 is not in the store: it has been "
              "released; expected "
              "the handle of an asset that somebody refers to");
    EXPECT_FALSE(world.has<Source>(e));
    ecs::World empty;
    EXPECT_EQ(error_of([&] { empty.create(MeshInstances{{mesh}}); }),
              "mesh_instances of a new entity: the world has no AssetStore, expected a handle of its assets");
    empty.create(MeshInstances{});
    empty.create(Source{});
}

TEST_F(AssetLifetime, AnotherWorldsCopiesAreRefused) {
    ecs::Registry registry;
    declare_scene_components(registry);
    ecs::World other;
    spawn(other, painted_room());
    EXPECT_NE(error_of([&] {
                  ecs::clone_from(other, world, registry, std::vector{room[0]});
              }).find("a handle of another world's AssetStore"),
              std::string::npos);
}

TEST_F(AssetLifetime, AHoldOutlivesTheWorld) {
    AssetHold<Mesh> hold;
    {
        ecs::World shorter;
        const Entity e = spawn(shorter, painted_room())[0];
        hold = asset_store(shorter).hold(shorter.get<MeshInstances>(e).meshes[0]);
        EXPECT_TRUE(asset_store(shorter).holds(hold));
    }
    EXPECT_FALSE(store.holds(hold));
}

enum class Step { clone, save, restore, restore_bytes, destroy, forget };

// Every order of copying, going back and destroying: what is referred to is what entities and snapshots have.
TEST(AssetCounts, HoldInEveryOrder) {
    ecs::Registry registry;
    declare_scene_components(registry);
    std::vector<Step> order{Step::clone,         Step::save,    Step::restore,
                            Step::restore_bytes, Step::destroy, Step::forget};
    std::size_t gone = 0;
    do {
        ecs::World world;
        spawn(world, painted_room());
        AssetStore& store = asset_store(world);
        const auto shown = world.query<ecs::With<MeshInstances>>().entities();
        const SceneHandle scene = world.get<Source>(shown[0]).scene;
        const MeshHandle mesh = world.get<MeshInstances>(shown[0]).meshes[0];
        std::optional<ecs::Snapshot> saved;
        std::size_t saved_sources = 0, saved_meshes = 0;
        std::string bytes = ecs::Snapshot::save(world, registry).to_bytes();
        for (const Step step : order) {
            const auto all = world.query<ecs::With<Source>>().entities();
            switch (step) {
                case Step::clone:
                    ecs::clone(world, registry, all);
                    break;
                case Step::save:
                    saved.emplace(ecs::Snapshot::save(world, registry));
                    saved_sources = all.size();
                    saved_meshes = world.query<ecs::With<MeshInstances>>().count();
                    break;
                case Step::restore:
                    if (saved) {
                        saved->restore(world);
                    }
                    break;
                case Step::restore_bytes:
                    ecs::Snapshot::from_bytes(bytes, registry, "bytes").restore(world);
                    break;
                case Step::destroy:
                    for (const Entity e : all) {
                        world.destroy(e);
                    }
                    break;
                case Step::forget:
                    saved.reset();
                    saved_sources = saved_meshes = 0;
                    break;
            }
            const std::size_t sources = world.query<ecs::With<Source>>().count() + saved_sources;
            const std::size_t meshes = world.query<ecs::With<MeshInstances>>().count() + saved_meshes;
            ASSERT_EQ(store.alive(scene), sources > 0);
            ASSERT_EQ(store.alive(mesh), sources + meshes > 0);
            if (sources > 0) {
                ASSERT_EQ(store.references(scene), sources);
                ASSERT_EQ(store.references(mesh), meshes + 1);
            }
            gone += sources == 0 ? 1 : 0;
        }
    } while (std::next_permutation(order.begin(), order.end()));
    EXPECT_GT(gone, 100u);
}

}  // namespace
}  // namespace lanthorn

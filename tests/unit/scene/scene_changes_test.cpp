// Two snapshots of a scene, any number of frames apart.
#include "engine/scene/scene_changes.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "lanthorn/scene/scene_data.h"

namespace lanthorn {
namespace {

Instance thing(std::uint32_t id, std::uint32_t mesh = 0, std::uint32_t generation = 0) {
    Instance instance;
    instance.id = id;
    instance.mesh = mesh;
    instance.generation = generation;
    const float x = static_cast<float>(10 * id + mesh);
    instance.transform = glm::translate(mat4(1), vec3(x, 0, 0));
    instance.bounds = {vec3(x, 0, 0), vec3(x + 1, 1, 1)};
    return instance;
}

FrameScene scene_of(std::vector<Instance> instances) {
    static const auto assets = [] {
        auto some = std::make_shared<SceneAssets>();
        some->materials.emplace_back();
        some->meshes.emplace_back();
        some->meshes.emplace_back();
        return some;
    }();
    FrameScene scene;
    scene.assets = assets;
    scene.instances = std::move(instances);
    for (const Instance& instance : scene.instances) {
        scene.bounds.add(instance.bounds);
    }
    return scene;
}

SceneChanges between(const FrameScene& before, const FrameScene& now) {
    return changes_between(before, now, earlier_instances(before.instances, now.instances));
}

using Indices = std::vector<std::uint32_t>;

TEST(SceneChanges, PairInstancesOfOneEntityAndMesh) {
    const std::vector<Instance> before{thing(1), thing(2, 0), thing(2, 1), thing(2, 1), thing(5)};
    const std::vector<Instance> now{thing(0),    thing(2, 0),    thing(2, 1),
                                    thing(2, 1), thing(5, 0, 1), thing(7)};
    EXPECT_EQ(earlier_instances(before, now), (Indices{kNone, 1, 2, 3, kNone, kNone}));
    EXPECT_EQ(earlier_instances({}, now), Indices(now.size(), kNone));
    EXPECT_TRUE(earlier_instances(before, {}).empty());
}

TEST(SceneChanges, AreNoneBetweenEqualScenes) {
    const FrameScene scene = scene_of({thing(1), thing(2)});
    const SceneChanges changes = between(scene, scene);
    EXPECT_TRUE(changes.nothing());
    EXPECT_FALSE(changes.assets || changes.camera || changes.replaced);
    EXPECT_TRUE(changes.moved.empty() && changes.dirty.empty());
}

TEST(SceneChanges, HaveWhatCameWhatMovedAndWhatLeft) {
    const FrameScene before = scene_of({thing(1), thing(2), thing(3), thing(4)});
    FrameScene now = scene_of({thing(2), thing(3, 0, 1), thing(4), thing(6)});
    now.instances[2].version = 1;
    const SceneChanges changes = between(before, now);
    EXPECT_EQ(changes.moved, (Indices{1, 2, 3}));
    EXPECT_EQ(changes.arrived, (Indices{1, 3}));
    EXPECT_FALSE(changes.replaced);
    EXPECT_EQ(changes.dirty, (Aabb{vec3(10, 0, 0), vec3(61, 1, 1)})) << "from the one that left on";
}

// In its own render space, what was elsewhere is all moved.
TEST(SceneChanges, HaveAllOfASceneWhoseOriginMoved) {
    const FrameScene before = scene_of({thing(1), thing(2)});
    FrameScene now = before;
    now.origin = dvec3(100, 0, 0);
    const SceneChanges changes = between(before, now);
    EXPECT_EQ(changes.moved, (Indices{0, 1}));
    EXPECT_TRUE(changes.lights && changes.camera && changes.arrived.empty());
    EXPECT_EQ(changes.dirty.lower.x, 10 - 100);
    EXPECT_EQ(changes.dirty.upper.x, 21);
}

TEST(SceneChanges, OfAFirstSceneAreAll) {
    const SceneChanges changes = all_changed(scene_of({thing(1), thing(2)}));
    EXPECT_EQ(changes.arrived, (Indices{0, 1}));
    EXPECT_EQ(changes.moved, changes.arrived);
    EXPECT_EQ(changes.meshes, (Indices{0, 1}));
    EXPECT_EQ(changes.materials, (Indices{0}));
    EXPECT_EQ(changes.dirty, (Aabb{vec3(10, 0, 0), vec3(21, 1, 1)}));
    EXPECT_TRUE(changes.assets && changes.geometry && changes.lights && changes.camera && changes.replaced);
}

}  // namespace
}  // namespace lanthorn

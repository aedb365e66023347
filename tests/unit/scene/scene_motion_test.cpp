// What the comparison of two looks at a scene says of what came, moved, rested and left.
#include "lanthorn/scene/scene_motion.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace lanthorn {
namespace {

Aabb box_at(float x) {
    return {vec3(x, 0, 0), vec3(x + 0.5f, 1, 1)};
}

class SceneMotionTest : public ::testing::Test {
  protected:
    SceneMotionTest() {
        auto assets = std::make_shared<SceneAssets>();
        assets->materials.emplace_back();
        assets->meshes.emplace_back();
        scene.assets = assets;
        for (std::uint32_t id = 0; id < 3; ++id) {
            Instance instance;
            instance.id = id;
            instance.bounds = box_at(static_cast<float>(id));
            scene.instances.push_back(instance);
        }
        motion.compare(scene);
    }
    void place(std::size_t i, float x) {
        scene.instances[i].transform = glm::translate(mat4(1), vec3(x, 0, 0));
        scene.instances[i].bounds = box_at(x);
    }
    void compare() {
        ++scene.frame;
        motion.compare(scene);
    }
    SceneMotion::Seen seen_at(float x) const {
        const vec3 point(x + 0.25f, 0.5f, 0.5f);
        return motion.seen([&](const Aabb& box) {
            return glm::all(glm::lessThanEqual(box.lower, point)) &&
                   glm::all(glm::lessThanEqual(point, box.upper));
        });
    }
    FrameScene scene;
    SceneMotion motion;
};

TEST_F(SceneMotionTest, FirstEverythingStandsStill) {
    EXPECT_TRUE(motion.restarted());
    EXPECT_FALSE(motion.any_moving());
    compare();
    EXPECT_FALSE(motion.restarted());
    EXPECT_FALSE(motion.changed());
}

TEST_F(SceneMotionTest, AMoverLeavesOnceAndRestsOnce) {
    place(1, 5);
    compare();
    EXPECT_TRUE(motion.changed());
    EXPECT_TRUE(seen_at(1).left);
    EXPECT_TRUE(seen_at(5).moving);
    EXPECT_FALSE(seen_at(0).left || seen_at(0).moving || seen_at(0).rested);
    place(1, 6);
    compare();
    EXPECT_TRUE(motion.changed());
    EXPECT_FALSE(seen_at(5).left) << "nothing stood still there";
    EXPECT_TRUE(seen_at(6).moving);
    compare();
    EXPECT_FALSE(motion.changed());
    EXPECT_TRUE(motion.moving(1)) << "until it is static";
    scene.instances[1].is_static = true;
    compare();
    EXPECT_FALSE(motion.changed());
    EXPECT_FALSE(motion.any_moving());
    EXPECT_TRUE(motion.rested(1));
    EXPECT_TRUE(seen_at(6).rested);
    scene.changes.geometry = scene.changes.assets = false;
    compare();
    EXPECT_FALSE(motion.rested(1) || seen_at(6).rested);
}

TEST_F(SceneMotionTest, WhatIsDeformedMoves) {
    scene.instances[2].version = 4;
    compare();
    EXPECT_TRUE(seen_at(2).left && seen_at(2).moving);
}

TEST_F(SceneMotionTest, WhatComesMovesAndWhatGoesHasLeft) {
    Instance more;
    more.id = 9;
    more.bounds = box_at(8);
    scene.instances.push_back(more);
    scene.instances.erase(scene.instances.begin());
    compare();
    EXPECT_TRUE(motion.changed());
    EXPECT_TRUE(seen_at(0).left);
    EXPECT_TRUE(seen_at(8).moving);
    EXPECT_TRUE(motion.moving(2) && !motion.moving(0));
    scene.instances.pop_back();
    compare();
    EXPECT_TRUE(motion.changed());
    EXPECT_FALSE(seen_at(8).left || motion.any_moving());
}

TEST_F(SceneMotionTest, ASkippedFrameIsComparedWhateverItSaysOfChanges) {
    place(0, 4);
    scene.changes = {};
    scene.changes.geometry = scene.changes.assets = false;
    scene.frame += 2;
    motion.compare(scene);
    EXPECT_TRUE(seen_at(0).left && seen_at(4).moving);
}

TEST_F(SceneMotionTest, AnotherSceneOrAnotherOriginStartsAgain) {
    place(0, 4);
    compare();
    scene.origin = dvec3(100, 0, 0);
    compare();
    EXPECT_TRUE(motion.restarted() && motion.changed());
    EXPECT_FALSE(motion.any_moving());
    for (Instance& instance : scene.instances) {
        instance.id += 10;
    }
    compare();
    EXPECT_TRUE(motion.restarted());
    EXPECT_FALSE(motion.any_moving());
}

// Every change of assets started again.
TEST_F(SceneMotionTest, OtherAssetsTouchWhatShowsThem) {
    auto assets = std::make_shared<SceneAssets>(*scene.assets);
    assets->serial = next_asset_version();
    assets->materials.emplace_back();
    Mesh other;
    other.material = 1;
    assets->meshes.push_back(other);
    scene.assets = assets;
    compare();
    EXPECT_FALSE(motion.restarted() || motion.changed()) << "nothing shows them yet";
    scene.instances[2].mesh = 1;
    compare();
    EXPECT_TRUE(motion.moving(2) && !motion.moving(0)) << "another mesh is another shape";
}

TEST_F(SceneMotionTest, AnotherPatternPaintsAnotherSurfaceMoves) {
    const auto edit = [&](const auto& version) {
        auto assets = std::make_shared<SceneAssets>(*scene.assets);
        assets->serial = next_asset_version();
        assets->materials.put(0, assets->materials.shared(0), version(assets->materials.version(0)));
        scene.assets = assets;
        compare();
    };
    using Version = AssetVersion<Material>;
    edit([](Version v) {
        v.any = v.albedo = next_asset_version();
        return v;
    });
    EXPECT_FALSE(motion.changed() || seen_at(1).painted) << "another factor of the base colour";
    edit([](Version v) {
        v.any = v.albedo = v.pattern = next_asset_version();
        return v;
    });
    EXPECT_TRUE(motion.changed() && seen_at(1).painted);
    EXPECT_FALSE(seen_at(1).left || motion.any_moving() || motion.restarted());
    compare();
    EXPECT_FALSE(motion.changed() || seen_at(1).painted);
    edit([](Version v) {
        v.any = v.emission = next_asset_version();
        return v;
    });
    EXPECT_FALSE(motion.changed());
    edit([](Version v) {
        v.any = v.surface = next_asset_version();
        return v;
    });
    EXPECT_TRUE(motion.any_moving() && seen_at(1).left);
}

}  // namespace
}  // namespace lanthorn

// Questions to the bodies: how far something gets, whether something would fit.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "tests/unit/physics/stage.h"

namespace lanthorn::physics::test {
namespace physics_queries_test {

constexpr const char* kBlock = R"({"body": {"size": [2, 2, 2]}})";
constexpr const char* kDoor =
    R"({"body": {"type": "kinematic", "size": [1, 2, 0.1], "centre": [0.5, 1, 0]}})";
constexpr const char* kWalker = R"({"character": {"radius": 0.3, "height": 1.8}})";

TEST(PhysicsQueries, ASphereGetsAsFarAsTheNextBody) {
    Stage stage;
    const ecs::Entity block = stage.add("block", kBlock, {1000, 0, 0});
    EXPECT_EQ(stage.physics.sweep_sphere({995, 0, 0}, {1005, 0, 0}, 0.5).share, 1);  // not there yet
    stage.step();
    const Sweep met = stage.physics.sweep_sphere({995, 0, 0}, {1005, 0, 0}, 0.5);
    EXPECT_NEAR(met.share, 0.35, 0.01);
    EXPECT_EQ(met.met, block);
    EXPECT_NEAR(glm::distance(met.normal, dvec3(-1, 0, 0)), 0, 1e-6);
    EXPECT_EQ(stage.physics.sweep_sphere({995, 0, 0}, {1005, 0, 0}, 0.5, std::span(&block, 1)).share, 1);
    EXPECT_EQ(stage.physics.sweep_sphere({995, 3, 0}, {1005, 3, 0}, 0.5).met, ecs::kNullEntity);
}

TEST(PhysicsQueries, TellsWhetherABodyWouldOverlapAnother) {
    Stage stage;
    stage.add_floor();
    const ecs::Entity door = stage.add("door", kDoor, {0, 0.1, 0});
    const ecs::Entity walker = stage.add("walker", kWalker, {0.5, 0.1, 1});
    stage.step();
    const auto turned = [](float angle) {
        return glm::rotate(glm::translate(dmat4(1), dvec3(0, 0.1, 0)), double(angle), dvec3(0, 1, 0));
    };
    EXPECT_FALSE(stage.physics.would_overlap(door, turned(0), walker));
    EXPECT_TRUE(stage.physics.would_overlap(door, turned(-1.1f), walker));
    EXPECT_FALSE(stage.physics.would_overlap(door, turned(1.1f), walker));
    EXPECT_FALSE(stage.physics.would_overlap(door, dmat4(0), walker));
    EXPECT_FALSE(stage.physics.would_overlap(walker, turned(0), door));  // a character is no body
}

TEST(PhysicsQueries, KnowsTheMiddleOfABody) {
    Stage stage;
    const ecs::Entity door = stage.add("door", kDoor, {3, 0, 0});
    EXPECT_FALSE(stage.physics.centre(door));
    stage.step();
    EXPECT_NEAR(glm::distance(*stage.physics.centre(door), dvec3(3.5, 1, 0)), 0, 1e-9);
}

TEST(PhysicsQueries, ARayMeetsTheNearest) {
    Stage stage;
    const ecs::Entity block = stage.add("block", kBlock, {1000, 0, 0});
    const ecs::Entity fence = stage.add("fence", R"({"collider": "box"})", {990, 0, 0});
    stage.world.get_mut<Collider>(fence).size = dvec3(1);
    const ecs::Entity walker = stage.add("walker", kWalker, {1010, 0, 0});
    stage.step();
    const std::optional<RayHit> hit = stage.physics.cast_ray({980, 0, 0}, {2, 0, 0}, 100);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->entity, fence);
    EXPECT_NEAR(hit->distance, 9.5, 1e-6);
    EXPECT_NEAR(glm::distance(hit->point, dvec3(989.5, 0, 0)), 0, 1e-6);
    EXPECT_NEAR(glm::distance(hit->normal, dvec3(-1, 0, 0)), 0, 1e-6);
    EXPECT_EQ(stage.physics.cast_ray({980, 0, 0}, {1, 0, 0}, 100, fence)->entity, block);
    EXPECT_EQ(stage.physics.cast_ray({1020, 1, 0}, {-1, 0, 0}, 100)->entity, walker);
    EXPECT_FALSE(stage.physics.cast_ray({980, 0, 0}, {1, 0, 0}, 5));
    EXPECT_FALSE(stage.physics.cast_ray({980, 0, 0}, {0, 0, 0}, 5));
}

}  // namespace physics_queries_test
}  // namespace lanthorn::physics::test

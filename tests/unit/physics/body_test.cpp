// Rigid bodies against what is known on paper.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/shapes.h"
#include "tests/unit/physics/stage.h"

namespace lanthorn::physics::test {
namespace body_test {

constexpr double kStep = 1.0 / 60;
constexpr double kGravity = 9.81;
const char* const kCrate = R"({"body": {"type": "dynamic", "size": [1, 1, 1]}})";

// Semi-implicit Euler: v += g dt, then y += v dt, so that n steps fall g dt^2 n (n + 1) / 2.
TEST(Body, FallsByTheClosedFormOfTheIntegrator) {
    Stage stage;
    const ecs::Entity ball =
        stage.add("ball", R"({"body": {"type": "dynamic", "shape": "sphere", "radius": 0.5}})", {3, 100, -2});
    for (int n = 1; n <= 120; ++n) {
        stage.step();
        EXPECT_NEAR(stage.place(ball).y, 100 - kGravity * kStep * kStep * n * (n + 1) / 2, 1e-9);
    }
    EXPECT_EQ(stage.place(ball).x, 3);
    EXPECT_NEAR(stage.motion(ball)->linear.y, -kGravity * kStep * 120, 1e-9);
}

TEST(Body, ThrownFollowsItsParabola) {
    Stage stage;
    const ecs::Entity ball =
        stage.add("ball", R"({"body": {"type": "dynamic", "shape": "sphere", "radius": 0.1}})", dvec3(0));
    stage.step();  // it is known from the first step on
    stage.push(ball, {4, 6, -1});
    const dvec3 start = stage.place(ball);
    stage.step(60);
    EXPECT_NEAR(stage.place(ball).x - start.x, 4, 1e-9);
    EXPECT_NEAR(stage.place(ball).z - start.z, -1, 1e-9);
    EXPECT_NEAR(stage.place(ball).y - start.y, 6 - kGravity * kStep * kStep * 60 * 61 / 2, 1e-9);
}

TEST(Body, ARestingBoxDoesNotCreep) {
    Stage stage;
    stage.add_floor();
    const ecs::Entity crate = stage.add("crate", kCrate, {0.3, 0.5, -0.7});
    stage.step(60);
    const dvec3 settled = stage.place(crate);
    EXPECT_NEAR(settled.y, 0.5, 2e-3);
    stage.step(600);
    EXPECT_LT(glm::distance(stage.place(crate), settled), 1e-4);
    EXPECT_NEAR(settled.x, 0.3, 1e-4);
}

// A ball of restitution e (both have it: Bullet multiplies) comes back to e^2 of its height.
TEST(Body, RestitutionIsTheQuotientOfSpeeds) {
    for (const double e : {0.0, 0.5, 0.8}) {
        Stage stage;
        stage.add("floor", R"({"body": {"size": [200, 2, 200], "restitution": 1}})", {0, -1, 0});
        const ecs::Entity ball = stage.add(
            "ball",
            fmt::format(
                R"({{"body": {{"type": "dynamic", "shape": "sphere", "radius": 0.25, "restitution": {}}}}})",
                e),
            {0, 2.25, 0});
        double fastest_down = 0;
        double fastest_up = 0;
        for (int i = 0; i < 60; ++i) {
            stage.step();
            const double v = stage.motion(ball)->linear.y;
            fastest_down = std::max(fastest_down, -v);
            fastest_up = std::max(fastest_up, v);
        }
        EXPECT_NEAR(fastest_down, std::sqrt(2 * kGravity * 2), 0.2);
        EXPECT_NEAR(fastest_up / fastest_down, e, 0.03) << e;
    }
}

// v^2 / (2 mu g), mu the product of both coefficients.
TEST(Body, SlidingStopsByCoulombsLaw) {
    for (const double mu : {0.2, 0.4}) {
        Stage stage;
        stage.add_floor(0, dvec3(0), 1);
        const ecs::Entity crate = stage.add(
            "crate",
            fmt::format(R"({{"body": {{"type": "dynamic", "size": [2, 0.2, 2], "friction": {}}}}})", mu),
            {0, 0.1, 0});
        stage.step(10);
        const dvec3 start = stage.place(crate);
        stage.push(crate, {4, 0, 0});
        stage.step(240);
        const double way = stage.place(crate).x - start.x;
        EXPECT_NEAR(way / (4.0 * 4.0 / (2 * mu * kGravity)), 1, 0.05) << mu;
        EXPECT_LT(glm::length(stage.motion(crate)->linear), 1e-2);
    }
}

TEST(Body, AKinematicOnePushesADynamicOne) {
    Stage stage;
    stage.add_floor();
    const ecs::Entity crate = stage.add("crate", kCrate, {0, 0.5, 0});
    const ecs::Entity ram =
        stage.add("ram", R"({"body": {"type": "kinematic", "size": [1, 1, 1]}})", {-2, 0.6, 0});
    for (int i = 0; i < 120; ++i) {
        stage.world.get_mut<LocalTransform>(ram).value.translation.x += 0.02;
        stage.transforms.update(stage.world);
        stage.step();
    }
    EXPECT_NEAR(stage.place(ram).x, 0.4, 1e-9) << "nothing moves it but its transform";
    EXPECT_GT(stage.place(crate).x, 1.37);
    EXPECT_LT(stage.place(crate).x, 1.9);
}

TEST(Body, AStaticOneThatIsMovedIsMovedForAll) {
    Stage stage;
    const ecs::Entity floor = stage.add_floor();
    const ecs::Entity crate = stage.add("crate", kCrate, {0, 0.5, 0});
    stage.step(300);
    stage.world.get_mut<LocalTransform>(floor).value.translation.y -= 1;
    stage.transforms.update(stage.world);
    stage.step(120);
    EXPECT_NEAR(stage.place(crate).y, -0.5, 5e-3);
}

// Every shape, its size from the mesh and the world's scale, comes to rest on its lowest point.
TEST(Body, ShapesHaveTheSizeOfTheirMeshes) {
    const Mesh cube = support::box(vec3(-1, 0, -1), vec3(1, 1, 1), false, 0);  // its origin at the bottom
    const Mesh ball = support::sphere(vec3(0), 0.5f, 3, false, 0);
    struct Case {
        const char* shape;
        const Mesh* mesh;
        vec3 scale;
        double rest;  // height of the origin
    };
    for (const Case& c : {Case{"box", &cube, vec3(1), 0}, Case{"box", &cube, vec3(0.5f, 3, 0.5f), 0},
                          Case{"convex", &cube, vec3(2), 0}, Case{"convex", &ball, vec3(1), 0.5},
                          Case{"sphere", &ball, vec3(2), 1}, Case{"capsule", &ball, vec3(1, 2, 1), 1}}) {
        for (const bool on_mesh : {false, true}) {
            Stage stage;
            const Mesh ground = support::quad(vec3(-50, 0, 50), vec3(100, 0, 0), vec3(0, 0, -100), 0);
            if (on_mesh) {
                stage.add("ground", R"({"body": {"shape": "mesh"}})", dvec3(0), &ground);
            } else {
                stage.add_floor();
            }
            const ecs::Entity body =
                stage.add("body", fmt::format(R"({{"body": {{"type": "dynamic", "shape": "{}"}}}})", c.shape),
                          {0, c.rest + 0.02, 0}, c.mesh, {1, 0, 0, 0}, c.scale);
            stage.step(60);
            EXPECT_NEAR(stage.place(body).y, c.rest, 0.01 * static_cast<double>(c.scale.y))
                << c.shape << " of scale " << c.scale.y << (on_mesh ? " on a mesh" : " on a box");
            EXPECT_TRUE(stage.warnings().empty());
        }
    }
}

TEST(Body, UnderAParentFallsInTheWorld) {
    Stage stage;
    const ecs::Entity parent =
        stage.add("parent", "", {10, 20, 30}, nullptr, glm::angleAxis(0.5f * kPi, vec3(0, 0, 1)), vec3(2));
    const ecs::Entity ball =
        stage.add("ball", R"({"body": {"type": "dynamic", "shape": "sphere", "radius": 0.5}})", {1, 2, 3});
    stage.world.add(ball, Parent{parent});
    stage.transforms.update(stage.world);
    const dvec3 start = stage.place(ball);
    EXPECT_NEAR(start.x, 6, 1e-5);
    stage.step(30);
    const dvec3 end = stage.place(ball);
    EXPECT_NEAR(end.x, start.x, 1e-6);
    EXPECT_NEAR(end.y, start.y - kGravity * kStep * kStep * 30 * 31 / 2, 1e-6);
    EXPECT_EQ(stage.world.get<LocalTransform>(ball).value.scale, vec3(1));
}

TEST(Body, WhatTheGameWritesIsWhereItIs) {
    Stage stage;
    const ecs::Entity crate = stage.add("crate", kCrate, {0, 50, 0});
    stage.step(30);
    stage.world.get_mut<LocalTransform>(crate).value.translation = {5, 80, 0};
    stage.step();
    EXPECT_NEAR(stage.place(crate).y, 80 - kGravity * kStep * kStep, 1e-9) << "and its speed is gone";
    EXPECT_EQ(stage.place(crate).x, 5);
}

TEST(Body, MayDieWhileTheStepRunsThatMovesIt) {
    Stage stage;
    const ecs::Entity dies =
        stage.add("dies", R"({"body": {"type": "dynamic", "size": [1, 1, 1]}})", dvec3(0, 5, 0));
    const ecs::Entity stays =
        stage.add("stays", R"({"body": {"type": "dynamic", "size": [1, 1, 1]}})", dvec3(3, 5, 0));
    const ecs::Entity walker = stage.add("walker", R"({"character": {}})", dvec3(6, 5, 0));
    stage.transforms.update(stage.world);
    ecs::Commands commands(stage.world);
    const ecs::Tick now = stage.world.mark();
    stage.physics.step(stage.world, Physics::Writes(stage.world), commands, now);
    EXPECT_EQ(stage.motion(stays), nullptr) << "comes with the commands";
    stage.world.destroy(dies);
    stage.world.destroy(walker);
    commands.apply();
    ASSERT_NE(stage.motion(stays), nullptr);
    EXPECT_LT(stage.motion(stays)->linear.y, 0);
    stage.step();
    EXPECT_EQ(stage.physics.body_count(), 1u);
    EXPECT_EQ(stage.physics.character_count(), 0u);
}

TEST(Body, GoesWithItsEntity) {
    Stage stage;
    const ecs::Entity shelf = stage.add("shelf", R"({"body": {"size": [4, 1, 4]}})", {0, -0.5, 0});
    const ecs::Entity crate = stage.add("crate", kCrate, {0, 0.5, 0});
    stage.step(120);
    EXPECT_EQ(stage.physics.body_count(), 2u);
    stage.world.destroy(shelf);
    stage.step(60);
    EXPECT_EQ(stage.physics.body_count(), 1u);
    EXPECT_LT(stage.place(crate).y, -3) << "it slept on what is gone";
    stage.world.remove<RigidBody>(crate);
    stage.step();
    EXPECT_EQ(stage.physics.body_count(), 0u);
    EXPECT_EQ(stage.motion(crate), nullptr);
}

}  // namespace body_test
}  // namespace lanthorn::physics::test

// Going back to a snapshot, and on from there.
#include <gtest/gtest.h>

#include <cmath>

#include "lanthorn/ecs/query.h"
#include "lanthorn/ecs/snapshot.h"
#include "lanthorn/ecs/world_hash.h"
#include "tests/unit/physics/stage.h"

namespace lanthorn::physics::test {
namespace {

class Rewind : public testing::Test {
  protected:
    std::vector<std::uint64_t> hashes() { return ecs::state_hashes(stage.registry, stage.world); }
    // The states of the next steps; a door swings, a character walks round.
    std::vector<std::vector<std::uint64_t>> run(int from, int count) {
        std::vector<std::vector<std::uint64_t>> states;
        for (int i = from; i < from + count; ++i) {
            const double angle = 0.05 * i;
            if (stage.world.alive(door)) {
                stage.world.get_mut<LocalTransform>(door).value.rotation =
                    glm::angleAxis(static_cast<float>(std::sin(angle)), vec3(0, 1, 0));
                stage.transforms.update(stage.world);
            }
            if (stage.world.alive(walker)) {
                stage.world.insert(
                    walker, CharacterInput{{2 * std::cos(angle), 0, 2 * std::sin(angle)}, i % 40 == 0});
            }
            stage.step();
            states.push_back(hashes());
        }
        return states;
    }
    void expect_the_same_again(int before, int after) {
        run(0, before);
        const ecs::Snapshot snapshot = ecs::Snapshot::save(stage.world, stage.registry);
        const auto first = run(before, after);
        snapshot.restore(stage.world);
        const auto again = run(before, after);
        for (std::size_t i = 0; i < first.size(); ++i) {
            ASSERT_EQ(again[i], first[i]) << "step " << i << " after the snapshot";
        }
    }

    Stage stage;
    ecs::Entity door, walker;
};

TEST_F(Rewind, ACharacterAmongMovingDoorsDoesTheSameAgain) {
    stage.add_floor(0, {10000.25, 0, 0});
    stage.add("step", R"({"collider": "box"})", {10001, 0.1, 0.5});
    door = stage.add("door", R"({"body": {"type": "kinematic", "size": [1, 2, 0.1], "centre": [0.5, 1, 0]}})",
                     {10000.1, 0, 0.5});
    walker = stage.add("walker", R"({"character": {}})", {9999.7, 0.4, 0});
    expect_the_same_again(37, 200);
}

TEST_F(Rewind, WhatFallsAndTurnsDoesTheSameAgain) {
    for (int i = 0; i < 8; ++i) {
        const ecs::Entity ball = stage.add("ball", R"({"body": {"type": "dynamic", "size": [1, 2, 3]}})",
                                           {10000.3 + 10 * i, 50, 1e-3 * i}, nullptr,
                                           glm::normalize(quat(0.9f, 0.1f * static_cast<float>(i), 0.2f, 0)));
        stage.step();
        stage.push(ball, {1, 2 * i, 0}, {0.3 * i, 1, -2});
    }
    expect_the_same_again(20, 100);
}

// The solver's memory of contacts is in no component: the first run has it, those after a return have not.
TEST_F(Rewind, AHeapDoesTheSameAfterEveryReturn) {
    stage.add_floor();
    for (int i = 0; i < 40; ++i) {
        stage.add("crate", R"({"body": {"type": "dynamic", "size": [1, 1, 1]}})",
                  {0.3 * (i % 3), 1 + 1.1 * i, 0.2 * (i % 5)}, nullptr,
                  glm::angleAxis(0.1f * static_cast<float>(i), vec3(0.6f, 0.8f, 0)));
    }
    run(0, 150);
    const ecs::Snapshot snapshot = ecs::Snapshot::save(stage.world, stage.registry);
    run(150, 33);
    snapshot.restore(stage.world);
    const auto first = run(150, 100);
    snapshot.restore(stage.world);
    EXPECT_EQ(run(150, 100), first);
}

TEST_F(Rewind, BodiesThatWereGoneComeBackAndThoseThatCameGo) {
    stage.add_floor();
    const char* crate = R"({"body": {"type": "dynamic", "size": [1, 1, 1]}})";
    const ecs::Entity old = stage.add("old", crate, {0, 5, 0});
    stage.step(10);
    const ecs::Snapshot snapshot = ecs::Snapshot::save(stage.world, stage.registry);
    const BodyMotion motion = *stage.motion(old);
    stage.world.destroy(old);
    stage.add("new", crate, {5, 5, 0});
    stage.step(10);
    EXPECT_EQ(stage.physics.body_count(), 2u);
    snapshot.restore(stage.world);
    EXPECT_EQ(*stage.motion(old), motion);
    stage.step();
    EXPECT_EQ(stage.physics.body_count(), 2u);
    EXPECT_LT(stage.motion(old)->linear.y, motion.linear.y) << "it falls on";
}

}  // namespace
}  // namespace lanthorn::physics::test

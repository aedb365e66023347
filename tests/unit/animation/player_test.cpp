// Players in a world: what they write, blending, fades, ends, bad values.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lanthorn/ecs/schedule.h"
#include "tests/unit/animation/channels.h"
#include "tests/unit/deformation/allocations.h"

namespace animation_test {
namespace {

TEST(Player, MovesTheNodesOfItsSet) {
    const auto z = about_z(90);
    AnimationClip both = walk(2, 1);
    both.channels.push_back(channel(AnimationPath::rotation, Interpolation::linear, {0, 2},
                                    {0, 0, 0, 1, z[0], z[1], z[2], z[3]}, 1));
    both.channels.push_back(
        channel(AnimationPath::scale, Interpolation::linear, {0, 2}, {1, 1, 1, 3, 3, 3}, 1));
    Figure f({both});
    play(f.player(), f.set(), 0);
    f.step(1);
    EXPECT_EQ(f.local(1).translation, dvec3(1, 0, 0));
    EXPECT_NEAR(f.local(1).rotation.z, std::sin(3.14159265358979 / 8), 1e-6);
    EXPECT_EQ(f.local(1).scale, vec3(2));
    EXPECT_EQ(f.local(0), Transform{});
    f.step(0.5);
    EXPECT_EQ(f.x(1), 1.5);
}

TEST(Player, MorphWeights) {
    Figure f({clip({channel(AnimationPath::weights, Interpolation::linear, {0, 1}, {0, 1})})});
    f.world.add(f.nodes[0], MorphWeights{{0.5f, 0.75f}});
    play(f.player(), f.set(), 0);
    f.step(0.25);
    EXPECT_EQ(f.world.get<MorphWeights>(f.nodes[0]).weights, (std::vector<float>{0.25f, 0.75f}));
}

TEST(Player, SpeedAndLoopModes) {
    struct Case {
        LoopMode mode;
        double speed, seconds, x;
    };
    for (const Case& c : {Case{LoopMode::loop, 1, 2.5, 0.5}, Case{LoopMode::loop, 2, 0.75, 1.5},
                          Case{LoopMode::loop, -1, 0.5, 1.5}, Case{LoopMode::once, 1, 9, 2},
                          Case{LoopMode::once, -1, 0.5, 1.5}, Case{LoopMode::once, -1, 9, 0},
                          Case{LoopMode::ping_pong, 1, 2.5, 1.5}, Case{LoopMode::ping_pong, -1, 0.5, 0.5}}) {
        Figure f({walk()});
        play(f.player(), f.set(), 0, c.mode, c.speed);
        f.step(c.seconds);
        EXPECT_EQ(f.x(), c.x) << static_cast<int>(c.mode) << ' ' << c.speed << ' ' << c.seconds;
    }
}

TEST(Player, OnceIsFinishedAtItsEnd) {
    Figure f({walk()});
    play(f.player(), f.set(), 0, LoopMode::once);
    f.step(1.9);
    EXPECT_FALSE(finished(f.player().layers[0], f.set()));
    f.step(0.2);
    EXPECT_TRUE(finished(f.player().layers[0], f.set()));
    f.player().layers[0].speed = -1;  // turns back at once: the end did not add up
    EXPECT_FALSE(finished(f.player().layers[0], f.set()));
    f.step(0.5);
    EXPECT_EQ(f.x(), 1.5);
}

// Two clips of constant poses 0 and 10.
std::vector<AnimationClip> two_poses() {
    return {clip({channel(AnimationPath::translation, Interpolation::step, {0}, {0, 0, 0})}),
            clip({channel(AnimationPath::translation, Interpolation::step, {0}, {10, 0, 0})})};
}

TEST(Player, LayersAreBlendedByWeight) {
    Figure f(two_poses());
    f.player().layers.resize(2);
    f.player().layers[1].clip = 1;
    f.step(0);
    EXPECT_EQ(f.x(), 5);  // 1 and 1
    f.player().layers[0].weight = 3;
    f.step(0);
    EXPECT_EQ(f.x(), 2.5);
    f.player().layers[0].weight = 0.25;
    f.player().layers[1].weight = 0.75;
    f.step(0);
    EXPECT_EQ(f.x(), 7.5);
}

TEST(Player, WhatIsMissingToOneIsTheRestPose) {
    Figure f(two_poses());
    play(f.player(), f.set(), 1).weight = 0.25;
    f.world.get_mut<LocalTransform>(f.nodes[0]).value.translation = {2, 4, 0};
    f.step(0);
    EXPECT_EQ(f.local().translation, dvec3(2 * 0.75 + 10 * 0.25, 3, 0));
    f.step(0);  // the rest pose is not the one just written
    EXPECT_EQ(f.local().translation, dvec3(4, 3, 0));
}

TEST(Player, RotationsAreBlendedOnOneHemisphere) {
    const auto a = about_z(0);
    const auto b = about_z(90);
    Figure f(
        {clip({channel(AnimationPath::rotation, Interpolation::step, {0}, {a[0], a[1], a[2], a[3]})}),
         clip({channel(AnimationPath::rotation, Interpolation::step, {0}, {-b[0], -b[1], -b[2], -b[3]})})});
    f.player().layers.resize(2);
    f.player().layers[1].clip = 1;
    f.step(0);
    EXPECT_NEAR(std::abs(f.local().rotation.z), std::sin(3.14159265358979 / 8), 1e-6);
    EXPECT_NEAR(std::abs(f.local().rotation.w), std::cos(3.14159265358979 / 8), 1e-6);
}

TEST(Player, CrossFadeIsLinearInTime) {
    Figure f(two_poses());
    play(f.player(), f.set(), 0);
    f.step(0);
    cross_fade(f.player(), f.set(), 1, 2);
    f.step(0.5);
    EXPECT_NEAR(f.x(), 2.5, 1e-12);
    f.step(0.5);
    EXPECT_NEAR(f.x(), 5, 1e-12);
    f.step(0.75);
    EXPECT_NEAR(f.x(), 8.75, 1e-12);
    f.step(0.5);
    EXPECT_EQ(f.x(), 10);
    EXPECT_EQ(f.player().layers.size(), 1u);
}

// Turned round half-way: it goes on from the weights it had.
TEST(Player, ACrossFadeCanBeTurnedRound) {
    Figure f(two_poses());
    play(f.player(), f.set(), 0);
    cross_fade(f.player(), f.set(), 1, 1);
    f.step(0.5);
    cross_fade(f.player(), f.set(), 0, 1);
    f.step(0.5);
    EXPECT_NEAR(f.x(), 2.5, 1e-12);
    f.step(0.5);
    EXPECT_EQ(f.x(), 0);
    EXPECT_EQ(f.player().layers.size(), 1u);
    EXPECT_EQ(f.player().layers[0].clip, 0u);
}

TEST(Player, ANodeThatNoClipMovesAnyMoreReturnsToRestAndIsLetGo) {
    Figure f({walk(2, 0), walk(2, 1)});
    play(f.player(), f.set(), 0);
    f.step(1);
    EXPECT_EQ(f.x(0), 1);
    f.world.get_mut<LocalTransform>(f.nodes[1]).value.translation.x = 7;  // somebody else's business
    f.step(0.5);
    EXPECT_EQ(f.x(1), 7);
    play(f.player(), f.set(), 1);
    f.step(0.5);
    EXPECT_EQ(f.x(0), 0);
    EXPECT_EQ(f.x(1), 0.5);
    f.world.get_mut<LocalTransform>(f.nodes[0]).value.translation.x = 7;
    f.step(0.5);
    EXPECT_EQ(f.x(0), 7);
}

TEST(Player, WritesOnlyWhatDiffers) {
    Figure f({two_poses()[1]});
    f.world.add(f.nodes[0], MorphWeights{{0}});
    play(f.player(), f.set(), 0);
    f.step(0);
    const ecs::Tick since = f.world.mark();
    f.step(0.1);
    EXPECT_FALSE(f.world.changed<LocalTransform>(f.nodes[0], since));
    EXPECT_FALSE(f.world.changed<LocalTransform>(f.nodes[1], since));
    EXPECT_FALSE(f.world.changed<MorphWeights>(f.nodes[0], since));
    f.world.get_mut<LocalTransform>(f.nodes[0]).value.translation.x = 1;
    const ecs::Tick later = f.world.mark();
    f.step(0.1);
    EXPECT_TRUE(f.world.changed<LocalTransform>(f.nodes[0], later));
}

TEST(Player, DeadNodesAndMissingComponentsArePassedOver) {
    AnimationClip c = walk(2, 0);
    c.channels.push_back(channel(AnimationPath::weights, Interpolation::linear, {0, 1}, {0, 1}, 0));
    c.channels.push_back(walk(2, 1).channels[0]);
    c.channels.push_back(walk(2, 2).channels[0]);
    c.channels.push_back(walk(2, 3).channels[0]);
    c.channels.push_back(walk(2, 99).channels[0]);  // no such node
    Figure f({c}, 4);
    play(f.player(), f.set(), 0);
    f.world.destroy(f.nodes[1]);
    f.world.remove<LocalTransform>(f.nodes[0]);
    f.step(1);
    f.world.destroy(f.nodes[3]);
    f.step(0.5);
    EXPECT_EQ(f.x(2), 1.5);
}

TEST(Player, ImpossibleNumbersCountAsNothing) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Figure f({walk()});
    play(f.player(), f.set(), 0).speed = nan;
    f.step(1);
    EXPECT_EQ(f.x(), 0);
    f.player().layers[0].speed = 1;
    f.step(nan);
    f.step(-1);
    EXPECT_EQ(f.x(), 0);
    f.player().layers[0].time = nan;
    f.step(0.5);
    EXPECT_EQ(f.x(), 0.5);
    f.player().layers[0].weight = nan;
    f.step(0.5);
    EXPECT_EQ(f.x(), 0);  // the rest pose
    f.player().layers[0].weight = -5;
    f.step(0.5);
    EXPECT_EQ(f.x(), 0);
    f.player().layers[0].clip = 77;
    f.step(0.5);
    EXPECT_EQ(f.x(), 0);
}

TEST(Player, AnotherSetIsBoundAnew) {
    Figure f({walk(2, 0)});
    play(f.player(), f.set(), 0);
    f.step(1);
    AnimationSet other;
    other.clips = std::make_shared<const std::vector<AnimationClip>>(two_poses());
    other.nodes = {f.nodes[1]};
    f.world.insert(f.holder, other);
    play(f.player(), f.set(), 1);
    f.step(0);
    EXPECT_EQ(f.x(0), 1);
    EXPECT_EQ(f.x(1), 10);
}

TEST(Player, ClipsAreFoundByName) {
    Figure f({walk(), walk()});
    auto clips = *f.set().clips;
    clips[1].name = "run";
    f.world.insert(f.holder,
                   AnimationSet{std::make_shared<const std::vector<AnimationClip>>(clips), f.nodes});
    EXPECT_EQ(find_clip(f.set(), "run"), 1u);
    EXPECT_FALSE(find_clip(f.set(), "swim"));
}

TEST(Player, AllocatesNothingAFrame) {
    std::vector<AnimationClip> clips = {walk(2, 0), walk(2, 1)};
    clips[0].channels.push_back(channel(AnimationPath::weights, Interpolation::linear, {0, 1}, {0, 1}, 0));
    Figure f(clips);
    f.world.add(f.nodes[0], MorphWeights{{0}});
    play(f.player(), f.set(), 0);
    f.player().root.node = 0;
    f.step(0);
    cross_fade(f.player(), f.set(), 1, 0.5);
    f.step(0.1);  // the new layer has its hints
    const std::uint64_t before = deformation_test::allocations();
    for (int i = 0; i < 100; ++i) {
        f.step(0.03);
    }
    EXPECT_EQ(deformation_test::allocations(), before);
    EXPECT_EQ(f.player().layers.size(), 1u);
    EXPECT_GT(f.x(1), 0);
}

TEST(Player, RunsInASchedule) {
    Figure f({walk()});
    play(f.player(), f.set(), 0);
    ecs::Schedule schedule;
    schedule.add("animation",
                 [animator = Animator()](ecs::World& world) mutable { animator.animate(world, 0.25); });
    schedule.run(f.world);
    schedule.run(f.world);
    EXPECT_EQ(f.x(), 0.5);
    animate(f.world, 0.25);  // without an object
    EXPECT_EQ(f.x(), 0.75);
}

// One step of 1 s and ten of 0.1 s end in the same place, and two worlds in the same bits.
TEST(Player, IsAPureFunctionOfItsSteps) {
    const auto run = [](int steps) {
        Figure f({walk(3), two_poses()[1]});
        play(f.player(), f.set(), 0, LoopMode::ping_pong, 1.7);
        cross_fade(f.player(), f.set(), 1, 5);
        for (int i = 0; i < steps; ++i) {
            f.step(1.0 / steps);
        }
        return f.local();
    };
    EXPECT_EQ(run(10), run(10));
    EXPECT_NEAR(run(1).translation.x, run(10).translation.x, 1e-9);
}

}  // namespace
}  // namespace animation_test

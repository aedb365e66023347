// Root motion: applied to the parent, it gives back the motion that was taken out of the pose.
#include "engine/animation/root_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/animation/channels.h"

namespace animation_test {
namespace {

std::array<float, 4> about_y(double degrees) {
    const auto z = about_z(degrees);
    return {0, z[2], 0, z[3]};
}

// A quarter turn in 2 s while walking from (1, 3, 0) to (3, 3, 1), with a hop of 1 m at the middle.
AnimationClip turning_walk() {
    const auto a = about_y(10);
    const auto b = about_y(100);
    return clip(
        {channel(AnimationPath::translation, Interpolation::linear, {0, 1, 2}, {1, 3, 0, 2, 4, 0, 3, 3, 1}),
         channel(AnimationPath::rotation, Interpolation::linear, {0, 2},
                 {a[0], a[1], a[2], a[3], b[0], b[1], b[2], b[3]})});
}

void expect_same(const dmat4& a, const dmat4& b) {
    for (int c = 0; c < 4; ++c) {
        EXPECT_LE(glm::length(a[c] - b[c]), 1e-5) << "column " << c;
    }
}

dmat4 of(const RootMotion& root) {
    return glm::translate(dmat4(1), root.translation) * glm::dmat4(glm::mat4_cast(glm::dquat(root.turn)));
}

TEST(RootMotion, StraightWalkOverALoop) {
    Figure f({walk()});
    play(f.player(), f.set(), 0);
    f.player().root.node = 0;
    f.step(1.5);
    EXPECT_NEAR(f.player().root.translation.x, 1.5, 1e-12);
    EXPECT_EQ(f.x(), 0);
    f.step(1);  // over the end: 0.5 + 0.5
    EXPECT_NEAR(f.player().root.translation.x, 1, 1e-12);
    f.step(20.5);  // many rounds
    EXPECT_NEAR(f.player().root.translation.x, 20.5, 1e-9);
    f.player().layers[0].speed = -1;
    f.step(3);
    EXPECT_NEAR(f.player().root.translation.x, -3, 1e-9);
    f.step(0);
    EXPECT_EQ(f.player().root.translation, dvec3(0));
    EXPECT_EQ(f.player().root.turn, quat(1, 0, 0, 0));
}

TEST(RootMotion, AtTheEndOfAClipThatPlaysOnceItStops) {
    Figure f({walk()});
    play(f.player(), f.set(), 0, LoopMode::once);
    f.player().root.node = 0;
    f.step(1.5);
    f.step(1.5);
    EXPECT_NEAR(f.player().root.translation.x, 0.5, 1e-12);
    f.step(1.5);
    EXPECT_EQ(f.player().root.translation.x, 0);
}

// With the parent moved by each step's delta, the node is where it would be without root motion.
TEST(RootMotion, GivesBackTheWholeMotion) {
    for (const bool vertical : {true, false}) {
        Figure plain({turning_walk()});
        play(plain.player(), plain.set(), 0, LoopMode::once);
        Figure taken({turning_walk()});
        play(taken.player(), taken.set(), 0, LoopMode::once);
        taken.player().root.node = 0;
        taken.player().root.vertical = vertical;
        dmat4 parent(1);
        for (int i = 0; i < 12; ++i) {
            plain.step(0.17);
            taken.step(0.17);
            parent = parent * of(taken.player().root);
            expect_same(parent * taken.local().matrix(), plain.local().matrix());
            EXPECT_EQ(taken.local().translation.y != 3, !vertical && i < 11) << i;
        }
    }
}

// Twice through the clip is its whole motion twice.
TEST(RootMotion, TurnsAddUpOverLoops) {
    Figure f({turning_walk()});
    play(f.player(), f.set(), 0);
    f.player().root.node = 0;
    dmat4 once(1);
    f.step(2);
    once = of(f.player().root);
    dmat4 parent(1);
    for (int i = 0; i < 40; ++i) {
        f.step(0.1);
        parent = parent * of(f.player().root);
    }
    expect_same(parent, once * once);
}

TEST(RootMotion, WithoutRotationTheTurnStaysInThePose) {
    Figure f({turning_walk()});
    play(f.player(), f.set(), 0, LoopMode::once);
    f.player().root.node = 0;
    f.player().root.rotation = false;
    f.step(2);
    EXPECT_EQ(f.player().root.turn, quat(1, 0, 0, 0));
    EXPECT_NEAR(f.player().root.translation.x, 2, 1e-6);
    EXPECT_NEAR(f.player().root.translation.z, 1, 1e-6);
    EXPECT_NEAR(f.local().rotation.y, about_y(100)[1], 1e-6);
    EXPECT_NEAR(f.x(), 1, 1e-6);
}

TEST(RootMotion, CanStayInThePose) {
    Figure f({walk()});
    play(f.player(), f.set(), 0);
    f.player().root.node = 0;
    f.player().root.remove = false;
    f.step(1);
    EXPECT_EQ(f.x(), 1);
    EXPECT_EQ(f.player().root.translation.x, 1);
}

TEST(RootMotion, IsBlendedByWeight) {
    AnimationClip fast = walk();
    for (float& v : fast.channels[0].values) {
        v *= 3;
    }
    Figure f({walk(), fast});
    f.player().layers.resize(2);
    f.player().layers[1].clip = 1;
    f.player().root.node = 0;
    f.step(0.5);
    EXPECT_NEAR(f.player().root.translation.x, (0.5 + 1.5) / 2, 1e-9);
}

TEST(RootMotion, ANodeThatTheClipDoesNotMove) {
    Figure f({walk(2, 1)});
    play(f.player(), f.set(), 0);
    f.player().root.node = 0;
    f.step(0.5);
    EXPECT_EQ(f.player().root.translation, dvec3(0));
    EXPECT_EQ(f.x(1), 0.5);
}

}  // namespace
}  // namespace animation_test

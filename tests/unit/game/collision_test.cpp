#include "game/collision.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lanthorn::game {
namespace {

const Box kWall{{0, 1, 0}, {1, 1, 0.1}, 0};  // 2 m wide, 2 m high, 0.2 m thick, facing Z

TEST(Collision, TouchingIsNotOverlapping) {
    EXPECT_TRUE(overlaps(Cylinder{{0, 0, 0.39}, 0.3, 1.7}, kWall));
    EXPECT_FALSE(overlaps(Cylinder{{0, 0, 0.41}, 0.3, 1.7}, kWall));
    EXPECT_FALSE(overlaps(Cylinder{{0, 2, 0}, 0.3, 1.7}, kWall));     // stands on top
    EXPECT_FALSE(overlaps(Cylinder{{0, -1.7, 0}, 0.3, 1.7}, kWall));  // below
}

TEST(Collision, PushesOutTheShortestWay) {
    const dvec3 at = pushed_out({{0.5, 0, 0.2}, 0.3, 1.7}, std::span(&kWall, 1));
    EXPECT_NEAR(at.x, 0.5, 1e-12);
    EXPECT_NEAR(at.z, 0.4, 1e-12);
    EXPECT_EQ(at.y, 0);
}

TEST(Collision, PushesOutOfTheMiddle) {
    const Cylinder body{{0.2, 0, 0.01}, 0.3, 1.7};
    const dvec3 at = pushed_out(body, std::span(&kWall, 1));
    EXPECT_NEAR(at.z, 0.4, 1e-12);
}

TEST(Collision, PushesRoundACorner) {
    const dvec3 at = pushed_out({{1.1, 0, 0.2}, 0.3, 1.7}, std::span(&kWall, 1));
    EXPECT_NEAR(std::hypot(at.x - 1, at.z - 0.1), 0.3, 1e-12);
}

TEST(Collision, TurnedBoxBlocksAsItStands) {
    Box turned = kWall;
    turned.yaw = 3.14159265358979 / 2;  // now it faces X
    EXPECT_TRUE(overlaps(Cylinder{{0.39, 0, 0.8}, 0.3, 1.7}, turned));
    EXPECT_FALSE(overlaps(Cylinder{{0.41, 0, 0.8}, 0.3, 1.7}, turned));
    EXPECT_FALSE(overlaps(Cylinder{{0.8, 0, 0}, 0.3, 1.7}, turned));
}

TEST(Collision, TurnsABoxAboutAHinge) {
    // Leaf along +Z from the hinge; a quarter turn about +Y brings it along +X.
    const Box leaf{{0, 1, 0.5}, {0.025, 1, 0.5}, 0};
    const Box open = turned_about(leaf, {2, 0, 3}, 3.14159265358979323846 / 2);
    EXPECT_NEAR(open.centre.x, 2.5, 1e-12);
    EXPECT_NEAR(open.centre.y, 1, 1e-12);
    EXPECT_NEAR(open.centre.z, 3, 1e-12);
}

TEST(Collision, SlidesAlongAWallAndNeverThroughIt) {
    const Cylinder body{{-0.5, 0, 0.5}, 0.3, 1.7};
    const dvec3 slid = slide(body, {0.6, 0, -0.3}, std::span(&kWall, 1));
    EXPECT_NEAR(slid.z, 0.4, 1e-9);
    EXPECT_NEAR(slid.x, 0.1, 1e-9);
    // Fifty metres in one step still end in front of it.
    const dvec3 fast = slide(body, {0.5, 0, -50}, std::span(&kWall, 1));
    EXPECT_GE(fast.z, 0.4 - 1e-9);
}

TEST(Collision, WhereABodyStandsMakesNoDifference) {
    // 1000 km away the same push comes out, to a micrometre.
    const dvec3 far(1e6, 0, -1e6);
    Box wall = kWall;
    wall.centre += far;
    const dvec3 here = pushed_out({{1.1, 0, 0.2}, 0.3, 1.7}, std::span(&kWall, 1));
    const dvec3 there = pushed_out({far + dvec3(1.1, 0, 0.2), 0.3, 1.7}, std::span(&wall, 1)) - far;
    EXPECT_NEAR(glm::distance(here, there), 0, 1e-6);
}

}  // namespace
}  // namespace lanthorn::game

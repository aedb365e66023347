// The character walks, climbs, falls and jumps.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/shapes.h"
#include "tests/unit/physics/stage.h"

namespace lanthorn::physics::test {
namespace {

constexpr double kStepHeight = 0.35;
constexpr double kSkin = 0.02;  // more than the controller keeps to what it stands on
const char* const kWalker =
    R"({"character": {"radius": 0.3, "height": 1.8, "stepHeight": 0.35, "slopeLimit": 0.8, "jumpSpeed": 5}})";

ecs::Entity add_walker(Stage& stage, const dvec3& feet) {
    const ecs::Entity walker = stage.add("walker", kWalker, feet);
    stage.world.add(walker, CharacterInput{});
    return walker;
}

void walk(Stage& stage, ecs::Entity walker, const dvec3& velocity, int steps) {
    stage.world.get_mut<CharacterInput>(walker).velocity = velocity;
    stage.step(steps);
}

// A box from `lower` to `upper`.
void add_block(Stage& stage, const dvec3& lower, const dvec3& upper) {
    const dvec3 size = upper - lower;
    stage.add("block", fmt::format(R"({{"body": {{"size": [{}, {}, {}]}}}})", size.x, size.y, size.z),
              0.5 * (lower + upper));
}

// A plane through the origin that rises along +X by `angle`.
void add_slope(Stage& stage, double angle) {
    stage.add("slope", R"({"body": {"size": [60, 2, 20]}})", dvec3(std::sin(angle), -std::cos(angle), 0),
              nullptr, glm::angleAxis(static_cast<float>(angle), vec3(0, 0, 1)));
}

TEST(Character, FallsAndStands) {
    Stage stage;
    stage.add_floor();
    const ecs::Entity walker = add_walker(stage, {0, 2, 0});
    stage.step(10);
    EXPECT_FALSE(stage.world.get<CharacterState>(walker).on_ground);
    EXPECT_NEAR(stage.place(walker).y, 2 - 9.81 / 3600 * 10 * 11 / 2, 1e-9);
    stage.step(110);
    EXPECT_TRUE(stage.world.get<CharacterState>(walker).on_ground);
    const dvec3 standing = stage.place(walker);
    EXPECT_NEAR(standing.y, 0, kSkin);
    stage.step(300);
    EXPECT_LT(glm::distance(stage.place(walker), standing), 1e-6);
}

TEST(Character, WalksAtItsSpeed) {
    Stage stage;
    stage.add_floor();
    const ecs::Entity walker = add_walker(stage, {0, 0.01, 0});
    stage.step(10);
    walk(stage, walker, {1.5, 0, -2}, 60);
    EXPECT_NEAR(stage.place(walker).x, 1.5, 1e-3);
    EXPECT_NEAR(stage.place(walker).z, -2, 1e-3);
    EXPECT_NEAR(stage.place(walker).y, 0, kSkin);
}

TEST(Character, JumpsToTheHeightOfItsSpeed) {
    Stage stage;
    stage.add_floor();
    const ecs::Entity walker = add_walker(stage, {0, 0.01, 0});
    stage.step(10);
    stage.world.get_mut<CharacterInput>(walker).jump = true;
    double highest = 0;
    for (int i = 0; i < 50; ++i) {
        stage.step();
        stage.world.get_mut<CharacterInput>(walker).jump = false;
        highest = std::max(highest, stage.place(walker).y);
    }
    EXPECT_NEAR(highest, 5.0 * 5.0 / (2 * 9.81), 0.06);  // v^2 / 2g, and half a step's way
    stage.step(60);
    EXPECT_NEAR(stage.place(walker).y, 0, kSkin);
}

TEST(Character, StopsAtAWallAndSlidesAlongIt) {
    Stage stage;
    stage.add_floor();
    add_block(stage, {2, 0, -20}, {3, 3, 20});
    const ecs::Entity walker = add_walker(stage, {0, 0.01, 0});
    walk(stage, walker, {3, 0, 1}, 120);
    EXPECT_NEAR(stage.place(walker).x, 1.7, 0.02);
    EXPECT_NEAR(stage.place(walker).z, 2, 0.05);
}

TEST(Character, ClimbsStepsLowerThanItsStepHeightAndNotHigher) {
    for (const double height : {0.05, 0.15, 0.3, 0.34, 0.36, 0.4, 0.7}) {
        Stage stage;
        stage.add_floor();
        add_block(stage, {1, 0, -5}, {9, height, 5});
        const ecs::Entity walker = add_walker(stage, {0, 0.01, 0});
        walk(stage, walker, {1.5, 0, 0}, 150);
        if (height < kStepHeight) {
            EXPECT_GT(stage.place(walker).x, 3.3) << height;
            EXPECT_NEAR(stage.place(walker).y, height, kSkin) << height;
        } else {
            EXPECT_LT(stage.place(walker).x, 0.75) << height;
            EXPECT_NEAR(stage.place(walker).y, 0, kSkin) << height;
        }
    }
}

TEST(Character, WalksUpAndDownStairs) {
    Stage stage;
    stage.add_floor();
    for (int i = 0; i < 10; ++i) {
        add_block(stage, {1 + 0.3 * i, 0, -1}, {8 - 0.3 * i, 0.2 * (i + 1), 1});
    }
    const ecs::Entity walker = add_walker(stage, {0, 0.01, 0});
    walk(stage, walker, {2, 0, 0}, 132);
    EXPECT_NEAR(stage.place(walker).y, 2, kSkin) << "on the top";
    int in_the_air = 0;
    for (int i = 0; i < 150; ++i) {
        stage.step();
        in_the_air += stage.world.get<CharacterState>(walker).on_ground ? 0 : 1;
    }
    EXPECT_NEAR(stage.place(walker).y, 0, kSkin) << "down again";
    EXPECT_LE(in_the_air, 2);
}

TEST(Character, WalksGentleSlopesAndStopsAtSteepOnes) {
    for (const double angle : {0.2, 0.5, 0.75, 0.85, 1.1}) {
        Stage stage;
        stage.add_floor();
        add_slope(stage, angle);
        const ecs::Entity walker = add_walker(stage, {-2, 0.01, 0});
        walk(stage, walker, {2, 0, 0}, 120);
        if (angle < 0.8) {
            EXPECT_GT(stage.place(walker).y, 0.5 * std::tan(angle)) << angle;
        } else {
            EXPECT_LT(stage.place(walker).y, 0.1) << angle;
        }
    }
}

TEST(Character, SlidesDownWhatIsTooSteepAndStandsOnWhatIsNot) {
    for (const double angle : {0.5, 1.1}) {
        Stage stage;
        add_slope(stage, angle);
        const ecs::Entity walker = add_walker(stage, {5, 5 * std::tan(angle) + 0.5, 0});
        stage.step(60);
        const dvec3 landed = stage.place(walker);
        stage.step(60);
        const double moved = glm::distance(stage.place(walker), landed);
        if (angle < 0.8) {
            EXPECT_LT(moved, 1e-6);
        } else {
            EXPECT_GT(moved, 0.5);
            EXPECT_LT(stage.place(walker).y, landed.y);
        }
    }
}

TEST(Character, HitsItsHeadAndFallsBack) {
    Stage stage;
    stage.add_floor();
    add_block(stage, {-5, 2, -5}, {5, 3, 5});
    const ecs::Entity walker = add_walker(stage, {0, 0.01, 0});
    stage.step(10);
    stage.world.get_mut<CharacterInput>(walker).jump = true;
    double highest = 0;
    for (int i = 0; i < 40; ++i) {
        stage.step();
        stage.world.get_mut<CharacterInput>(walker).jump = false;
        highest = std::max(highest, stage.place(walker).y);
    }
    EXPECT_LT(highest, 0.21);
    EXPECT_GT(highest, 0.15);
    EXPECT_NEAR(stage.place(walker).y, 0, kSkin);
}

TEST(Character, AndDynamicBodiesStopEachOther) {
    Stage stage;
    stage.add_floor();
    const char* const crate = R"({"body": {"type": "dynamic", "size": [1, 1, 1], "mass": 20}})";
    const ecs::Entity ahead = stage.add("ahead", crate, {1.5, 0.5, 0});
    const ecs::Entity walker = add_walker(stage, {0, 0.01, 0});
    walk(stage, walker, {2, 0, 0}, 90);
    EXPECT_NEAR(stage.place(walker).x, 0.7, 0.03);
    EXPECT_NEAR(stage.place(ahead).x, 1.5, 0.03);
    walk(stage, walker, dvec3(0), 1);
    const ecs::Entity above = stage.add("above", crate, stage.place(walker) + dvec3(0, 2.6, 0));
    stage.step(60);
    EXPECT_GT(stage.place(above).y, 0.9) << "fell on its head, and not through it";
    EXPECT_NEAR(stage.place(walker).y, 0, kSkin);
}

TEST(Character, IsPushedOutOfAWallThatMovesIntoIt) {
    Stage stage;
    stage.add_floor();
    const ecs::Entity door =
        stage.add("door", R"({"body": {"type": "kinematic", "size": [0.2, 3, 4]}})", {-1, 1.5, 0});
    const ecs::Entity walker = add_walker(stage, {0, 0.01, 0});
    for (int i = 0; i < 60; ++i) {
        stage.world.get_mut<LocalTransform>(door).value.translation.x += 0.03;
        stage.transforms.update(stage.world);
        stage.step();
    }
    EXPECT_NEAR(stage.place(walker).x, 0.8 + 0.1 + 0.3, 0.05);
    EXPECT_NEAR(stage.place(walker).y, 0, kSkin);
}

TEST(Character, IsTheSameTenKilometresAway) {
    const auto run = [](const dvec3& at) {
        Stage stage;
        stage.add_floor(0, at);
        stage.add("block", R"({"body": {"size": [8, 0.3, 10]}})", at + dvec3(5, 0.15, 0));
        const ecs::Entity walker = add_walker(stage, at + dvec3(0, 0.01, 0));
        walk(stage, walker, {1.5, 0, 0.2}, 150);
        return stage.place(walker) - at;
    };
    EXPECT_LT(glm::distance(run(dvec3(0)), run(dvec3(1e4, 0, 1e4))), 1e-6);
}

TEST(Character, IsTheSameInEveryRunAndGoesWithItsEntity) {
    const auto run = [] {
        Stage stage;
        add_slope(stage, 0.3);
        const ecs::Entity walker = add_walker(stage, {0, 0.5, 0});
        walk(stage, walker, {1, 0, 0.3}, 100);
        const auto pose = stage.pose({walker});
        stage.world.destroy(walker);
        stage.step();
        EXPECT_EQ(stage.physics.character_count(), 0u);
        return pose;
    };
    EXPECT_EQ(run(), run());
}

}  // namespace
}  // namespace lanthorn::physics::test

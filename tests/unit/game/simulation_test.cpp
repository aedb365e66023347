#include "game/simulation.h"

#include <gtest/gtest.h>

#include "game/tour.h"
#include "tests/unit/game/test_level.h"

namespace lanthorn::game {
namespace {

PlayerInput walking(double forward) {
    PlayerInput input;
    input.forward = axis(forward);
    return input;
}
PlayerInput pressing(Button button) {
    PlayerInput input;
    input.held = button;
    return input;
}
void steps(Simulation& simulation, int count, const PlayerInput& input = {}) {
    for (int i = 0; i < count; ++i) {
        simulation.step(input);
    }
}

TEST(Simulation, WalksAtTheSpeedItSays) {
    Level level;
    Simulation simulation(level, 1, 1);
    steps(simulation, 60, walking(1));  // up to speed
    const double before = simulation.view().eye.z;
    steps(simulation, 60, walking(1));
    EXPECT_NEAR(before - simulation.view().eye.z, Player::kSpeed, 0.01);
}

TEST(Simulation, WalkingAskewIsNoFaster) {
    Simulation simulation(Level{}, 1, 1);
    PlayerInput askew = walking(1);
    askew.right = axis(1);
    steps(simulation, 60, askew);
    const dvec3 before = simulation.view().eye;
    steps(simulation, 60, askew);
    EXPECT_NEAR(glm::distance(before, simulation.view().eye), Player::kSpeed, 0.01);
}

TEST(Simulation, StandsStillForGood) {
    Simulation simulation(test_level(), 1, 1);
    steps(simulation, 20, walking(0.5));
    steps(simulation, 240);
    const auto at_rest = simulation.hashes();
    steps(simulation, 10);
    const auto later = simulation.hashes();
    // All parts but the clock.
    for (std::size_t i = 0; i < at_rest.size(); ++i) {
        EXPECT_EQ(at_rest[i] == later[i], simulation.parts()[i] != "clock") << simulation.parts()[i];
    }
}

TEST(Simulation, ClosedDoorBlocksAndOpenDoorLetsThrough) {
    Simulation simulation(test_level(), 1, 1);
    steps(simulation, 180, walking(1));
    EXPECT_LT(simulation.view().eye.x, -0.03 - Player::kRadius + 1e-9);
    EXPECT_GT(simulation.view().eye.x, -0.03 - Player::kRadius - 0.01);

    simulation.step(pressing(kUse));
    steps(simulation, 240);
    EXPECT_NEAR(simulation.view().door_angle, 1.9, 1e-12);
    steps(simulation, 120, walking(1));
    EXPECT_GT(simulation.view().eye.x, 1);
}

TEST(Simulation, DoorTurnsSmoothlyAndDoesNotOvershoot) {
    Simulation simulation(test_level(), 1, 1);
    steps(simulation, 30, walking(1));
    simulation.step(pressing(kUse));
    double last = simulation.view().door_angle;
    for (int i = 0; i < 240; ++i) {
        simulation.step({});
        const double angle = simulation.view().door_angle;
        EXPECT_GE(angle, last);
        EXPECT_LE(angle, 1.9);
        EXPECT_LT(angle - last, 0.06);
        last = angle;
    }
}

TEST(Simulation, HoldingTheButtonOpensOnce) {
    Simulation simulation(test_level(), 1, 1);
    steps(simulation, 30, walking(1));
    steps(simulation, 300, pressing(kUse));
    EXPECT_NEAR(simulation.view().door_angle, 1.9, 1e-12);
}

TEST(Simulation, DoorOutOfReachStays) {
    Simulation simulation(test_level(), 1, 1);
    steps(simulation, 60, walking(-1));
    simulation.step(pressing(kUse));
    steps(simulation, 60);
    EXPECT_EQ(simulation.view().door_angle, 0);
}

TEST(Simulation, DoorStopsBeforeThePlayer) {
    Simulation simulation(test_level(), 1, 1);
    steps(simulation, 30, walking(1));
    simulation.step(pressing(kUse));
    steps(simulation, 240);
    // Into the doorway, then shut it.
    while (simulation.view().eye.x < 0) {
        simulation.step(walking(1));
    }
    steps(simulation, 60);
    PlayerInput turn;
    turn.yaw = look(0.5);
    simulation.step(turn);
    simulation.step(pressing(kUse));
    for (int i = 0; i < 240; ++i) {
        simulation.step({});
        const View view = simulation.view();
        const Level level = test_level();
        const Box leaf = turned_about(level.door->leaf[0], level.door->hinge, view.door_angle);
        EXPECT_FALSE(
            overlaps({view.eye - dvec3(0, Player::kEye - 0.05, 0), Player::kRadius - 1e-6, 1.7}, leaf));
    }
}

TEST(Simulation, CarriesTheLanternAndPutsItDown) {
    Simulation simulation(test_level(), 1, 1);
    const dvec3 stood = simulation.view().lantern_position;
    simulation.step(pressing(kCarry));
    EXPECT_TRUE(simulation.view().lantern_carried);
    steps(simulation, 40, walking(-1));
    const View carried = simulation.view();
    EXPECT_GT(glm::distance(carried.lantern_position, stood), 0.5);
    EXPECT_LT(glm::distance(carried.lantern_position, carried.eye), 1.0);
    EXPECT_NE(carried.lantern_rotation, quat(glm::angleAxis(float(carried.yaw), vec3(0, 1, 0))));  // sways
    steps(simulation, 1);
    simulation.step(pressing(kCarry));
    EXPECT_FALSE(simulation.view().lantern_carried);
    EXPECT_EQ(simulation.view().lantern_position.y, 0);
    const dvec3 down = simulation.view().lantern_position;
    steps(simulation, 60, walking(-1));
    EXPECT_EQ(simulation.view().lantern_position, down);
}

TEST(Simulation, PutsTheLanternOnWhatIsBelow) {
    Level level = test_level();
    level.walls.push_back({{-2.7, 0.4, 0}, {0.3, 0.4, 1}, 0});  // a bench behind the start
    Simulation simulation(level, 1, 1);
    simulation.step(pressing(kCarry));
    PlayerInput turn;
    turn.yaw = look(3.14159265);
    simulation.step(turn);
    steps(simulation, 60, walking(1));
    simulation.step(pressing(kCarry));
    EXPECT_FALSE(simulation.view().lantern_carried);
    EXPECT_DOUBLE_EQ(simulation.view().lantern_position.y, 0.8);
}

TEST(Simulation, TheLanternDoesNotReachThroughWalls) {
    Level level = test_level();
    level.door.reset();
    level.walls.push_back({{0, 1.5, 0}, {0.02, 1.5, 0.5}, 0});  // a thin wall instead of the door
    Simulation simulation(level, 1, 1);
    simulation.step(pressing(kCarry));
    steps(simulation, 120, walking(1));
    EXPECT_LT(simulation.view().lantern_position.x, 0);
}

TEST(Simulation, LightsThePickedUpLantern) {
    Simulation simulation(test_level(), 1, 1);
    EXPECT_TRUE(simulation.view().lantern_lit);
    simulation.step(pressing(kLight));
    EXPECT_FALSE(simulation.view().lantern_lit);
    simulation.step({});
    simulation.step(pressing(kLight));
    EXPECT_TRUE(simulation.view().lantern_lit);
}

TEST(Simulation, SensorReadingsEnterTheState) {
    Simulation one(test_level(), 1, 1), other(test_level(), 1, 1);
    const replay::SensorReading bright{0, 0, 2.5f};
    one.step({}, std::span(&bright, 1));
    other.step({});
    EXPECT_TRUE(one.view().far_room_lit);
    EXPECT_FALSE(other.view().far_room_lit);
    EXPECT_NE(one.hashes(), other.hashes());
}

TEST(Simulation, SameBitsWithAnyNumberOfThreads) {
    const Level level = test_level();
    Simulation one(level, 3, 1), two(level, 3, 2), all(level, 3, 0);
    const Tour tour(level);
    for (std::uint64_t step = 0; step < Tour::kSteps; ++step) {
        PlayerInput input = tour.next(one.view(), step);
        if (step == 60 || step == 400) {
            input.held |= kCarry;
        }
        one.step(input);
        two.step(input);
        all.step(input);
        ASSERT_EQ(one.hashes(), two.hashes()) << "step " << step;
        ASSERT_EQ(one.hashes(), all.hashes()) << "step " << step;
    }
}

TEST(Simulation, SeedIsPartOfTheState) {
    Simulation one(test_level(), 1, 1), other(test_level(), 2, 1);
    EXPECT_NE(one.hashes(), other.hashes());
}

TEST(Simulation, PrintsItsSchedule) {
    Simulation simulation(test_level(), 1, 1);
    const std::string dot = simulation.schedule_dot();
    for (const char* system :
         {"digraph", "count_step", "intend", "swing_door", "walk", "carry_lantern", "sense"}) {
        EXPECT_NE(dot.find(system), std::string::npos) << system;
    }
}

TEST(Tour, OpensTheDoorAndEndsBehindIt) {
    const Level level = test_level();
    Simulation simulation(level, 1, 1);
    const Tour tour(level);
    for (std::uint64_t step = 0; step < Tour::kSteps; ++step) {
        if (step == Tour::kDoorStep) {
            EXPECT_EQ(simulation.view().door_angle, 0);
        }
        simulation.step(tour.next(simulation.view(), step));
    }
    EXPECT_EQ(simulation.view().door_angle, 1.9);
    EXPECT_NEAR(simulation.view().eye.x, 1.5, 0.05);
}

TEST(View, BetweenTakesTheShortWayRound) {
    View a, b;
    a.yaw = 3.1;
    b.yaw = -3.1;
    EXPECT_NEAR(std::remainder(between(a, b, 0.5).yaw - 3.14159265358979, 6.283185307179586), 0, 1e-9);
    b.eye = {2, 0, 0};
    EXPECT_EQ(between(a, b, 0.25).eye, dvec3(0.5, 0, 0));
}

}  // namespace
}  // namespace lanthorn::game

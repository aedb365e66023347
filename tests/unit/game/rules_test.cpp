// What the player can do, and what the level answers.
#include <gtest/gtest.h>

#include "game/presentation/tour.h"
#include "lanthorn/ecs/world_hash.h"
#include "lanthorn/physics/physics.h"
#include "lanthorn/scene/light_sensor.h"
#include "tests/unit/game/test_level.h"

namespace lanthorn::game {
namespace {

using scene_generator::box;

std::vector<std::uint64_t> hashes(Played& game) {
    return ecs::state_hashes(game.session.app().registry(), game.world());
}

TEST(Walking, IsAsFastAsItSays) {
    Played game(test_level().scene);
    game.turn(3.14159265);
    game.walk(1, 60);  // up to speed
    const dvec3 before = game.place("player");
    game.walk(1, 60);
    EXPECT_NEAR(glm::distance(before, game.place("player")), Player::kSpeed, 0.02);
}

TEST(Walking, AskewIsNoFaster) {
    Played game(test_level().scene);
    game.turn(3.14159265);
    PlayerInput askew;
    askew.forward = askew.right = axis(1);
    game.steps(60, askew);
    const dvec3 before = game.place("player");
    game.steps(60, askew);
    EXPECT_NEAR(glm::distance(before, game.place("player")), Player::kSpeed, 0.02);
}

TEST(Walking, EndsInAStillState) {
    Played game(test_level().scene);
    game.walk(0.5, 20);
    game.steps(300);
    const auto at_rest = hashes(game);
    game.steps(10);
    EXPECT_EQ(hashes(game), at_rest);
}

TEST(Door, ClosedItBlocksAndOpenItLetsThrough) {
    Played game(test_level().scene);
    game.walk(1, 180);
    EXPECT_LT(game.place("player").x, -0.03 - 0.28 + 0.01);
    EXPECT_GT(game.place("player").x, -0.03 - 0.28 - 0.03);

    game.press(kUse);
    game.steps(240);
    EXPECT_EQ(game.of<Door>("door").angle, 1.9);
    game.walk(1, 120);
    EXPECT_GT(game.place("player").x, 1);
}

TEST(Door, TurnsSmoothlyAndDoesNotOvershoot) {
    Played game(test_level().scene);
    game.walk(1, 30);
    game.press(kUse);
    double last = game.of<Door>("door").angle;
    for (int i = 0; i < 240; ++i) {
        game.steps(1);
        const double angle = game.of<Door>("door").angle;
        EXPECT_GE(angle, last);
        EXPECT_LE(angle, 1.9);
        EXPECT_LT(angle - last, 0.06);
        last = angle;
    }
}

TEST(Door, HoldingTheButtonOpensItOnce) {
    Played game(test_level().scene);
    game.walk(1, 30);
    PlayerInput held;
    held.held = kUse;
    game.steps(300, held);
    EXPECT_EQ(game.of<Door>("door").angle, 1.9);
}

TEST(Door, OutOfReachStays) {
    Played game(test_level().scene);
    game.walk(-1, 60);
    game.press(kUse);
    game.steps(60);
    EXPECT_EQ(game.of<Door>("door").angle, 0);
}

TEST(Door, StopsBeforeThePlayer) {
    Played game(test_level().scene);
    game.walk(1, 30);
    game.press(kUse);
    game.steps(240);
    // Into the doorway, then shut it.
    while (game.place("player").x < 0.1) {
        game.walk(1, 1);
    }
    game.steps(60);
    game.turn(0.5);
    game.press(kUse);
    const auto& physics = *game.world().resource<std::shared_ptr<physics::Physics>>();
    for (int i = 0; i < 240; ++i) {
        game.steps(1);
        EXPECT_FALSE(physics.would_overlap(game.named("door"), game.of<WorldTransform>("door").matrix,
                                           game.named("player")))
            << i;
    }
    EXPECT_FALSE(game.of<Door>("door").open);
    EXPECT_GT(game.of<Door>("door").angle, 0.2);
}

TEST(Door, ASecondOneIsASecondNode) {
    scene_generator::Builder level = test_level();
    add_door(level, "second", {1.5, 0, -0.5}, R"({"door":{"open_angle":-1.2},"body":{"type":"kinematic"}})");
    Played game(level.scene);
    game.walk(1, 30);
    game.press(kUse);
    game.steps(240);
    EXPECT_EQ(game.of<Door>("door").angle, 1.9);
    EXPECT_EQ(game.of<Door>("second").angle, 0);  // out of reach
    game.walk(1, 60);
    game.steps(30);
    game.press(kUse);
    game.steps(240);
    EXPECT_EQ(game.of<Door>("second").angle, -1.2);
}

TEST(Lantern, IsCarriedAndPutDown) {
    Played game(test_level().scene);
    const dvec3 stood = game.place("lantern");
    game.press(kCarry);
    EXPECT_TRUE(game.of<Lantern>("lantern").carried);
    game.walk(-1, 40);
    const dvec3 carried = game.place("lantern");
    EXPECT_GT(glm::distance(carried, stood), 0.5);
    EXPECT_LT(glm::distance(carried, game.place("player") + dvec3(0, 1.62, 0)), 1.0);
    EXPECT_NE(game.of<Lantern>("lantern").sway, glm::dvec2(0));
    game.press(kCarry);
    EXPECT_FALSE(game.of<Lantern>("lantern").carried);
    const dvec3 down = game.place("lantern");
    EXPECT_NEAR(down.y, 0, 0.02);
    game.walk(-1, 60);
    EXPECT_EQ(game.place("lantern"), down);
}

TEST(Lantern, IsPutOnWhatIsBelow) {
    scene_generator::Builder level = test_level();
    level.solid("bench", box({-3, 0, -1}, {-2.4, 0.8, 1}), 0, scene_generator::kBoxCollider);
    Played game(level.scene);
    game.press(kCarry);
    game.turn(3.14159265);
    game.walk(1, 60);
    game.press(kCarry);
    EXPECT_FALSE(game.of<Lantern>("lantern").carried);
    EXPECT_NEAR(game.place("lantern").y, 0.8, 0.02);
}

TEST(Lantern, DoesNotReachThroughWalls) {
    Played game(test_level().scene);
    game.press(kCarry);
    game.walk(1, 120);  // against the closed door
    EXPECT_LT(game.place("lantern").x, 0);
}

TEST(Lantern, IsPutOutAndLitAgain) {
    Played game(test_level().scene);
    EXPECT_EQ(game.of<LightComponent>("flame").light.intensity, 15);
    game.press(kLight);
    EXPECT_FALSE(game.of<Lantern>("lantern").lit);
    EXPECT_FALSE(game.world().has<LightComponent>(game.named("flame")));
    game.press(kLight);
    EXPECT_TRUE(game.of<Lantern>("lantern").lit);
    EXPECT_EQ(game.of<LightComponent>("flame").light.intensity, 15);
}

TEST(Goal, IsReachedByAReading) {
    Played game(test_level().scene);
    const auto read = [&](float lux) {
        game.world().resource_mut<SensorInbox>().samples = {{game.named("far").index, 0, lux}};
        game.steps(1);
    };
    read(1.9f);
    EXPECT_FALSE(game.of<Goal>("far").reached);
    EXPECT_EQ(game.of<LightSensor>("far").lux, 1.9f);
    read(2.1f);
    EXPECT_TRUE(game.of<Goal>("far").reached);
    read(0);
    EXPECT_TRUE(game.of<Goal>("far").reached);
    EXPECT_EQ(game.of<LightSensor>("far").readings, 3u);
}

TEST(Game, HasTheSameBitsWithAnyNumberOfThreads) {
    const SceneData scene = test_level().scene;
    Options options = test_options();
    options.headless = true;
    Playthrough first(options, scene);
    session::Session& one = first.session();
    options.threads = 2;
    Playthrough second(options, scene);
    session::Session& two = second.session();
    while (!one.done()) {
        one.app().step();
        two.app().step();
        ASSERT_EQ(ecs::state_hashes(one.app().registry(), one.app().world()),
                  ecs::state_hashes(two.app().registry(), two.app().world()))
            << "step " << one.steps();
    }
}

// Frames between the steps change nothing of what is simulated.
TEST(Game, HasTheSameBitsWhateverIsShown) {
    const SceneData scene = test_level().scene;
    Options options = test_options();
    options.headless = true;
    Playthrough first(options, scene), second(options, scene);
    session::Session &stepped = first.session(), &shown = second.session();
    for (int i = 0; i < 300; ++i) {
        shown.app().frame(1.0 / 97);
        while (stepped.steps() < shown.steps()) {
            stepped.app().step();
        }
    }
    shown.app().step();
    stepped.app().step();
    EXPECT_EQ(ecs::state_hashes(stepped.app().registry(), stepped.app().world()),
              ecs::state_hashes(shown.app().registry(), shown.app().world()));
}

TEST(Game, PrintsBothItsSchedules) {
    Played game(test_level().scene);
    const std::string dot = game.session.app().schedule_dot();
    for (const char* system : {"digraph", "take_input", "swing_doors", "carry_lanterns", "walk", "physics",
                               "animation", "skinning", "extract", "sensors.read", "reach_goals"}) {
        EXPECT_NE(dot.find(system), std::string::npos) << system;
    }
}

// Legs in the file are walked: to the lantern, which is taken, and then held aside.
TEST(Tour, FollowsTheLegsOfTheLevel) {
    scene_generator::Builder level = test_level();
    level.scene.nodes[level.node("level", {})].extras =
        R"({"level":{"title":"A test","hints":["Take it."],"tour":[
        {"go":[-1.9,0,0.3],"look":[-1.2,0,0.5],"seconds":1.5,"deed":"carry"},
        {"go":[-3,0,-1],"look":[0,1,0],"seconds":2},
        {"go":[-3,0,-1],"look":[0,1,0],"seconds":0.5,"deed":"light"}]}})";
    Options options = test_options();
    options.headless = true;
    Playthrough playthrough(options, level.scene);
    session::Session& session = playthrough.session();
    EXPECT_EQ(session.length(), 240u);
    EXPECT_EQ(level_info(session.app().world()).title, "A test");
    while (!session.done()) {
        session.app().step();
    }
    ecs::World& world = session.app().world();
    const Lantern& lantern = world.get<Lantern>(find_by_name(world, "lantern"));
    EXPECT_TRUE(lantern.carried);
    EXPECT_FALSE(lantern.lit);
    EXPECT_NEAR(world.get<LocalTransform>(find_by_name(world, "player")).value.translation.x, -3, 0.1);
}

TEST(Tour, CarriesTheLanternThroughTheDoor) {
    Options options = test_options();
    options.headless = true;
    Playthrough playthrough(options, test_level().scene);
    session::Session& session = playthrough.session();
    ecs::World& world = session.app().world();
    const ecs::Entity door = find_by_name(world, "door"), lantern = find_by_name(world, "lantern");
    while (!session.done()) {
        if (session.steps() == Tour::kDoorStep) {
            EXPECT_EQ(world.get<Door>(door).angle, 0);
        }
        session.app().step();
    }
    EXPECT_EQ(world.get<Door>(door).angle, 1.9);
    EXPECT_TRUE(world.get<Lantern>(lantern).carried);
    EXPECT_GT(world.get<LocalTransform>(lantern).value.translation.x, 1.0);
}

}  // namespace
}  // namespace lanthorn::game

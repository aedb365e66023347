// The hero, her hand and the camera behind her; what follows her.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "game/rules/figures.h"
#include "game/rules/headings.h"
#include "lanthorn/animation/animation_player.h"
#include "lanthorn/core/error.h"
#include "lanthorn/ecs/world_hash.h"
#include "lanthorn/physics/physics.h"
#include "lanthorn/runtime/view.h"
#include "tests/unit/game/test_level.h"
#include "tools/scene_generator/hero_figure.h"

namespace lanthorn::game {
namespace {

using scene_generator::box;

scene_generator::Builder level_with_hero() {
    scene_generator::Builder level = test_level();
    for (std::uint32_t i = 0; i < level.scene.nodes.size(); ++i) {
        if (level.scene.nodes[i].name == "player") {
            scene_generator::add_hero(level, i);
            break;
        }
    }
    return level;
}

class HeroTest : public testing::Test {
  protected:
    Played game{level_with_hero().scene};

    const Figure& figure() { return game.of<Figure>("hero"); }
    const FollowCamera& camera() { return game.of<FollowCamera>("view"); }
    dvec3 world_place(const char* name) { return dvec3(game.of<WorldTransform>(name).matrix[3]); }
    double layer(const char* name, std::size_t i) { return game.of<AnimationPlayer>(name).layers[i].weight; }
};

TEST_F(HeroTest, StandsAndWalksByHerSpeed) {
    game.steps(10);
    EXPECT_EQ(layer("hero", 0), 1);
    EXPECT_EQ(layer("hero", 1), 0);
    game.walk(-1, 60);
    EXPECT_EQ(layer("hero", 0), 0);
    EXPECT_EQ(layer("hero", 1), 1);
    game.steps(150);  // she turns back to where she looks first
    EXPECT_EQ(layer("hero", 1), 0);
}

TEST_F(HeroTest, FacesWhereSheWalks) {
    EXPECT_NEAR(figure().yaw, -0.5 * kPi, 1e-6);  // the eyes look along +X
    game.walk(-1, 60);
    EXPECT_NEAR(std::abs(turn_between(figure().yaw, 0.5 * kPi)), 0, 0.05);
    const dvec3 front = dvec3(game.of<WorldTransform>("hero").matrix[2]);
    EXPECT_LT(front.x, -0.99);
}

// A foot that is on the ground stays where it is: of a second of walking, at every speed, the lower foot
// goes a small part of the way that she goes.
TEST_F(HeroTest, HerFeetDoNotSlide) {
    for (const double speed : {0.4, 0.7, 1.0}) {
        game.turn(3.14159265 * (speed == 0.7 ? 1 : 0));
        game.walk(speed, 60);
        double slid = 0, gone = 0;
        for (int i = 0; i < 120; ++i) {
            const dvec3 left = world_place("hero.foot.l"), right = world_place("hero.foot.r");
            const dvec3 body = world_place("player");
            game.walk(speed, 1);
            const dvec3 left_now = world_place("hero.foot.l"), right_now = world_place("hero.foot.r");
            const dvec3 step = left.y < right.y ? left_now - left : right_now - right;
            slid += std::hypot(step.x, step.z);
            gone += glm::distance(body, world_place("player"));
        }
        if (gone > 1) {
            EXPECT_LT(slid, 0.3 * gone) << speed;
        }
    }
}

TEST_F(HeroTest, CarriesTheLanternByHerHand) {
    game.walk(0.4, 20);
    game.press(kCarry);
    game.steps(60);
    ASSERT_TRUE(game.of<Lantern>("lantern").carried);
    double least = 10, most = 0;
    for (int i = 0; i < 60; ++i) {
        game.walk(-0.6, 1);
        const double handle = game.of<Lantern>("lantern").handle;
        const dvec3 up = dvec3(game.of<WorldTransform>("lantern").matrix[1]);
        EXPECT_LT(glm::distance(world_place("lantern") + handle * up, world_place("hero.hook")), 1e-6) << i;
        least = std::min(least, world_place("lantern").y);
        most = std::max(most, world_place("lantern").y);
    }
    EXPECT_GT(most - least, 0.01);  // with her steps
    EXPECT_LT(most - least, 0.2);
}

TEST_F(HeroTest, TheLanternGoesToTheHandInNoJump) {
    game.walk(0.4, 20);
    dvec3 before = world_place("lantern");
    PlayerInput take;
    take.held = kCarry;
    for (int i = 0; i < 60; ++i) {
        game.steps(1, i == 0 ? take : PlayerInput());
        EXPECT_LT(glm::distance(world_place("lantern"), before), 0.2) << i;
        before = world_place("lantern");
    }
}

TEST_F(HeroTest, HerHandDrawsInBeforeAWall) {
    game.walk(0.4, 20);
    game.press(kCarry);
    game.steps(30);
    EXPECT_EQ(game.of<Hand>("hero.hook").room, 1);
    game.walk(1, 120);  // against the door
    game.steps(30);
    EXPECT_LT(game.of<Hand>("hero.hook").room, 0.5);
    EXPECT_LT(world_place("lantern").x, -0.03 - 0.05);
}

TEST_F(HeroTest, TheCameraIsBehindHerAndInNoWall) {
    game.steps(60);
    EXPECT_EQ(game.world().resource<View>().camera, game.named("view"));
    EXPECT_NEAR(camera().back, camera().distance, 1e-9);
    EXPECT_LT(world_place("view").x, world_place("player").x - 1.5);
    // Through the door, and back against the wall beside it: as near as the wall is.
    game.walk(1, 1);
    game.press(kUse);
    game.steps(200);
    game.walk(1, 110);
    PlayerInput aside;
    aside.right = axis(1);
    game.steps(60, aside);
    game.walk(-1, 60);
    for (int i = 0; i < 120; ++i) {
        PlayerInput look_about;
        look_about.yaw = input::turn_units(0.05);
        game.steps(1, look_about);
        const physics::Physics& physics = *game.world().resource<std::shared_ptr<physics::Physics>>();
        const dvec3 at = world_place("view"), eye = world_place("eyes");
        // From her eyes nothing is before the camera, and no wall is at its near plane.
        const auto hit = physics.cast_ray(eye, at - eye, glm::distance(at, eye), game.named("player"));
        EXPECT_FALSE(hit.has_value()) << i;
        EXPECT_FALSE(std::abs(at.x) < 0.1 + 0.1 && at.y < 3 && std::abs(at.z) > 0.5) << i;
    }
    EXPECT_LE(camera().back, camera().distance);
}

TEST_F(HeroTest, WithHerEyesTheCameraIsBeforeHerHead) {
    game.press(kView);
    EXPECT_TRUE(camera().first_person);
    const dvec3 from_eye = world_place("view") - world_place("eyes");
    EXPECT_NEAR(from_eye.x, camera().ahead, 1e-9);
    EXPECT_NEAR(from_eye.y, 0, 1e-9);
    EXPECT_GT(world_place("view").x, world_place("hero.head").x + 0.15);
    // Her body looks where she looks, whichever way she walks.
    game.turn(1);
    game.walk(-1, 30);
    EXPECT_NEAR(turn_between(figure().yaw, game.of<Eyes>("eyes").yaw), 0, 1e-9);
    EXPECT_LT(figure().pace, 0);
    game.press(kView);
    EXPECT_FALSE(camera().first_person);
}

TEST_F(HeroTest, IsTheSameAtAnyNumberOfThreads) {
    Played other(level_with_hero().scene, test_options(2));
    for (Played* each : {&game, &other}) {
        each->walk(0.4, 20);
        each->press(kCarry);
        each->walk(1, 60);
        each->walk(-1, 60);
    }
    EXPECT_EQ(ecs::state_hashes(game.session.app().registry(), game.world()),
              ecs::state_hashes(other.session.app().registry(), other.world()));
}

TEST(Figure, OfAClipThatIsNotThereIsRefused) {
    scene_generator::Builder level = level_with_hero();
    std::ranges::find(level.scene.nodes, "hero", &NodeData::name)->extras =
        R"({"figure":{"idle":"hero.idle","walk":"swim"}})";
    try {
        Played game(level.scene);
        FAIL() << "it was taken";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("swim"), std::string::npos) << error.what();
    }
}

class FollowerTest : public testing::Test {
  protected:
    static SceneData level() {
        scene_generator::Builder level = test_level();
        scene_generator::add_follower(level, "puppet", {-4, 0, 0});
        return level.scene;
    }
    Played game{level()};
    double apart() {
        const dvec3 way = game.place("puppet") - game.place("player");
        return std::hypot(way.x, way.z);
    }
};

// It would be near and far at once.
TEST(FollowerLevel, RefusesOneThatStopsFartherOffThanItFollowsFrom) {
    for (const char* wrong : {R"({"follower":{"near":3,"far":1}})", R"({"follower":{"near":-1}})",
                              R"({"follower":{"far":101}})", R"({"follower":{"radius":0}})"}) {
        scene_generator::Builder level = test_level();
        scene_generator::add_follower(level, "puppet", {-4, 0, 0});
        std::ranges::find(level.scene.nodes, "puppet", &NodeData::name)->extras = wrong;
        try {
            Played game(level.scene);
            ADD_FAILURE() << wrong << " was taken";
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("node 'puppet'"), std::string::npos) << error.what();
        }
    }
}

TEST_F(FollowerTest, WaitsWhileSheIsNear) {
    game.steps(10);
    const dvec3 before = game.place("puppet");
    game.steps(30);
    EXPECT_EQ(game.place("puppet"), before);
    EXPECT_LT(apart(), game.of<Follower>("puppet").far);
}

TEST_F(FollowerTest, ComesAfterHerAndStops) {
    game.turn(3.14159265 / 2);  // along -Z, past the wall's end no way: she goes 6 m
    game.walk(1, 140);
    EXPECT_GT(apart(), 1);
    game.steps(300);
    EXPECT_LT(apart(), game.of<Follower>("puppet").far);
    EXPECT_GT(apart(), game.of<Follower>("puppet").near - 0.4);
    EXPECT_EQ(game.of<Follower>("puppet").velocity, dvec3(0));
    EXPECT_LT(std::abs(game.place("puppet").y), 1e-6);
}

TEST_F(FollowerTest, FollowsThroughADoorwayAndIsInNoWall) {
    game.walk(1, 60);
    game.press(kUse);
    game.steps(200);
    game.walk(1, 120);
    game.turn(3.14159265 / 2);
    game.walk(1, 90);  // behind the wall
    for (int i = 0; i < 600; ++i) {
        game.steps(1);
        const dvec3 at = game.place("puppet");
        EXPECT_FALSE(std::abs(at.x) < 0.1 + 0.15 && std::abs(at.z) > 0.5 && std::abs(at.z) < 4.5) << i;
    }
    EXPECT_GT(game.place("puppet").x, 0);
    EXPECT_LT(apart(), game.of<Follower>("puppet").far);
}

// A puppet that heeds her, 2 m before her.
SceneData level_with_a_bearer() {
    scene_generator::Builder level = test_level();
    scene_generator::add_lamp_bearer(level, "bearer", {-0.6, 0, 0}, vec3(1), 20);
    return level.scene;
}

TEST(LampBearer, WaitsUntilItIsToldToComeAndWhereItIsToldToWait) {
    Played game(level_with_a_bearer());
    const dvec3 start = game.place("bearer");
    game.walk(-1, 200);  // it would follow
    EXPECT_EQ(game.place("bearer"), start);
    game.press(kUse);  // out of her reach
    EXPECT_TRUE(game.of<Heeds>("bearer").waits);
    game.walk(1, 190);
    game.press(kUse);
    EXPECT_FALSE(game.of<Heeds>("bearer").waits);
    game.walk(-1, 200);
    game.steps(200);
    const dvec3 led = game.place("bearer");
    EXPECT_LT(led.x, start.x - 2);
    game.press(kUse);
    game.walk(-1, 200);
    game.steps(100);
    EXPECT_TRUE(game.of<Heeds>("bearer").waits);
    EXPECT_LT(glm::distance(game.place("bearer"), led), 0.05);
}

TEST(LampBearer, HoldsItsLanternOutBeforeIt) {
    Played game(level_with_a_bearer());
    game.steps(20);
    const dvec3 flame(game.of<WorldTransform>("bearer-flame").matrix[3]);
    const dvec3 feet = game.place("bearer");
    EXPECT_GT(flame.y, 0.7);
    EXPECT_LT(flame.y, 1.1);
    EXPECT_GT(glm::distance(dvec3(flame.x, 0, flame.z), dvec3(feet.x, 0, feet.z)), 0.3);
    // Upright, however the hand is turned.
    EXPECT_GT(glm::normalize(dvec3(game.of<WorldTransform>("bearer-flame").matrix[1])).y, 0.95);
}

TEST_F(FollowerTest, StepsBackAndIsInNobodysWay) {
    game.turn(3.14159265);
    game.walk(1, 200);  // right through where it stood
    EXPECT_LT(game.place("player").x, -6);
}

}  // namespace
}  // namespace lanthorn::game

// The things of levels: lanterns with glasses, crystals, shutters, what is pushed and what is turned.
#include <gtest/gtest.h>

#include <algorithm>

#include "lanthorn/ecs/snapshot.h"
#include "lanthorn/scene/asset_store.h"
#include "lanthorn/scene/light_sensor.h"
#include "tests/unit/game/test_level.h"

namespace lanthorn::game {
namespace {

using scene_generator::box;

// A lantern with two coloured glasses.
scene_generator::Builder level_with_glasses() {
    scene_generator::Builder level = test_level();
    std::ranges::find(level.scene.nodes, "lantern", &NodeData::name)->extras =
        R"({"lantern":{"slides":[[1,0.1,0.1],[0.1,0.2,1]]}})";
    return level;
}

TEST(Lantern, ShinesThroughItsGlassesInTurn) {
    Played game(level_with_glasses().scene);
    const auto colour = [&] { return game.of<LightComponent>("flame").light.colour; };
    EXPECT_EQ(colour(), vec3(1));
    game.press(kColour);
    EXPECT_EQ(colour(), vec3(1, 0.1f, 0.1f));
    game.press(kColour);
    EXPECT_EQ(colour(), vec3(0.1f, 0.2f, 1));
    game.press(kColour);
    EXPECT_EQ(colour(), vec3(1));
}

TEST(Lantern, IsDimmedByHalves) {
    Played game(test_level().scene);
    const auto candela = [&] { return game.of<LightComponent>("flame").light.intensity; };
    game.press(kDimUp);
    EXPECT_EQ(candela(), 15);
    game.press(kDimDown);
    EXPECT_EQ(candela(), 7.5f);
    for (int i = 0; i < 10; ++i) {
        game.press(kDimDown);
    }
    EXPECT_EQ(candela(), 15.0f / 8);
    // Put out, it stays so however it is turned; lit again it is as it was turned.
    game.press(kLight);
    game.press(kDimUp);
    EXPECT_FALSE(game.world().has<LightComponent>(game.named("flame")));
    game.press(kLight);
    EXPECT_EQ(candela(), 15.0f / 4);
}

// A crystal of its own material 4 m beyond the door, with a lamp in it.
scene_generator::Builder level_with_crystal() {
    scene_generator::Builder level = test_level();
    std::ranges::find(level.scene.nodes, "far", &NodeData::name)->extras = "";
    const std::uint32_t crystal = level.solid(
        "crystal", box(dvec3(-0.1), dvec3(0.1)), level.matte("crystal", vec3(0.5f)),
        R"({"light_sensor":{"filter":[1,-1,-1]},"crystal":{"lux":2,"seconds":0.5,"glow":[80,8,4]}})",
        scene_generator::at({4, 1, 2}));
    level.scene.nodes[crystal].meshes.push_back(
        level.mesh("behind", box({0.1, -0.1, -0.1}, {0.2, 0.1, 0.1}), level.matte("dark", vec3(0.125f))));
    Light inner;
    inner.intensity = 20;
    level.light("crystal-lamp", scene_generator::at({0, 0, 0}), inner, crystal);
    return level;
}

class CrystalTest : public testing::Test {
  protected:
    // Steps in which the crystal's sensor has read `lux`.
    void shine(float lux, int steps) {
        game.world().resource_mut<SensorInbox>().samples = {{game.named("crystal").index, 0, lux}};
        game.steps(steps);
    }
    const Crystal& crystal() { return game.of<Crystal>("crystal"); }
    // As the next picture has it.
    vec3 emissive(std::size_t mesh = 0) {
        game.session.app().show();
        const AssetStore& store = asset_store(game.world());
        return store.get(store.material_of(game.of<MeshInstances>("crystal").meshes.at(mesh))).emissive;
    }
    bool has_lamp() { return game.world().has<LightComponent>(game.named("crystal-lamp")); }

    Played game{level_with_crystal().scene};
};

TEST_F(CrystalTest, WakesOnceEnoughHasComeTogether) {
    game.steps(1);
    EXPECT_FALSE(has_lamp());
    shine(2.1f, 25);
    EXPECT_FALSE(crystal().awake);
    EXPECT_FALSE(solved(game.world()));
    shine(2.1f, 6);
    EXPECT_TRUE(crystal().awake);
    EXPECT_TRUE(solved(game.world()));
    shine(0, 120);
    EXPECT_TRUE(crystal().awake);
    EXPECT_EQ(crystal().glowing, 1);
    EXPECT_EQ(emissive(), vec3(80, 8, 4));
    EXPECT_EQ(emissive(1), vec3(20, 2, 1));  // a quarter as bright as the first
    ASSERT_TRUE(has_lamp());
    EXPECT_EQ(game.of<LightComponent>("crystal-lamp").light.intensity, 20);
}

TEST_F(CrystalTest, AStateThatIsRestoredGlowsWithoutAStep) {
    const ecs::Registry& registry = game.session.app().registry();
    const auto state = [&] { return ecs::Snapshot::save(game.world(), registry).to_bytes(); };
    const std::string asleep = state();
    shine(2.1f, 120);
    const std::string awake = state();
    ecs::Snapshot::from_bytes(asleep, registry, "asleep").restore(game.world());
    EXPECT_EQ(emissive(), vec3(0));
    ecs::Snapshot::from_bytes(awake, registry, "awake").restore(game.world());
    EXPECT_EQ(emissive(), vec3(80, 8, 4));
    EXPECT_EQ(emissive(1), vec3(20, 2, 1));
}

TEST_F(CrystalTest, AReadingThatFlickersDoesNotWakeIt) {
    for (int i = 0; i < 20; ++i) {
        shine(3, 10);
        shine(1, 10);
        EXPECT_LE(crystal().charge, 0.34);
    }
    EXPECT_FALSE(crystal().awake);
    EXPECT_EQ(emissive().y * 10, emissive().x);  // some of its glow shows
    shine(0, 300);
    EXPECT_EQ(crystal().charge, 0);
    EXPECT_EQ(emissive(), vec3(0));
    EXPECT_FALSE(has_lamp());
}

TEST(Solved, NeedsCrystalsAndGoalsAll) {
    scene_generator::Builder level = level_with_crystal();
    std::ranges::find(level.scene.nodes, "far", &NodeData::name)->extras =
        R"({"light_sensor":{"radius":1},"goal":{"lux":2}})";
    Played game(level.scene);
    game.world().get_mut<Crystal>(game.named("crystal")).awake = true;
    EXPECT_FALSE(solved(game.world()));
    game.world().get_mut<Goal>(game.named("far")).reached = true;
    EXPECT_TRUE(solved(game.world()));
    Played nothing_to_do([] {
        scene_generator::Builder bare = test_level();
        std::ranges::find(bare.scene.nodes, "far", &NodeData::name)->extras = "";
        return bare.scene;
    }());
    EXPECT_FALSE(solved(nothing_to_do.world()));
}

// The player stands at -2 and looks along +X.
TEST(Shutter, SlidesOpenAndShut) {
    scene_generator::Builder level = test_level();
    level.solid("shutter", box({-0.03, 0.01, -0.5}, {0.03, 1, 0.5}), 0,
                R"({"shutter":{"way":[0,1.5,0],"seconds":0.5},"body":{"type":"kinematic"}})",
                scene_generator::at({-0.8, 0, 0}));
    Played game(level.scene);
    game.press(kUse);
    game.steps(60);
    EXPECT_EQ(game.of<Shutter>("shutter").share, 1);
    EXPECT_NEAR(game.place("shutter").y, 1.5, 1e-9);
    game.press(kUse);
    game.steps(60);
    EXPECT_NEAR(game.place("shutter").y, 0, 1e-9);
}

TEST(Pushed, GoesAlongItsRailToItsEnd) {
    scene_generator::Builder level = test_level();
    level.solid("screen", box({-0.03, 0.01, -0.5}, {0.03, 2, 0.5}), 0,
                R"({"pushed":{"rail":[0.6,0,0]},"body":{"type":"kinematic"}})",
                scene_generator::at({-1.2, 0, 0}));
    Played game(level.scene);
    game.steps(30);
    EXPECT_EQ(game.place("screen").x, -1.2);
    game.walk(1, 60);
    EXPECT_GT(game.place("screen").x, -1.0);
    EXPECT_LT(game.place("player").x, game.place("screen").x - 0.28);
    game.walk(1, 120);
    EXPECT_NEAR(game.place("screen").x, -0.6, 1e-9);
    // Walking away leaves it there.
    game.walk(-1, 60);
    EXPECT_NEAR(game.place("screen").x, -0.6, 1e-9);
}

TEST(Shoved, RigidBodiesGoAheadOfHer) {
    scene_generator::Builder level = test_level();
    for (const auto& [name, z, mass] :
         {std::tuple("light", 0.0, 4), {"heavy", 6.0, 100}, {"behind", -6.0, 4}}) {
        level.solid(name, box({-0.2, 0, -0.2}, {0.2, 0.4, 0.2}), 0,
                    R"({"body":{"type":"dynamic","mass":)" + std::to_string(mass) + "}}",
                    scene_generator::at({-1.2, 0.001, z}));
    }
    Played game(level.scene);
    game.steps(60);
    EXPECT_NEAR(game.place("light").x, -1.2, 0.01);
    game.walk(1, 60);
    EXPECT_GT(game.place("light").x, -0.8);
    EXPECT_LT(game.place("player").x, game.place("light").x - 0.4);
    EXPECT_NEAR(game.place("heavy").x, -1.2, 0.01);
    EXPECT_NEAR(game.place("behind").x, -1.2, 0.01);
}

TEST(Turntable, TurnsWhileItIsUsed) {
    scene_generator::Builder level = test_level();
    level.solid("table", box({-0.2, 0.01, -0.2}, {0.2, 1, 0.2}), 0,
                R"({"turntable":{"speed":0.5},"body":{"type":"kinematic"}})",
                scene_generator::at({-1, 0, 0}));
    Played game(level.scene);
    PlayerInput use;
    use.held = kUse;
    game.steps(61, use);
    EXPECT_NEAR(game.of<Turntable>("table").angle, 0.5, 0.02);
    const double angle = game.of<Turntable>("table").angle;
    game.steps(60);
    EXPECT_EQ(game.of<Turntable>("table").angle, angle);
}

}  // namespace
}  // namespace lanthorn::game

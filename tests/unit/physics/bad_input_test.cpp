// What is wrong is named and skipped; the rest of the world goes on.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lanthorn/core/error.h"
#include "tests/support/shapes.h"
#include "tests/unit/physics/stage.h"

namespace lanthorn::physics::test {
namespace {

struct Case {
    const char* extras;
    const char* warning;  // part of it
};

class BadExtras : public testing::TestWithParam<Case> {};

TEST_P(BadExtras, AreNamedAndSkipped) {
    const auto [extras, warning] = GetParam();
    const Mesh cube = support::box(vec3(-1), vec3(1), false, 0);
    Stage stage;
    stage.add_floor();
    const ecs::Entity bad = stage.add("the bad one", extras, {0, 3, 0}, &cube);
    const ecs::Entity good =
        stage.add("good", R"({"body": {"type": "dynamic", "size": [1, 1, 1]}})", {9, 3, 0});
    stage.step(60);
    ASSERT_EQ(stage.warnings().size(), 1u) << extras;
    const std::string line = stage.warnings()[0];
    EXPECT_NE(line.find("'the bad one'"), std::string::npos) << line;
    EXPECT_NE(line.find(warning), std::string::npos) << line;
    EXPECT_EQ(stage.physics.body_count() + stage.physics.character_count(), 2u);
    EXPECT_EQ(stage.place(bad), dvec3(0, 3, 0));
    EXPECT_LT(stage.place(good).y, 1);
}

INSTANTIATE_TEST_SUITE_P(
    All, BadExtras,
    testing::Values(
        Case{R"({"body": {"type": "dynamic", "mass": 0}})",
             "body.mass is 0, expected a number more than 0 kg"},
        Case{R"({"body": {"type": "dynamic", "mass": -1}})", "body.mass is -1"},
        Case{R"({"body": {"type": "dynamic", "mass": null}})", "body.mass is null"},
        Case{R"({"body": {"type": "dynamic", "mass": "heavy"}})", "body.mass is \"heavy\""},
        Case{R"({"body": {"type": "dynamic", "mass": NaN}})", "extras are not JSON"},
        Case{R"({"body": {"type": "dynamic", "mass": 1e999}})", "extras are not JSON"},
        Case{R"({"body": {"type": "floating"}})", "body.type is \"floating\", expected one of 'static'"},
        Case{R"({"body": {"shape": "teapot"}})", "body.shape is \"teapot\""},
        Case{R"({"body": {"type": "dynamic", "shape": "mesh"}})",
             "body.shape is \"mesh\", expected 'convex'"},
        Case{R"({"body": {"friction": -0.1}})", "body.friction is -0.1"},
        Case{R"({"body": {"restitution": 1.5}})", "body.restitution is 1.5, expected a number from 0 to 1"},
        Case{R"({"body": {"size": [1, 0, 1]}})", "body.size is [1,0,1], expected three numbers more than 0"},
        Case{R"({"body": {"size": [1, 1]}})", "body.size is [1,1]"},
        Case{R"({"body": {"shape": "sphere", "radius": 0}})", "body.radius is 0"},
        Case{R"({"body": {"centre": "left"}})", "body.centre is \"left\""},
        Case{R"({"body": 7})", "body is 7, expected an object"},
        Case{R"({"body": [1, 2]})", "body is [1,2], expected an object"},
        Case{"\"\xff\" {", "extras are not JSON"},
        Case{R"({"character": {"radius": 1, "height": 1}})",
             "character.height is 1, expected at least twice"},
        Case{R"({"character": {"slopeLimit": 2}})", "character.slopeLimit is 2"},
        Case{R"({"character": "me"})", "character is \"me\", expected an object"}));

TEST(BadInput, AKeyThatIsNotKnownIsNamedButNotSkipped) {
    Stage stage;
    stage.add("crate", R"({"body": {"size": [1, 1, 1], "frictoin": 1}, "lantern": true})", dvec3(0));
    stage.step();
    ASSERT_EQ(stage.warnings().size(), 1u);
    EXPECT_EQ(stage.warnings()[0],
              "node 'crate': body.frictoin is not known, did you mean 'friction'?: ignored");
    EXPECT_EQ(stage.physics.body_count(), 1u);
}

TEST(BadInput, ExtrasOfOthersAreLeftAlone) {
    Stage stage;
    stage.add("a", R"({"door": {"opens": "left"}})", dvec3(0));
    stage.add("b", R"([1, 2, 3])", dvec3(0));
    stage.step();
    EXPECT_TRUE(stage.warnings().empty());
}

TEST(BadInput, MeshesThatMakeNoShape) {
    Mesh empty;
    Mesh point = support::box(vec3(1), vec3(1), false, 0);
    Mesh line = support::quad(vec3(0), vec3(1, 0, 0), vec3(1, 0, 0), 0);
    Mesh broken = support::box(vec3(-1), vec3(1), false, 0);
    for (Vertex& v : broken.vertices) {
        v.position.y = std::numeric_limits<float>::quiet_NaN();
    }
    struct Shaped {
        const Mesh* mesh;
        const char* shape;
        const char* warning;
    };
    for (const Shaped& s :
         {Shaped{nullptr, "box", "no vertices"}, Shaped{&empty, "convex", "no vertices"},
          Shaped{&broken, "sphere", "no vertices"}, Shaped{&point, "box", "one point alone"},
          Shaped{&line, "mesh", "no triangle with an area"}}) {
        Stage stage;
        stage.add("thing", std::string(R"({"body": {"shape": ")") + s.shape + "\"}}", dvec3(0), s.mesh);
        stage.step(2);
        ASSERT_EQ(stage.warnings().size(), 1u) << s.warning;
        EXPECT_NE(stage.warnings()[0].find(s.warning), std::string::npos) << stage.warnings()[0];
        EXPECT_EQ(stage.physics.body_count(), 0u);
    }
}

TEST(BadInput, ABrokenVertexIsLeftOut) {
    Mesh cube = support::box(vec3(-1), vec3(1), false, 0);
    cube.vertices[0].position.x = std::numeric_limits<float>::infinity();
    for (const char* shape : {"box", "convex", "sphere", "capsule"}) {
        Stage stage;
        stage.add_floor();
        const ecs::Entity crate =
            stage.add("crate", std::string(R"({"body": {"type": "dynamic", "shape": ")") + shape + "\"}}",
                      {0, 1.1, 0}, &cube);
        stage.step(60);
        EXPECT_NEAR(stage.place(crate).y, 1, 0.02) << shape;
    }
}

TEST(BadInput, TransformsThatAreNotNumbersOrFlat) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const char* crate = R"({"body": {"type": "dynamic", "size": [1, 1, 1]}})";
    Stage stage;
    stage.add_floor();
    stage.add("nowhere", crate, {nan, 0, 0});
    stage.add("flat", crate, {3, 3, 0}, nullptr, {1, 0, 0, 0}, vec3(1, 0, 0));
    const ecs::Entity good = stage.add("good", crate, {0, 0.5, 0});
    stage.step(30);
    EXPECT_EQ(stage.warnings().size(), 2u);
    EXPECT_EQ(stage.physics.body_count(), 2u);
    // A game that writes NaN into a body that was fine: it stays, and the NaN goes.
    stage.world.get_mut<LocalTransform>(good).value.translation.y = nan;
    stage.step(30);
    EXPECT_EQ(stage.warnings().size(), 3u);
    EXPECT_NEAR(stage.place(good).y, 0.5, 5e-3);
    stage.push(good, {nan, 0, 0});
    stage.step(30);
    EXPECT_EQ(stage.warnings().size(), 4u);
    EXPECT_NEAR(stage.place(good).y, 0.5, 5e-3);
    EXPECT_NEAR(stage.motion(good)->linear.x, 0, 1e-2);
}

TEST(BadInput, ACharacterWithoutASpeedStands) {
    Stage stage;
    stage.add_floor();
    const ecs::Entity walker = stage.add("walker", R"({"character": {}})", {0, 0.1, 0});
    stage.world.add(walker, CharacterInput{{std::numeric_limits<double>::quiet_NaN(), 0, 0}, false});
    stage.step(60);
    EXPECT_EQ(stage.warnings().size(), 1u);
    EXPECT_NEAR(stage.place(walker).x, 0, 1e-9);
}

TEST(BadInput, SettingsOutOfRangeThrow) {
    EXPECT_THROW(Physics({.time_step = 0}), InputError);
    EXPECT_THROW(Physics({.time_step = std::nan("")}), InputError);
    EXPECT_THROW(Physics({.gravity = dvec3(0, std::nan(""), 0)}), InputError);
    EXPECT_THROW(Physics({.solver_iterations = 0}), InputError);
}

}  // namespace
}  // namespace lanthorn::physics::test

#include "lanthorn/lamplighter/lamplighter.h"

#include <gtest/gtest.h>

#include "lanthorn/core/error.h"
#include "lanthorn/scene/light_sensor.h"
#include "tests/unit/game/test_level.h"

namespace lanthorn::game {
namespace {

std::string refusal(const SceneData& scene) {
    try {
        Playthrough playthrough(test_options(), scene);
    } catch (const Error& e) {
        return e.what();
    }
    return "";
}

TEST(Level, IsWhatItsExtrasSay) {
    Played game(test_level().scene);
    EXPECT_EQ(game.of<Door>("door").open_angle, 1.9);
    EXPECT_EQ(game.of<Lantern>("lantern").flame, game.named("flame"));
    EXPECT_EQ(game.of<LightSensor>("far").radius, 1);
    EXPECT_NEAR(game.of<Eyes>("eyes").yaw, -0.5 * 3.14159265358979, 1e-6);
    EXPECT_EQ(game.session.app().view().camera, game.named("eyes"));
}

TEST(Level, NeedsOnePlayerWithEyes) {
    scene_generator::Builder none = test_level();
    for (NodeData& node : none.scene.nodes) {
        if (node.name == "player") {
            node.extras = "";
        }
    }
    EXPECT_NE(refusal(none.scene).find("test.glb: nodes: found 0 with extras {\"player\": {}}, expected one"),
              std::string::npos)
        << refusal(none.scene);

    scene_generator::Builder two = test_level();
    add_player(two, {3, 0, 3});
    EXPECT_NE(refusal(two.scene).find("found 2"), std::string::npos);

    for (const char* name : {"player", "eyes"}) {
        scene_generator::Builder wrong = test_level();
        for (NodeData& node : wrong.scene.nodes) {
            if (node.name == name && node.name == "player") {
                node.extras = R"({"player":{}})";  // no character
            } else if (node.name == name) {
                node.camera = kNone;
            }
        }
        EXPECT_NE(refusal(wrong.scene).find(std::string("node '") + name + "'"), std::string::npos)
            << refusal(wrong.scene);
    }
}

TEST(Level, RefusesExtrasThatAreNoComponents) {
    for (const char* extras : {R"({"door":{"open_angle":"wide"}})", R"({"door":{"open_angle":9}})",
                               R"({"door":{"opne_angle":1}})", R"({"door":7})", R"({"collider":"ball"})"}) {
        scene_generator::Builder level = test_level();
        add_door(level, "odd", {3, 0, 3}, extras);
        const std::string message = refusal(level.scene);
        EXPECT_NE(message.find("test.glb: node 'odd': "), std::string::npos) << extras << ": " << message;
        EXPECT_EQ(message.find('\n'), std::string::npos);
    }
}

TEST(Level, HasOneTitle) {
    scene_generator::Builder level = test_level();
    for (const char* name : {"about", "about-too"}) {
        level.scene.nodes[level.node(name, {})].extras = R"({"level":{"title":"A test"}})";
    }
    const std::string message = refusal(level.scene);
    EXPECT_EQ(message, "test.glb: nodes: found 2 with extras {\"level\": {}}, expected one at most");
}

TEST(Level, ALanternThatIsOutIsDark) {
    scene_generator::Builder level = test_level();
    for (NodeData& node : level.scene.nodes) {
        if (node.name == "lantern") {
            node.extras = R"({"lantern":{"lit":false}})";
        }
    }
    Played game(level.scene);
    EXPECT_FALSE(game.world().has<LightComponent>(game.named("flame")));
    game.press(kLight);
    EXPECT_EQ(game.of<LightComponent>("flame").light.intensity, 15);
}

TEST(Level, RefusesSeveralLightsBelowOneThing) {
    const char* crystal = R"({"light_sensor":{},"crystal":{}})";
    for (const char* extras : {R"({"lantern":{}})", crystal}) {
        scene_generator::Builder level = test_level();
        const std::uint32_t thing = level.node("thing", {});
        level.scene.nodes[thing].extras = extras;
        level.light("first", {}, {}, thing);
        EXPECT_EQ(refusal(level.scene), "");
        level.light("second", {}, {}, thing);
        EXPECT_EQ(refusal(level.scene),
                  "test.glb: node 'thing': has several lights below it, expected one at most");
    }
}

TEST(Level, RefusesALanternBelowAnotherNode) {
    scene_generator::Builder level = test_level();
    for (NodeData& node : level.scene.nodes) {
        if (node.name == "flame") {
            node.extras = R"({"lantern":{}})";
        }
    }
    EXPECT_NE(refusal(level.scene).find("expected a root node"), std::string::npos);
}

}  // namespace
}  // namespace lanthorn::game

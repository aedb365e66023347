// The editor's commands, each on a room.
#include <gtest/gtest.h>

#include <map>

#include "lanthorn/core/error.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/light_sensor.h"
#include "tests/support/repository.h"
#include "tools/editor/core/command.h"
#include "tools/editor/core/edit_session.h"
#include "tools/editor/core/edit_world.h"
#include "tools/editor/core/node_path.h"
#include "tools/editor/core/node_value.h"

namespace lanthorn::editor {
namespace {

class Commands : public testing::Test {
  protected:
    Commands() { session.new_room(); }
    std::string value(const std::string& path, const std::string& field) {
        return node_value(session.model(), session.registry(), session.node_at(path), field);
    }
    std::string refusal(const std::string& line) {
        const std::string before = session.document().json_text();
        const std::size_t steps = session.steps().position();
        try {
            session.run(line);
        } catch (const InputError& error) {
            EXPECT_EQ(session.document().json_text(), before) << line;
            EXPECT_EQ(session.steps().position(), steps) << line;
            return error.what();
        }
        return "no error";
    }
    EditSession session;
};

TEST(Words, KeepWhatIsInQuotesAndBrackets) {
    EXPECT_EQ(words_of(R"(set "/a b/\"c\"" door {"x": [1, 2]} # why)"),
              (std::vector<std::string>{"set", "/a b/\"c\"", "door", "{\"x\": [1, 2]}"}));
    EXPECT_EQ(words_of("  # nothing"), std::vector<std::string>());
    EXPECT_THROW(words_of("move \"/a"), InputError);
    EXPECT_THROW(words_of("set /a b {"), InputError);
    for (const std::string text : {"plain", "two words", "", "#1", "a\"b\\c", "{not json", "line\nend"}) {
        EXPECT_EQ(words_of(word(text)), std::vector<std::string>{text});
    }
}

TEST_F(Commands, MoveTurnAndScale) {
    session.run("move /room/lamp 1 2 0.5");
    EXPECT_EQ(value("/room/lamp", "translation"), "[1,2,0.5]");
    session.run("rotate /room/lamp 0 90 0");
    EXPECT_TRUE(means_the_same(value("/room/lamp", "rotation"), "[0,0.70710678,0,0.70710678]"));
    session.run("scale /room/lamp 2");
    EXPECT_EQ(value("/room/lamp", "scale"), "[2,2,2]");
    EXPECT_EQ(refusal("move /room/lamp 1 2"), "move: found 3 words behind it, expected move PATH X Y Z");
    EXPECT_EQ(refusal("move /room/lamp 1 2 x"), "move: found 'x', expected a number");
    EXPECT_EQ(refusal("move /room/lump 1 2 3"), "'/room/lump': '/room' has no 'lump'; 'lamp' comes nearest");
    EXPECT_EQ(refusal("mov /room/lamp 1 2 3"), "found 'mov', expected a command ('move' comes nearest)");
    EXPECT_EQ(refusal("scale /room/lamp 0"), "scale: found 0, expected a size that leaves something to see");
    EXPECT_NE(refusal("move /room/lamp 1e300 0 0"), "no error");
}

TEST_F(Commands, TheWorldFollows) {
    session.run("move /room/lamp 1 2 0.5");
    const ecs::Entity e = session.entity_of(session.node_at("/room/lamp"));
    EXPECT_EQ(session.world().get<LocalTransform>(e).value.translation, dvec3(1, 2, 0.5));
    session.run("set /room/lamp light.intensity 310");
    EXPECT_EQ(session.world().get<LightComponent>(e).light.intensity, 310);
    EXPECT_EQ(session.entity_of(session.node_at("/room/lamp")), e);
    session.run("hide /room");
    EXPECT_FALSE(session.world().has<LightComponent>(e));
    session.undo();
    EXPECT_TRUE(session.world().has<LightComponent>(e));
    session.run("delete /room/lamp");
    EXPECT_FALSE(session.world().alive(e));
}

TEST_F(Commands, LightsInEveryUnit) {
    session.run("set /room/lamp light.colour [1,1,1]");
    session.run("set /room/lamp light.intensity 800lm");
    EXPECT_TRUE(means_the_same(value("/room/lamp", "light.intensity"), "63.661978"));
    EXPECT_TRUE(means_the_same(value("/room/lamp", "light.lumen"), "800"));
    session.run("set /room/lamp light.intensity 40lx");
    EXPECT_TRUE(means_the_same(value("/room/lamp", "light.lux"), "40"));
    session.run("set /room/lamp light.colour 2700K");
    const double kelvin = std::stod(value("/room/lamp", "light.kelvin"));
    EXPECT_NEAR(kelvin, 2700, 10);
    session.run("set /room/lamp light.type spot");
    session.run("set /room/lamp light.outer_cone 30deg");
    EXPECT_TRUE(means_the_same(value("/room/lamp", "light.outer_cone"), "0.5235988"));
    session.run("set /room/lamp light.range 5");
    session.run("set /room/lamp light.range inf");
    EXPECT_EQ(value("/room/lamp", "light.range"), "\"inf\"");
    EXPECT_NE(refusal("set /room/lamp light.intensity -1").find("expected"), std::string::npos);
    EXPECT_NE(refusal("set /room/lamp light.inner_cone 1").find("less than outer_cone"), std::string::npos);
    EXPECT_NE(refusal("set /room/floor light.intensity 1").find("has no light"), std::string::npos);
    EXPECT_NE(refusal("set /room/lamp light.colour 200K").find("1000 to 20000"), std::string::npos);
}

TEST_F(Commands, ComponentsAndTheExtrasOfOthers) {
    session.run("set /room/lamp light_sensor.radius 0.25");
    const ecs::Entity e = session.entity_of(session.node_at("/room/lamp"));
    EXPECT_EQ(session.world().get<LightSensor>(e).radius, 0.25f);
    EXPECT_EQ(value("/room/lamp", "extras.light_sensor.radius"), "0.25");
    EXPECT_NE(refusal("set /room/lamp light_sensor.radius 1000").find("100"), std::string::npos);
    EXPECT_NE(refusal("set /room/lamp light_senser.radius 1").find("light_sensor"), std::string::npos);
    session.run(R"(set /room/lamp extras.other_program {"kept": [1, "as", null]})");
    EXPECT_EQ(value("/room/lamp", "extras.other_program.kept"), R"([1,"as",null])");
    session.run("unset /room/lamp light_sensor");
    EXPECT_FALSE(session.world().has<LightSensor>(e));
    EXPECT_EQ(value("/room/lamp", "extras.other_program.kept"), R"([1,"as",null])");
}

// Nodes, of the document, that bend each skinned mesh.
std::map<std::uint32_t, std::vector<std::uint32_t>> joints_of(EditSession& session) {
    const ecs::World& world = session.world();
    std::map<std::uint32_t, std::vector<std::uint32_t>> result;
    for (const ecs::Entity e : world.query<ecs::With<SkinInstance>>().entities()) {
        for (const ecs::Entity joint : world.get<SkinInstance>(e).joints) {
            result[world.get<EditedNode>(e).node].push_back(world.get<EditedNode>(joint).node);
        }
    }
    return result;
}

TEST_F(Commands, ACopyOfJointsBendsNothingWhereverItStands) {
    session.open(support::repository_file("assets/puppet.glb"));
    const auto joints = joints_of(session);
    ASSERT_EQ(joints.size(), 2u) << "body and cape";
    session.run("duplicate /puppet/puppet.hips copy");
    EXPECT_EQ(joints_of(session), joints);
    session.run("reparent /puppet/copy /floor");  // before the puppet
    EXPECT_EQ(joints_of(session), joints);
    session.run("undo 2");
    EXPECT_EQ(joints_of(session), joints);
}

TEST_F(Commands, NodesComeAndGo) {
    const std::size_t before = session.model().node_count();
    session.run("add-node / shelf 1 0 0");
    session.run("add-light /shelf candle point 0 0.5 0 12cd 1900K");
    EXPECT_TRUE(means_the_same(value("/shelf/candle", "light.intensity"), "12"));
    session.run("duplicate /shelf");
    EXPECT_TRUE(means_the_same(value("/shelf-2/candle", "light.intensity"), "12"));
    session.run("set /shelf-2/candle light.intensity 3");  // a light of its own
    EXPECT_TRUE(means_the_same(value("/shelf/candle", "light.intensity"), "12"));
    session.run("reparent /shelf-2/candle /");
    EXPECT_TRUE(means_the_same(value("/candle", "translation"), "[1,0.5,0]"));
    session.run("group corner /candle /shelf");
    EXPECT_EQ(value("/corner/shelf", "parent"), "\"/corner\"");
    session.run("rename /corner \"a/b #1\"");
    EXPECT_EQ(value("/a~1b ~21/shelf", "name"), "\"shelf\"");
    EXPECT_NE(refusal("reparent \"/a~1b ~21\" \"/a~1b ~21/shelf\"").find("stands under"), std::string::npos);
    session.run("delete \"/a~1b ~21\"");
    session.run("delete /shelf-2");
    EXPECT_EQ(session.model().node_count(), before);
    session.run("undo 2");
    EXPECT_EQ(value("/a~1b ~21/shelf", "name"), "\"shelf\"");
}

TEST_F(Commands, NodesOfOneNameAreToldApart) {
    session.run("add-node / twin 1 0 0");
    session.run("add-node / twin 2 0 0");
    EXPECT_NE(refusal("move /twin 0 0 0").find("several 'twin'"), std::string::npos);
    std::vector<std::string> paths;
    for (const std::uint32_t node : session.model().in_order()) {
        if (session.model().node(node).name == "twin") {
            paths.push_back(session.path_of(node));
        }
    }
    ASSERT_EQ(paths.size(), 2u);
    EXPECT_NE(paths[0], paths[1]);
    session.run("move " + paths[1] + " 5 0 0");
    EXPECT_EQ(value(paths[1], "translation"), "[5,0,0]");
    EXPECT_EQ(value(paths[0], "translation"), "[1,0,0]");
}

TEST_F(Commands, AGestureIsOneStep) {
    const std::string before = session.document().json_text();
    session.begin("drag the lamp");
    for (int i = 1; i <= 20; ++i) {
        const std::string line = "move /room/lamp " + std::to_string(i) + " 2 0";
        session.preview(std::span(&line, 1));
        EXPECT_EQ(session.document().json_text(), before);
        const ecs::Entity e = session.entity_of(session.node_at("/room/lamp"));
        EXPECT_EQ(session.world().get<LocalTransform>(e).value.translation.x, i);
    }
    EXPECT_THROW(session.run("undo"), InputError);
    session.cancel();
    EXPECT_EQ(value("/room/lamp", "translation"), "[0,2.4,0]");
    EXPECT_EQ(session.steps().position(), 0u);
    const std::vector<std::string> both{"move /room/lamp 1 2 0", "set /room/lamp light.intensity 9"};
    session.run("brighter, and there", both);
    EXPECT_EQ(session.steps().position(), 1u);
    EXPECT_EQ(session.history().back().text, "brighter, and there");
    session.undo();
    EXPECT_EQ(session.document().json_text(), before);
    const std::vector<std::string> wrong{"move /room/lamp 1 2 0", "move /nobody 1 2 0"};
    EXPECT_THROW(session.run("half of it", wrong), InputError);
    EXPECT_FALSE(session.in_gesture());
    EXPECT_EQ(value("/room/lamp", "translation"), "[0,2.4,0]");
}

TEST_F(Commands, UndoBringsTheSelectionOfItsStep) {
    const std::uint32_t lamp = session.node_at("/room/lamp"), floor = session.node_at("/room/floor");
    session.select({lamp});
    session.run("move /room/lamp 1 2 0");
    session.select({floor});
    session.undo();
    EXPECT_EQ(session.selection(), std::vector<std::uint32_t>{lamp});
    EXPECT_FALSE(session.is_dirty() && session.steps().position() != 0);
}

TEST_F(Commands, EveryCommandIsListedWithItsUse) {
    for (const CommandHelp& help : command_list()) {
        EXPECT_TRUE(help.usage.starts_with(help.name)) << help.name;
        EXPECT_NE(refusal(help.name), "no error") << help.name;
    }
}

}  // namespace
}  // namespace lanthorn::editor

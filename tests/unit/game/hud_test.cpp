// What the words on the picture say, and where; hints; and a level that is gone on with.
#include "game/screens/hud.h"

#include <algorithm>

#include "game/level/hints.h"
#include "game/rules/figures.h"
#include "lanthorn/ecs/snapshot.h"
#include "lanthorn/ecs/world_hash.h"
#include "tests/unit/game/test_level.h"
#include "tools/scene_generator/hero_figure.h"

namespace lanthorn::game {
namespace {

constexpr float kAspect = 16.0f / 9;

std::vector<std::string> words(const Hud& hud) {
    std::vector<std::string> all;
    for (const HudLabel& label : hud.labels) {
        all.push_back(label.words);
    }
    return all;
}

TEST(LookAbout, NamesWhatIsAtHandTheNearestFirst) {
    Played played(test_level().scene);
    played.steps(2);
    const Hud hud = look_about(played.world(), kAspect);
    EXPECT_EQ(words(hud), (std::vector<std::string>{"take the lantern", "put it out", "open the door"}));
    EXPECT_EQ(hud.labels[2].action, Action::use);
    EXPECT_FALSE(hud.carries);
    // The door is straight ahead and its middle below the eyes, the lantern to the right and lower still.
    EXPECT_NEAR(hud.labels[2].place.x, 0.5f, 0.02f);
    EXPECT_GT(hud.labels[2].place.y, 0.5f);
    EXPECT_GT(hud.labels[0].place.x, 0.6f);
    EXPECT_GT(hud.labels[0].place.y, hud.labels[2].place.y);
}

TEST(LookAbout, FollowsWhatIsDone) {
    Played played(test_level().scene);
    played.steps(2);
    played.press(kUse);
    played.press(kCarry);
    const Hud hud = look_about(played.world(), kAspect);
    EXPECT_EQ(words(hud), std::vector<std::string>{"close the door"});
    EXPECT_TRUE(hud.carries);
    EXPECT_TRUE(hud.lit);
    EXPECT_EQ(hud.glasses, 0);
}

TEST(LookAbout, SaysWhatAPuppetThatHeedsHerWouldDo) {
    scene_generator::Builder level = test_level();
    scene_generator::add_lamp_bearer(level, "bearer", {-0.6, 0, -0.4}, vec3(1), 20);
    Played played(level.scene);
    played.steps(2);
    const std::vector<std::string> before = words(look_about(played.world(), kAspect));
    EXPECT_EQ(std::ranges::count(before, "come along"), 1);
    played.world().get_mut<Heeds>(played.named("bearer")).waits = false;
    const std::vector<std::string> after = words(look_about(played.world(), kAspect));
    EXPECT_EQ(std::ranges::count(after, "wait here"), 1);
    EXPECT_EQ(std::ranges::count(after, "come along"), 0);
}

TEST(LookAbout, SaysNothingOfWhatIsFarOrBehind) {
    Played played(test_level().scene);
    played.steps(2);
    played.turn(3.1);
    EXPECT_TRUE(words(look_about(played.world(), kAspect)).empty());
    played.turn(-3.1);
    played.walk(-1, 120);
    EXPECT_TRUE(words(look_about(played.world(), kAspect)).empty());
}

// A crystal 3 m ahead of the player, behind the closed door or before it.
std::vector<HudMark> marks(double x) {
    scene_generator::Builder b = test_level();
    const std::uint32_t crystal = b.node("crystal", scene_generator::at({x, 1.2, 0}));
    b.scene.nodes[crystal].extras = R"({"light_sensor":{},"crystal":{"symbol":"moon"}})";
    Played played(b.scene);
    played.steps(2);
    return look_about(played.world(), kAspect).marks;
}

TEST(LookAbout, MarksTheCrystalsInSight) {
    const std::vector<HudMark> seen = marks(-0.7);
    ASSERT_EQ(seen.size(), 1u);
    EXPECT_EQ(seen[0].symbol, Symbol::moon);
    EXPECT_NEAR(seen[0].distance, std::hypot(1.3, 0.42), 0.05);
    EXPECT_NEAR(seen[0].place.x, 0.5f, 0.02f);
    EXPECT_TRUE(marks(1.5).empty());   // behind the door
    EXPECT_TRUE(marks(-4.0).empty());  // behind her
}

TEST(Hints, GetPlainerAndGo) {
    Hints hints;
    EXPECT_EQ(hints.shown(), "");
    hints.ask({"faint", "plain"});
    EXPECT_EQ(hints.shown(), "faint");
    hints.pass(Hints::kShownSeconds + 1);
    EXPECT_EQ(hints.shown(), "");
    hints.ask({"faint", "plain"});
    hints.ask({"faint", "plain"});
    EXPECT_EQ(hints.shown(), "plain");
    hints.ask({});
    EXPECT_NE(hints.shown(), "");
}

// What is kept of a level in play, brought into another session of it: the same world, and it goes on.
TEST(Continue, ALevelGoesOnAsItWasLeft) {
    const SceneData scene = test_level().scene;
    Played first(scene);
    first.press(kCarry);
    first.press(kUse);
    first.walk(1, 40);
    const ecs::Registry& registry = first.session.app().registry();
    const std::string state = ecs::Snapshot::save(first.world(), registry).to_bytes();

    Played second(scene);
    second.steps(3);
    const ecs::Registry& other = second.session.app().registry();
    ecs::Snapshot::from_bytes(state, other, "progress").restore(second.world());
    EXPECT_EQ(ecs::state_hashes(other, second.world()), ecs::state_hashes(registry, first.world()));
    EXPECT_TRUE(second.of<Lantern>("lantern").carried);

    first.walk(1, 60);
    second.walk(1, 60);
    // The swing of the lantern differs a little: bodies of the second session follow with its next step.
    EXPECT_EQ(second.place("player"), first.place("player"));
    EXPECT_EQ(second.of<Door>("door"), first.of<Door>("door"));
    EXPECT_LT(glm::distance(second.place("lantern"), first.place("lantern")), 0.05);
}

}  // namespace
}  // namespace lanthorn::game

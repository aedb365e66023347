// What is heard of what happens in a level.
#include "game/presentation/sound/ear.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <map>

#include "lanthorn/runtime/time.h"
#include "lanthorn/runtime/view.h"
#include "tests/unit/game/test_level.h"

namespace lanthorn::game {
namespace {

bool has(const std::vector<Sound>& sounds, audio::Kind kind) {
    return std::ranges::count(sounds, kind, &Sound::kind) > 0;
}

// The test level with one more of everything that moves, and somebody who listens after every step.
class Listening {
  public:
    Listening() : game_(level()) { ear_.listen(game_.world()); }

    static SceneData level() {
        scene_generator::Builder b = test_level();
        std::ranges::find(b.scene.nodes, "lantern", &NodeData::name)->extras =
            R"({"lantern":{"slides":[[1,0.1,0.1]]}})";
        return b.scene;
    }

    Heard step(const PlayerInput& input = {}) {
        game_.steps(1, input);
        Heard heard = ear_.listen(game_.world());
        for (const Sound& sound : heard.begun) {
            ++count[sound.kind];
        }
        return heard;
    }
    void press(Button button) {
        PlayerInput input;
        input.held = button;
        step(input);
        step();
    }

    Played& game() { return game_; }
    std::map<audio::Kind, int> count;

  private:
    Played game_;
    Ear ear_;
};

TEST(Ear, HearsWhatIsDoneWithALantern) {
    Listening game;
    game.press(kCarry);
    EXPECT_EQ(game.count[SoundKind::take], 1);
    game.press(kLight);
    EXPECT_EQ(game.count[SoundKind::lantern_off], 1);
    game.press(kLight);
    EXPECT_EQ(game.count[SoundKind::lantern_on], 1);
    game.press(kDimDown);
    EXPECT_EQ(game.count[SoundKind::darker], 1);
    game.press(kDimUp);
    EXPECT_EQ(game.count[SoundKind::brighter], 1);
    game.press(kColour);
    EXPECT_EQ(game.count[SoundKind::glass], 1);
    game.press(kCarry);
    EXPECT_EQ(game.count[SoundKind::put_down], 1);
    // Nothing of it twice, and nothing else.
    EXPECT_TRUE(std::ranges::all_of(game.count, [](const auto& each) { return each.second == 1; }));
    EXPECT_EQ(game.count.size(), 7u);
}

TEST(Ear, HearsStepsWhereTheFeetAre) {
    Listening game;
    PlayerInput input;
    input.right = axis(-1);  // along the wall
    const dvec3 start = game.game().of<WorldTransform>("player").matrix[3];
    dvec3 last = start;
    int steps = 0;
    for (int i = 0; i < 180; ++i) {
        for (const Sound& sound : game.step(input).begun) {
            EXPECT_TRUE(sound.kind == SoundKind::step_left || sound.kind == SoundKind::step_right);
            last = sound.place;
            ++steps;
        }
    }
    const double walked = glm::distance(start, last);
    EXPECT_GT(walked, 3);
    EXPECT_NEAR(steps, walked / Ear::kStride, 1);
    EXPECT_LE(std::abs(game.count[SoundKind::step_left] - game.count[SoundKind::step_right]), 1);
    for (int i = 0; i < 60; ++i) {
        game.step();
    }
    for (int i = 0; i < 60; ++i) {
        EXPECT_TRUE(game.step().begun.empty());
    }
}

TEST(Ear, HearsADoorAsLongAsItMovesAndWhenItFallsShut) {
    Listening game;
    PlayerInput use;
    use.held = kUse;
    const auto moves = [&](int most) {
        int steps = 0;
        while (has(game.step().going, SoundKind::door_moves) && steps < most) {
            ++steps;
        }
        return steps;
    };
    EXPECT_TRUE(has(game.step(use).going, SoundKind::door_moves));
    const int opening = moves(600);
    EXPECT_GT(opening, 20);
    EXPECT_LT(opening, 600);
    EXPECT_EQ(game.count[SoundKind::door_shut], 0);
    PlayerInput nearer;
    nearer.forward = axis(1);
    for (int i = 0; i < 25; ++i) {
        game.step(nearer);
    }
    game.step(use);
    EXPECT_GT(moves(600), 20);
    EXPECT_EQ(game.count[SoundKind::door_shut], 1);
}

// One thing at (3, 0, 0), which a test alters from one step to the next.
template <class T>
class Altered {
  public:
    explicit Altered(const T& first) {
        world_.insert_resource(Time{});
        world_.insert_resource(View{});
        thing_ = world_.create(first, WorldTransform{glm::translate(dmat4(1), dvec3(3, 0, 0))});
        ear_.listen(world_);
    }
    Heard after(const T& now) {
        world_.get_mut<T>(thing_) = now;
        ++world_.resource_mut<Time>().steps;
        return ear_.listen(world_);
    }

  private:
    ecs::World world_;
    ecs::Entity thing_;
    Ear ear_;
};

void expect_going(const Heard& heard, audio::Kind kind) {
    ASSERT_EQ(heard.going.size(), 1u);
    EXPECT_EQ(heard.going[0].kind, kind);
    EXPECT_EQ(heard.going[0].place, dvec3(3, 0, 0));
}

TEST(Ear, HearsWhatSlidesAndTurnsWhileItDoes) {
    Altered<Shutter> shutter(Shutter{});
    expect_going(shutter.after({.share = 0.4}), SoundKind::shutter_slides);
    EXPECT_TRUE(shutter.after({.share = 0.4}).going.empty());
    EXPECT_TRUE(has(shutter.after({.share = 1}).begun, SoundKind::shutter_stops));
    Altered<Pushed> screen(Pushed{});
    expect_going(screen.after({.share = 0.1}), SoundKind::pushed);
    EXPECT_TRUE(screen.after({.share = 0.1}).going.empty());
    Altered<Turntable> table(Turntable{});
    expect_going(table.after({.angle = 0.1}), SoundKind::turned);
}

Crystal charged(double charge) {
    Crystal crystal;
    crystal.charge = charge;
    crystal.awake = charge == 1;
    return crystal;
}

TEST(Ear, HearsACrystalChargeHigherAndHigherAndWake) {
    Altered<Crystal> crystal(Crystal{});
    const Heard early = crystal.after(charged(0.2)), late = crystal.after(charged(0.7));
    expect_going(early, SoundKind::crystal_charges);
    expect_going(late, SoundKind::crystal_charges);
    EXPECT_GT(late.going[0].pitch, early.going[0].pitch);
    EXPECT_GT(late.going[0].gain, early.going[0].gain);
    EXPECT_TRUE(crystal.after(charged(0.6)).going.empty());
    const Heard awake = crystal.after(charged(1));
    EXPECT_TRUE(has(awake.begun, SoundKind::crystal_wakes));
    EXPECT_TRUE(has(awake.begun, SoundKind::solved));
    EXPECT_TRUE(crystal.after(charged(1)).begun.empty());
}

TEST(Ear, HearsNothingOfAnotherLevelOrStateAndNothingTwiceBetweenSteps) {
    Listening game;
    PlayerInput carry;
    carry.held = kCarry;
    game.game().steps(1, carry);
    Ear fresh;
    EXPECT_TRUE(fresh.listen(game.game().world()).begun.empty());
    Listening other;
    EXPECT_TRUE(has(other.step(carry).begun, SoundKind::take));
    Ear ear;
    ear.listen(other.game().world());
    EXPECT_TRUE(ear.listen(other.game().world()).begun.empty());
}

}  // namespace
}  // namespace lanthorn::game

// From screen to screen.
#include "game/screens/screens.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>
#include <vector>

namespace lanthorn::game {
namespace {

constexpr std::array kAll = {Happening::play,    Happening::begin,  Happening::choose,  Happening::pause,
                             Happening::back,    Happening::levels, Happening::options, Happening::controls,
                             Happening::title,   Happening::reset,  Happening::solved,  Happening::next,
                             Happening::credits, Happening::quit};

// A player's way: each happening, the screen that it leads to, what is to be done.
struct Turn {
    Event event;
    Screen screen;
    Effect effect = Effect::none;
};

Screens walk(Screens state, const std::vector<Turn>& turns) {
    for (std::size_t i = 0; i < turns.size(); ++i) {
        const Change change = follow(state, turns[i].event);
        EXPECT_EQ(change.to.at, turns[i].screen) << "turn " << i;
        EXPECT_EQ(change.effect, turns[i].effect) << "turn " << i;
        state = change.to;
    }
    return state;
}

TEST(Screens, AFirstGameBeginsWithTheFirstLevel) {
    const Screens played = walk({.levels = 6}, {{{Happening::begin}, Screen::play, Effect::load}});
    EXPECT_EQ(played.level, 0);
    EXPECT_TRUE(played.begun);
}

TEST(Screens, ContinueGoesOnWhereTheLevelStands) {
    const Screens state{.level = 3, .levels = 6, .begun = true};
    EXPECT_EQ(walk(state, {{{Happening::play}, Screen::play}}).level, 3);
    EXPECT_EQ(follow({.levels = 6}, {Happening::play}).to.at,
              Screen::title);  // there is nothing to go on with
}

TEST(Screens, OptionsLeadBackToWhereTheyCameFrom) {
    walk({}, {{{Happening::options}, Screen::options}, {{Happening::back}, Screen::title}});
    walk({.at = Screen::paused},
         {{{Happening::options}, Screen::options}, {{Happening::back}, Screen::paused}});
    walk({.at = Screen::paused},
         {{{Happening::levels}, Screen::levels}, {{Happening::back}, Screen::paused}});
}

TEST(Screens, CreditsLeadBackToWhereTheyCameFrom) {
    walk({}, {{{Happening::credits}, Screen::credits}, {{Happening::back}, Screen::title}});
    walk({.at = Screen::finished},
         {{{Happening::credits}, Screen::credits}, {{Happening::back}, Screen::finished}});
    walk({.at = Screen::play}, {{{Happening::credits}, Screen::play}});
}

TEST(Screens, ControlsLeadBackToOptionsAndThoseToWhereTheyCameFrom) {
    walk({.at = Screen::paused}, {{{Happening::options}, Screen::options},
                                  {{Happening::controls}, Screen::controls},
                                  {{Happening::back}, Screen::options},
                                  {{Happening::back}, Screen::paused}});
}

TEST(Screens, ALevelIsPlayedPausedResetAndLeft) {
    walk({.levels = 2}, {{{Happening::levels}, Screen::levels},
                         {{Happening::choose, 1}, Screen::play, Effect::load},
                         {{Happening::pause}, Screen::paused, Effect::keep},
                         {{Happening::back}, Screen::play},
                         {{Happening::pause}, Screen::paused, Effect::keep},
                         {{Happening::reset}, Screen::restart},
                         {{Happening::reset}, Screen::play, Effect::load},
                         {{Happening::pause}, Screen::paused, Effect::keep},
                         {{Happening::title}, Screen::title, Effect::keep},
                         {{Happening::play}, Screen::play}});
}

TEST(Screens, ARestartAsksAndCanBeRefused) {
    const Screens played{.at = Screen::play, .level = 1, .levels = 3, .begun = true};
    walk(played, {{{Happening::reset}, Screen::restart}, {{Happening::back}, Screen::play}});
    walk(played, {{{Happening::pause}, Screen::paused, Effect::keep},
                  {{Happening::reset}, Screen::restart},
                  {{Happening::back}, Screen::paused},
                  {{Happening::reset}, Screen::restart},
                  {{Happening::play}, Screen::play}});
    walk(played, {{{Happening::reset}, Screen::restart},
                  {{Happening::title}, Screen::restart},
                  {{Happening::solved}, Screen::restart},
                  {{Happening::reset}, Screen::play, Effect::load}});
}

TEST(Screens, ASolvedLevelLeadsToTheNextAndTheLastToTheTitle) {
    Screens state{.at = Screen::play, .level = 0, .levels = 2, .begun = true};
    state = walk(state, {{{Happening::solved}, Screen::finished, Effect::keep},
                         {{Happening::next}, Screen::play, Effect::load}});
    EXPECT_EQ(state.level, 1);
    walk(state, {{{Happening::solved}, Screen::finished, Effect::keep}, {{Happening::next}, Screen::title}});
}

TEST(Screens, TheLastLevelLeadsToTheFirstThatIsNotSolved) {
    Screens state{.at = Screen::finished, .level = 2, .levels = 3, .begun = true};
    state.unsolved = 1;
    EXPECT_EQ(walk(state, {{{Happening::next}, Screen::play, Effect::load}}).level, 1);
    state.level = 0;
    EXPECT_EQ(walk(state, {{{Happening::next}, Screen::play, Effect::load}}).level, 1)
        << "the next, solved or not";
    state.unsolved = 0;
    EXPECT_EQ(walk(state, {{{Happening::next}, Screen::play, Effect::load}}).level, 1);
}

TEST(Screens, WhoStaysIsNotToldAgain) {
    Screens state{.at = Screen::play, .levels = 2, .begun = true};
    state = walk(state, {{{Happening::solved}, Screen::finished, Effect::keep},
                         {{Happening::play}, Screen::play},
                         {{Happening::solved}, Screen::play}});
    walk(state, {{{Happening::reset}, Screen::restart},
                 {{Happening::reset}, Screen::play, Effect::load},
                 {{Happening::solved}, Screen::finished, Effect::keep}});
}

TEST(Screens, WhatIsRecordedOrReplayedDoesNotBeginAgain) {
    walk({.at = Screen::play, .begun = true, .once = true},
         {{{Happening::reset}, Screen::play, Effect::refuse},
          {{Happening::pause}, Screen::paused, Effect::keep},
          {{Happening::reset}, Screen::paused, Effect::refuse},
          {{Happening::levels}, Screen::levels},
          {{Happening::choose, 0}, Screen::levels, Effect::refuse},
          {{Happening::back}, Screen::paused},
          {{Happening::title}, Screen::title, Effect::keep},
          {{Happening::begin}, Screen::title, Effect::refuse},
          {{Happening::play}, Screen::play}});
}

TEST(Screens, OnlyLevelsThatThereAreCanBeChosen) {
    const Screens choice{.at = Screen::levels, .levels = 3};
    for (const int level : {-1, 3, 1000}) {
        EXPECT_EQ(follow(choice, {Happening::choose, level}).to, choice);
    }
}

// From everything that can be reached: one can leave the game, a level that is asked for exists, and the menu
// key alone leads out of every screen but the title.
TEST(Screens, AreNoTraps) {
    const auto key = [](const Screens& s) { return std::tuple(s.at, s.back, s.level, s.begun, s.stayed); };
    std::vector<Screens> open{{.levels = 3}};
    std::set<decltype(key(open[0]))> seen{key(open[0])};
    while (!open.empty()) {
        const Screens state = open.back();
        open.pop_back();
        EXPECT_EQ(follow(state, {Happening::quit}).effect, Effect::quit);
        if (state.at != Screen::title && state.at != Screen::play) {
            EXPECT_NE(follow(state, {Happening::back}).to.at, state.at);
        }
        for (const Happening what : kAll) {
            for (int level = -1; level < 4; ++level) {
                const Change change = follow(state, {what, level});
                EXPECT_GE(change.to.level, 0);
                EXPECT_LT(change.to.level, 3);
                EXPECT_EQ(is_played(change.to.at) && change.effect == Effect::none && !change.to.begun,
                          false);
                if (seen.insert(key(change.to)).second) {
                    open.push_back(change.to);
                }
            }
        }
    }
    EXPECT_GT(seen.size(), 20u);
}

}  // namespace
}  // namespace lanthorn::game

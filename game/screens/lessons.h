// Teaching by doing: which keys stand at the picture's lower edge. A key stands bright until it was used
// once, what can be done with a lantern faintly as long as one is carried.
#pragma once

#include <array>
#include <bitset>
#include <vector>

#include "game/rules/actions.h"
#include "game/screens/hud.h"

namespace lanthorn::game {

// What the player has done since the frame before.
struct Doing {
    std::bitset<kActions> used = {};
    bool walked = false;  // a stick counts
    double turned = 0;    // radians that the view turned
};

// Keys at the lower edge, and what they do.
struct Prompt {
    std::vector<Action> actions;  // empty: what looks about, which has no action
    const char* words = "";       // English
    float strength = 1;           // 0 to 1
};

class Lessons {
  public:
    static constexpr double kWalkSeconds = 0.8;   // that are learned by
    static constexpr double kTurn = 0.7;          // radians, likewise
    static constexpr double kAlwaysSeconds = 10;  // that the keys of always stand there
    static constexpr double kStuckSeconds = 60;   // after which they come again

    // A frame of play has passed.
    void pass(const Doing& doing, double seconds);
    // Another level comes: what was learned stays so.
    void begin_level() { played_ = asked_ = 0; }

    // The most important first.
    std::vector<Prompt> prompts(const Hud& hud) const;
    bool knows(Action action) const { return used_[static_cast<std::size_t>(action)]; }

  private:
    std::bitset<kActions> used_;
    double walked_ = 0, turned_ = 0;
    double played_ = 0, asked_ = 0;  // seconds in the level, and when a hint was asked for
};

}  // namespace lanthorn::game

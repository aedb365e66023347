// The tour in a window: every level plays itself, one after another.
#pragma once

#include "game/level/level_in_window.h"
#include "game/rules/lingering.h"

namespace lanthorn::game {

class TourInWindow {
  public:
    // Of a frame: whether the `number`-th level's tour has ended, and been looked at, so that the next one
    // may come. A level that its tour has not solved is said on stderr.
    bool pass(const LevelInWindow& level, int number, double seconds);
    bool solved_all() const { return !unsolved_; }  // that it has ended

  private:
    Lingering lingering_;
    bool unsolved_ = false;
};

}  // namespace lanthorn::game

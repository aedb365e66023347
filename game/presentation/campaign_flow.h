// The way through the campaign: which level runs behind which screen, and what leads from one to another.
// Knows neither window nor devices.
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "game/level/level_in_window.h"
#include "game/presentation/options.h"
#include "game/presentation/progress_file.h"
#include "game/presentation/tour_in_window.h"
#include "game/rules/lingering.h"
#include "game/screens/notices.h"
#include "game/screens/screens.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/stop_signal.h"

namespace lanthorn::game {

class CampaignFlow {
  public:
    // What it asks of the window around it.
    struct Stage {
        std::function<void()> announce;             // a level comes, which takes a second or two
        std::function<shell::Spending()> spending;  // with which it is drawn
        std::function<PlayerInput()> input;         // of a step
    };
    CampaignFlow(const Options& options, Notices& notices, Stage stage);

    // To the title, with the level behind it that the player goes on with; where the options name a level or
    // ask for a tour, straight into that. Throws InputError if that one cannot be loaded.
    void begin();
    // What the player does on a screen, or what happens in a level. A level that cannot be loaded is said.
    void follow(const Event& event);
    // A frame of play has passed: the next level comes, or words, where this one is done.
    void pass(double seconds);

    // The level in play is another, or in another state, than at the call before: what is remembered of it is
    // of no use.
    bool takes_loaded() { return std::exchange(loaded_, false); }

    const Screens& screens() const { return screens_; }
    LevelInWindow& level() { return level_; }
    const LevelInWindow& level() const { return level_; }
    const ProgressFile& progress() const { return progress_; }
    // It plays itself: a tour, a replay.
    bool plays_itself() const { return options_.tour || !options_.replay.empty(); }
    // The player has left, or what plays itself is at its end.
    bool ended() const;

    // After the last frame: keeps what the player has reached and closes a recording. A replay that has
    // diverged, and a tour that has not solved its levels, fail.
    ExitCode end(const StopSignal& stop);

  private:
    void resume();
    std::optional<int> next_unsolved(int level) const;
    void load(int level);
    void keep_progress();

    const Options& options_;
    Notices& notices_;
    Stage stage_;
    ProgressFile progress_;
    LevelInWindow level_;
    Screens screens_;
    TourInWindow tour_;
    Lingering solved_;  // since the level in play is
    bool quit_ = false;
    bool loaded_ = false;
};

}  // namespace lanthorn::game

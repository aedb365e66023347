// A session: the simulation together with what drives it and what is kept of it.
#pragma once

#include <optional>
#include <string>

#include "game/options.h"
#include "game/simulation.h"
#include "game/tour.h"
#include "lanthorn/replay/player.h"
#include "lanthorn/replay/recorder.h"

namespace lanthorn::game {

// Where a session's input comes from: the player at the devices, a script, or a recording.
enum class Driver { devices, tour, recording };

class Session {
  public:
    // Reads the recording if options name one; where that is cut off, says so on stderr and replays what is
    // whole. Throws InputError if it does not fit the level, or if the session cannot be recorded.
    Session(const Options& options, const Level& level);

    Driver driver() const { return driver_; }
    // Steps until the tour or the recording ends; unknown for the devices.
    std::optional<std::uint64_t> length() const;
    bool done() const;

    // One simulation step. `input` counts only with Driver::devices.
    void step(const PlayerInput& input = {});

    // The state after the last step, and the one before.
    const View& view() const { return after_; }
    const View& view_before() const { return before_; }
    std::uint64_t steps() const { return simulation_.steps(); }

    // Where a replay first differed.
    const std::optional<replay::Divergence>& divergence() const;

    // Ends the recording if one was asked for; it is written while the session runs, and stays without this.
    void finish();
    // Whether the recording broke off, which step() or finish() said on stderr when it happened.
    bool recording_failed() const { return recorder_ && !recorder_->failure().empty(); }

  private:
    void say_failure();

    Driver driver_;
    std::optional<replay::Player> player_;  // before simulation_: its seed is the recording's
    Simulation simulation_;
    Tour tour_;
    std::optional<replay::Recorder> recorder_;
    bool said_failure_ = false;
    View before_, after_;
};

}  // namespace lanthorn::game

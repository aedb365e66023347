// A session: the simulation together with what drives it and what is kept of it.
#pragma once

#include <optional>
#include <string>

#include "game/options.h"
#include "game/simulation.h"
#include "game/tour.h"
#include "lanthorn/replay/recorder.h"

namespace lanthorn::game {

// Where a session's input comes from: the player at the devices, a script, or a recording.
enum class Driver { devices, tour, recording };

class Session {
  public:
    // Reads the recording if options name one. Throws InputError if it does not fit the level.
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

    // Writes the recording if one was asked for.
    void finish() const;

  private:
    Driver driver_;
    std::string record_path_;
    std::optional<replay::Player> player_;  // before simulation_: its seed is the recording's
    Simulation simulation_;
    Tour tour_;
    std::optional<replay::Recorder> recorder_;
    View before_, after_;
};

}  // namespace lanthorn::game

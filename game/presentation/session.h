// A session: the game in an App, together with what drives it and what is kept of it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "game/presentation/options.h"
#include "game/presentation/tour.h"
#include "game/rules/player_input.h"
#include "lanthorn/core/stop_signal.h"
#include "lanthorn/replay/player.h"
#include "lanthorn/replay/recorder.h"
#include "lanthorn/replay/sensor_check.h"
#include "lanthorn/runtime/app.h"
#include "lanthorn/scene/light_sensor.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn::game {

// Where a session's input comes from: the player at the devices, a script, or a recording.
enum class Driver { devices, tour, recording };

// Adds two systems to the fixed steps: session.begin, before the game's own, says what comes in; session.end
// takes down or checks what came of it. So a session is whole however the App is run: by step(), frame() or
// show_at().
class Session {
  public:
    // Loads the level into an App without pictures; reads the recording if options name one, and where that
    // is cut off, says so on stderr and replays what is whole. Throws InputError if the level is none, if the
    // recording does not fit it, or if the session cannot be recorded.
    Session(const Options& options, const SceneData& scene);
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    App& app() { return app_; }
    const App& app() const { return app_; }
    // Asked in every step of Driver::devices; without it the player does nothing.
    void set_devices(std::function<PlayerInput()> devices) { devices_ = std::move(devices); }

    Driver driver() const { return driver_; }
    // Of photons: the recording's in a replay.
    std::uint64_t seed() const { return player_ ? player_->seed() : seed_; }
    // Steps until the tour or the recording ends; unknown for the devices. Steps beyond get no input and are
    // neither recorded nor checked.
    std::optional<std::uint64_t> length() const;
    bool done() const { return length() && steps() >= *length(); }
    std::uint64_t steps() const { return app_.time().steps; }

    // Where a replay first differed, in one line; empty if it did not.
    std::string divergence() const;

    // Ends the recording if one was asked for; it is written while the session runs, and stays without this.
    void finish();
    // Where `stop` ended the session before its time, says on stderr how far it came.
    void say_stopped(const StopSignal& stop) const;
    // Whether the recording broke off, which was said on stderr when it happened.
    bool recording_failed() const { return recorder_ && !recorder_->failure().empty(); }

  private:
    void begin(ecs::World& world);
    void end();
    void compare_sensors(const SensorInbox& fresh);
    void replay_sensors(SensorInbox& inbox) const;
    std::vector<replay::SensorReading> readings(const SensorInbox& inbox) const;
    replay::RecordingHeader header(const std::string& level_path) const;
    void say_failure();

    App app_;
    Driver driver_;
    std::uint64_t seed_;
    std::vector<ecs::Entity> sensors_;  // in the order of RecordingHeader::sensors
    std::optional<Tour> tour_;
    std::function<PlayerInput()> devices_;
    std::optional<replay::Player> player_;
    std::optional<replay::SensorCheck> sensor_check_;
    std::optional<replay::Recorder> recorder_;
    bool said_failure_ = false;
    // Of the step under way.
    bool counts_ = false;
    PlayerInput input_;
    std::vector<replay::SensorReading> readings_;
};

}  // namespace lanthorn::game

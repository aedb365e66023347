#include "game/session.h"

#include "lanthorn/core/atomic_file.h"

namespace lanthorn::game {

namespace {

Driver driver_of(const Options& options) {
    if (!options.replay.empty()) {
        return Driver::recording;
    }
    return options.headless ? Driver::tour : Driver::devices;
}

std::optional<replay::Player> open_recording(const Options& options, const Level& level) {
    if (options.replay.empty()) {
        return std::nullopt;
    }
    replay::Recording recording = replay::read_recording(options.replay);
    const Simulation like(level, 0, 1);
    return replay::Player(options.replay, std::move(recording), recording_header(like, options.level, 0));
}

}  // namespace

Session::Session(const Options& options, const Level& level)
    : driver_(driver_of(options)),
      record_path_(options.record),
      player_(open_recording(options, level)),
      simulation_(level, player_ ? player_->seed() : options.seed, options.threads),
      tour_(level),
      before_(simulation_.view()),
      after_(before_) {
    if (!record_path_.empty()) {
        check_writable(record_path_);
        recorder_.emplace(recording_header(simulation_, options.level, options.seed));
    }
}

std::optional<std::uint64_t> Session::length() const {
    switch (driver_) {
        case Driver::tour:
            return Tour::kSteps;
        case Driver::recording:
            return player_->recording().steps.size();
        case Driver::devices:
            break;
    }
    return std::nullopt;
}

bool Session::done() const {
    return length() && steps() >= *length();
}

void Session::step(const PlayerInput& input) {
    before_ = after_;
    PlayerInput taken = input;
    std::span<const replay::SensorReading> readings;
    if (driver_ == Driver::tour) {
        taken = tour_.next(after_, steps());
    } else if (driver_ == Driver::recording) {
        taken = player_->input<PlayerInput>();
        readings = player_->sensors();
    }
    simulation_.step(taken, readings);
    after_ = simulation_.view();
    if (player_) {
        player_->check(simulation_.hashes());
    }
    if (recorder_) {
        recorder_->add(taken, readings, simulation_.hashes());
    }
}

const std::optional<replay::Divergence>& Session::divergence() const {
    static const std::optional<replay::Divergence> none;
    return player_ ? player_->divergence() : none;
}

void Session::finish() const {
    if (recorder_) {
        recorder_->write(record_path_);
    }
}

}  // namespace lanthorn::game

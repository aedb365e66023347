#include "game/session.h"

#include <cstdio>

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
    if (!recording.cut_off.empty()) {
        std::fprintf(stderr, "lamplighter: %s: %s\n", options.replay.c_str(), recording.cut_off.c_str());
    }
    const Simulation like(level, 0, 1);
    return replay::Player(options.replay, std::move(recording), recording_header(like, options.level, 0));
}

}  // namespace

Session::Session(const Options& options, const Level& level)
    : driver_(driver_of(options)),
      player_(open_recording(options, level)),
      simulation_(level, player_ ? player_->seed() : options.seed, options.threads),
      tour_(level),
      before_(simulation_.view()),
      after_(before_) {
    if (!options.record.empty()) {
        recorder_.emplace(options.record, recording_header(simulation_, options.level, options.seed));
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
        say_failure();
    }
}

const std::optional<replay::Divergence>& Session::divergence() const {
    static const std::optional<replay::Divergence> none;
    return player_ ? player_->divergence() : none;
}

void Session::finish() {
    if (recorder_) {
        recorder_->finish();
        say_failure();
    }
}

void Session::say_failure() {
    if (recording_failed() && !said_failure_) {
        std::fprintf(stderr, "lamplighter: %s\n", recorder_->failure().c_str());
        said_failure_ = true;
    }
}

}  // namespace lanthorn::game

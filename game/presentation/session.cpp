#include "game/presentation/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "engine/build_info/build_info.h"
#include "game/level/level.h"
#include "game/rules/game_plugin.h"
#include "lanthorn/ecs/world_hash.h"
#include "lanthorn/replay/content_hash.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/runtime/sensor_plugin.h"
#include "lanthorn/scene/components.h"

namespace lanthorn::game {

namespace {

Driver driver_of(const Options& options) {
    if (!options.replay.empty()) {
        return Driver::recording;
    }
    return options.headless || options.tour ? Driver::tour : Driver::devices;
}

std::vector<ecs::Entity> sensors_of(const ecs::World& world) {
    std::vector<ecs::Entity> sensors = world.query<ecs::With<LightSensor>>().entities();
    std::ranges::sort(sensors);
    return sensors;
}

}  // namespace

Session::Session(const Options& options, const SceneData& scene)
    : driver_(driver_of(options)), seed_(options.seed) {
    add_scene_plugins(app_);
    // Runs alone, so that what is added after it comes after it.
    app_.fixed_schedule()
        .add("session.begin", [this](ecs::World& world) { begin(world); })
        .after("restore")
        .before("gameplay.end");
    app_.add<SensorPlugin>().add<GamePlugin>();
    app_.fixed_schedule().add("session.end", [this](ecs::World&) { end(); }).after("remember");
    app_.set_threads(options.threads);
    load_level(app_, scene);
    sensors_ = sensors_of(app_.world());
    tour_.emplace(app_.world());
    if (driver_ == Driver::recording) {
        replay::Recording recording = replay::read_recording(options.replay);
        if (!recording.cut_off.empty()) {
            std::fprintf(stderr, "lamplighter: %s: %s\n", options.replay.c_str(), recording.cut_off.c_str());
        }
        sensor_check_.emplace(recording);
        player_.emplace(options.replay, std::move(recording), header(options.level));
    }
    if (!options.record.empty()) {
        recorder_.emplace(options.record, header(options.level));
    }
}

replay::RecordingHeader Session::header(const std::string& level_path) const {
    replay::RecordingHeader header;
    header.level = std::filesystem::path(level_path).filename().string();
    header.level_hash = replay::hash_file(level_path);
    header.seed = seed();
    header.step_rate = kStepsPerSecond;
    header.build = build_words();
    header.input_format = kInputFormat;
    header.input_size = sizeof(PlayerInput);
    header.parts = ecs::state_parts(app_.registry());
    for (const ecs::Entity sensor : sensors_) {
        const Name* name = app_.world().try_get<Name>(sensor);
        header.sensors.push_back(name != nullptr ? name->value : ecs::to_string(sensor));
    }
    return header;
}

std::optional<std::uint64_t> Session::length() const {
    switch (driver_) {
        case Driver::tour:
            return tour_->steps();
        case Driver::recording:
            return player_->recording().steps.size();
        case Driver::devices:
            break;
    }
    return std::nullopt;
}

// App::step() has counted the step that begins.
void Session::begin(ecs::World& world) {
    const std::uint64_t step = steps() - 1;
    counts_ = !length() || step < *length();
    input_ = {};
    SensorInbox& inbox = world.resource_mut<SensorInbox>();
    compare_sensors(inbox);
    if (driver_ == Driver::tour) {
        input_ = counts_ ? tour_->next(world, step) : PlayerInput();
    } else if (driver_ == Driver::recording) {
        input_ = counts_ ? player_->input<PlayerInput>() : PlayerInput();
        replay_sensors(inbox);
    } else if (devices_) {
        input_ = devices_();
    }
    readings_ = readings(inbox);
    world.resource_mut<PlayerInput>() = input_;
}

void Session::end() {
    if (!counts_ || (!player_ && !recorder_)) {
        return;
    }
    std::vector<std::uint64_t> hashes = ecs::state_hashes(app_.registry(), app_.world());
    if (player_) {
        player_->check(hashes);
    }
    if (recorder_) {
        recorder_->add(input_, readings_, std::move(hashes));
        say_failure();
    }
}

void Session::compare_sensors(const SensorInbox& fresh) {
    if (!sensor_check_) {
        return;
    }
    for (const SensorSample& sample : fresh.samples) {
        const auto found = std::ranges::find(sensors_, sample.id, &ecs::Entity::index);
        sensor_check_->check(static_cast<std::uint32_t>(found - sensors_.begin()), sample.step,
                             static_cast<double>(sample.lux));
    }
}

void Session::replay_sensors(SensorInbox& inbox) const {
    inbox.samples.clear();
    if (counts_) {
        for (const replay::SensorReading& reading : player_->sensors()) {
            inbox.samples.push_back(
                {sensors_[reading.sensor].index, steps() - 1 - reading.age, reading.value});
        }
    }
}

std::vector<replay::SensorReading> Session::readings(const SensorInbox& inbox) const {
    std::vector<replay::SensorReading> readings;
    for (const SensorSample& sample : inbox.samples) {
        const auto found = std::ranges::find(sensors_, sample.id, &ecs::Entity::index);
        if (found != sensors_.end()) {
            readings.push_back({static_cast<std::uint32_t>(found - sensors_.begin()),
                                static_cast<std::uint32_t>(steps() - 1 - sample.step), sample.lux});
        }
    }
    return readings;
}

std::string Session::divergence() const {
    if (player_ && player_->divergence()) {
        return player_->divergence()->describe();
    }
    return sensor_check_ && sensor_check_->divergence() ? sensor_check_->divergence()->describe() : "";
}

void Session::finish() {
    if (recorder_) {
        recorder_->finish();
        say_failure();
    }
}

void Session::say_stopped(const StopSignal& stop) const {
    if (!stop.asked()) {
        return;
    }
    std::string line = fmt::format("{}: stopped after {}", stop.name(), steps());
    if (length()) {
        line += fmt::format(" of {}", *length());
    }
    line += " steps";
    if (recorder_ && !recording_failed()) {
        line += ", which are in " + recorder_->path();
    }
    std::fprintf(stderr, "lamplighter: %s\n", line.c_str());
}

void Session::say_failure() {
    if (recording_failed() && !said_failure_) {
        std::fprintf(stderr, "lamplighter: %s\n", recorder_->failure().c_str());
        said_failure_ = true;
    }
}

}  // namespace lanthorn::game

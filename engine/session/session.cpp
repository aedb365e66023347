#include "lanthorn/session/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "engine/core/crash_report.h"
#include "engine/session/sensor_readings.h"
#include "lanthorn/core/error.h"
#include "lanthorn/ecs/world_hash.h"
#include "lanthorn/replay/player.h"
#include "lanthorn/replay/recorder.h"
#include "lanthorn/replay/sensor_check.h"
#include "lanthorn/runtime/scene_plugins.h"

namespace lanthorn::session {

struct Session::State {
    State(const App& app, InputStream stream, Config made)
        : inputs(std::move(stream)), config(std::move(made)), sensors(app.world()), input(inputs.size()) {}

    InputStream inputs;
    Config config;
    SensorReadings sensors;
    std::optional<replay::Player> player;
    std::optional<replay::SensorCheck> sensor_check;
    std::optional<replay::Recorder> recorder;
    bool warned = false;            // of the recorder's failure
    std::optional<Moment> present;  // during a visit to the past
    // Of the step under way.
    bool counts = false;
    std::vector<std::byte> input;
    std::vector<replay::SensorReading> readings;

    void warn(const std::string& line) const {
        if (config.warn) {
            config.warn(line);
        } else {
            std::fprintf(stderr, "%s\n", line.c_str());
        }
    }
    void read_sensors(SensorInbox& inbox, std::uint64_t step);
    replay::RecordingHeader header(const App& app) const;
};

replay::RecordingHeader Session::State::header(const App& app) const {
    replay::RecordingHeader header;
    header.level = config.content;
    header.level_hash = config.content_hash;
    header.seed = player ? player->seed() : config.seed;
    header.step_rate = kStepsPerSecond;
    header.build = config.build;
    header.input_format = inputs.format();
    header.input_size = inputs.size();
    header.parts = ecs::state_parts(app.registry());
    header.schemas = ecs::state_schemas(app.registry());
    header.sensors = sensors.names();
    return header;
}

// What has come back in the meantime is compared, what was recorded enters.
void Session::State::read_sensors(SensorInbox& inbox, std::uint64_t step) {
    std::erase_if(inbox.samples, [&](const SensorSample& sample) { return sample.step > step; });
    if (player) {
        sensors.compare(inbox, *sensor_check);
        inbox = counts ? sensors.replayed(player->sensors(), step) : SensorInbox();
    }
    readings = sensors.recorded(inbox, step);
}

Session::Session(App& app, InputStream inputs, Config config)
    : app_(app), state_(std::make_unique<State>(app, std::move(inputs), std::move(config))) {
    if (!app.has("scene") || app.time().steps != 0) {
        throw Error(
            ExitCode::bad_input,
            fmt::format("session: found an App {}, expected one with ScenePlugin before its first step",
                        app.has("scene") ? "with steps" : "without ScenePlugin"));
    }
    State& state = *state_;
    std::shared_ptr<const replay::Recording> recording = std::move(state.config.recording);
    if (const std::string& file = state.config.replay; !recording && !file.empty()) {
        recording = std::make_shared<replay::Recording>(replay::read_recording(file));
        if (!recording->cut_off.empty()) {
            state.warn(fmt::format("{}: {}", file, recording->cut_off));
        }
    }
    if (recording) {
        state.sensor_check.emplace(*recording);
        state.player.emplace(state.config.replay, recording, state.header(app));
    }
    if (!state.config.record.empty()) {
        state.recorder.emplace(state.config.record, state.header(app), state.config.annotations);
    }
    state.inputs.make_none(state.input);
    state.inputs.give(app.world(), state.input);
    app.fixed_schedule()
        .add("session.begin", [this](ecs::World& world) { begin(world); })
        .after("restore")
        .before("gameplay.begin");
    // Runs alone: after all that was added before it.
    app.fixed_schedule().add("session.end", [this](ecs::World&) { end(); }).after("remember");
}

Session::~Session() = default;

std::uint64_t Session::seed() const {
    return state_->player ? state_->player->seed() : state_->config.seed;
}

std::optional<std::uint64_t> Session::length() const {
    return state_->player ? state_->player->recording().steps.size() : state_->inputs.length();
}

// App::step() has counted the step that begins.
void Session::begin(ecs::World& world) {
    State& state = *state_;
    const std::uint64_t step = steps() - 1;
    state.counts = !length() || step < *length();
    if (!state.counts) {
        state.inputs.make_none(state.input);
    } else if (state.player) {
        std::ranges::copy(state.player->input_bytes(), state.input.begin());
    } else {
        state.inputs.make(world, step, state.input);
    }
    if (world.try_resource<SensorInbox>() != nullptr) {
        state.read_sensors(world.resource_mut<SensorInbox>(), step);
    }
    state.inputs.give(world, state.input);
}

void Session::end() {
    State& state = *state_;
    const bool records = state.recorder && !state.present;
    if (!state.counts || (!state.player && !records)) {
        return;
    }
    const std::vector<std::uint64_t> hashes = ecs::state_hashes(app_.registry(), app_.world());
    if (state.player) {
        state.player->check(hashes);
    }
    if (records) {
        state.recorder->add(state.input, state.readings, hashes);
        warn_of_failure();
    }
    note_step(steps());
}

std::string Session::divergence() const {
    const State& state = *state_;
    if (state.player && state.player->divergence()) {
        return state.player->divergence()->describe();
    }
    return state.sensor_check && state.sensor_check->divergence()
               ? state.sensor_check->divergence()->describe()
               : "";
}

const replay::Comparison* Session::comparison() const {
    return state_->player ? &state_->player->comparison() : nullptr;
}

bool Session::apart() const {
    return state_->player && state_->player->apart();
}

const replay::SensorCheck* Session::sensor_check() const {
    return state_->sensor_check ? &*state_->sensor_check : nullptr;
}

void Session::finish() {
    if (state_->recorder) {
        state_->recorder->finish();
        warn_of_failure();
    }
}

bool Session::recording_failed() const {
    return state_->recorder && !state_->recorder->failure().empty();
}

std::string Session::stopped(const StopSignal& stop) const {
    if (!stop.asked()) {
        return "";
    }
    std::string line = fmt::format("{}: stopped after {}", stop.name(), steps());
    if (length()) {
        line += fmt::format(" of {}", *length());
    }
    line += " steps";
    if (state_->recorder && !recording_failed()) {
        line += ", which are in " + state_->recorder->path();
    }
    return line;
}

void Session::warn_of_failure() {
    if (recording_failed() && !state_->warned) {
        state_->warned = true;
        state_->warn(state_->recorder->failure());
    }
}

Moment Session::keep() const {
    return Moment(steps(), ecs::Snapshot::save(app_.world(), app_.registry()));
}

void Session::rewind(const Moment& moment) {
    if (moment.step() > steps()) {
        throw Error(ExitCode::bad_input,
                    fmt::format("session: asked to go back to step {} at step {}, expected an earlier one",
                                moment.step(), steps()));
    }
    if (!state_->present) {
        state_->present.emplace(keep());
    }
    go_to(moment);
}

void Session::come_back() {
    if (const std::optional<Moment> present = std::exchange(state_->present, std::nullopt)) {
        go_to(*present);
    }
}

void Session::jump(const Moment& moment) {
    if (state_->recorder) {
        throw Error(
            ExitCode::bad_input,
            fmt::format("session: asked to jump to step {} while {} is recorded, expected no recording",
                        moment.step(), state_->recorder->path()));
    }
    state_->present.reset();
    go_to(moment);
}

bool Session::in_the_past() const {
    return state_->present.has_value();
}

void Session::go_to(const Moment& moment) {
    ecs::World& world = app_.world();
    moment.world_.restore(world);
    Time& time = world.resource_mut<Time>();
    time.steps = moment.step();
    time.moment = time.simulated();
    time.blend = 1;
    if (world.try_resource<SensorInbox>() != nullptr) {
        world.resource_mut<SensorInbox>().samples.clear();  // of the world that is left
    }
    if (state_->player) {
        state_->player->go_to(moment.step());
    }
}

}  // namespace lanthorn::session

// The smallest App that can be played: a counter that a key moves up and down, and a light sensor.
#pragma once

#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "lanthorn/ecs/query.h"
#include "lanthorn/runtime/app.h"
#include "lanthorn/runtime/scene_plugin.h"
#include "lanthorn/runtime/sensor_plugin.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/light_sensor.h"
#include "lanthorn/session/session.h"

namespace lanthorn::session {

struct Push {
    std::int8_t by = 0;
};

struct Counter {
    std::int64_t value = 0;
    bool operator==(const Counter&) const = default;
};

// A counter that adds what is pushed, and `rate` times that.
inline void build_counter(App& app, std::int64_t rate = 1) {
    app.add<ScenePlugin>().add<SensorPlugin>();
    app.registry().component<Counter>("counter", "a number that the key moves",
                                      ecs::field("value", &Counter::value).words("what it has come to"));
    app.fixed_schedule()
        .add("push",
             [rate](ecs::Res<Push> push, ecs::Query<ecs::Write<Counter>> counters) {
                 counters.each([&](Counter& counter) { counter.value += rate * push->by; });
             })
        .in("gameplay");
    app.world().create(Counter{});
    app.world().create(Name{"eye"}, LightSensor{});
}

using Source = std::function<Push(const ecs::World&, std::uint64_t)>;

// 1, 2, 3, 1, 2, 3, ...
inline Push pushed(const ecs::World&, std::uint64_t step) {
    return {static_cast<std::int8_t>(1 + step % 3)};
}

class Played {
  public:
    explicit Played(Config config, Source source = pushed, std::optional<std::uint64_t> length = 100,
                    std::int64_t rate = 1, const char* format = "counter-1")
        : session_{built(app_, rate), InputStream::of<Push>(format, std::move(source), length),
                   told(std::move(config))} {}

    Session& session() { return session_; }
    App& app() { return app_; }
    std::int64_t value() const {
        std::int64_t value = 0;
        app_.world().query<ecs::Read<Counter>>().each([&](const Counter& c) { value = c.value; });
        return value;
    }
    const LightSensor& sensor() const { return app_.world().get<LightSensor>(sensor_entity()); }
    ecs::Entity sensor_entity() const {
        return app_.world().query<ecs::With<LightSensor>>().entities().front();
    }
    void steps(std::uint64_t count) {
        for (std::uint64_t i = 0; i < count; ++i) {
            app_.step();
        }
    }
    void to_the_end() {
        while (!session_.done()) {
            app_.step();
        }
    }
    const std::vector<std::string>& warnings() const { return warnings_; }

  private:
    static App& built(App& app, std::int64_t rate) {
        build_counter(app, rate);
        return app;
    }
    Config told(Config config) {
        config.warn = [this](const std::string& line) { warnings_.push_back(line); };
        return config;
    }

    App app_;
    std::vector<std::string> warnings_;
    Session session_;
};

// A name for recordings, which goes with the test.
class RecordingName {
  public:
    RecordingName()
        : path_((std::filesystem::temp_directory_path() /
                 ("lanthorn-session-" + std::to_string(::getpid()) + ".rec"))
                    .string()) {}
    ~RecordingName() { std::filesystem::remove(path_); }
    RecordingName(const RecordingName&) = delete;
    RecordingName& operator=(const RecordingName&) = delete;
    const std::string& path() const { return path_; }

  private:
    std::string path_;
};

inline Config recording_to(const std::string& file, std::uint64_t seed = 1) {
    Config config;
    config.seed = seed;
    config.content = "counter";
    config.content_hash = 7;
    config.build = "a test";
    config.record = file;
    return config;
}

inline Config replaying(const std::string& file) {
    Config config = recording_to("");
    config.replay = file;
    return config;
}

}  // namespace lanthorn::session

#include "game/presentation/playthrough.h"

#include <cstdio>
#include <filesystem>
#include <string>

#include "engine/build_info/build_info.h"
#include "game/presentation/tour.h"
#include "lanthorn/lamplighter/lamplighter.h"
#include "lanthorn/replay/content_hash.h"
#include "lanthorn/runtime/sensor_plugin.h"

namespace lanthorn::game {

namespace {

void fill(App& app, const Options& options, const SceneData& scene) {
    app.add<SensorPlugin>().add<GamePlugin>();
    app.set_threads(options.threads);
    load_level(app, scene);
}

void say(const std::string& line) {
    std::fprintf(stderr, "lamplighter: %s\n", line.c_str());
}

session::Config config(const Options& options) {
    session::Config config;
    config.seed = options.seed;
    config.record = options.record;
    config.replay = options.replay;
    config.warn = say;
    if (!config.record.empty() || !config.replay.empty()) {
        config.content = std::filesystem::path(options.level).filename().string();
        config.content_hash = replay::hash_file(options.level);
        config.build = build_words();
    }
    return config;
}

}  // namespace

Playthrough::Playthrough(const Options& options, const SceneData& scene)
    : shown_([&](App& app) { fill(app, options, scene); }),
      session_(shown_.app(), inputs(options), config(options)) {}

session::InputStream Playthrough::inputs(const Options& options) {
    if (options.headless || options.tour) {
        const Tour tour(shown_.world());
        return session::InputStream::of<PlayerInput>(
            kInputFormat,
            [tour](const ecs::World& world, std::uint64_t step) { return tour.next(world, step); },
            tour.steps());
    }
    return session::InputStream::of<PlayerInput>(kInputFormat, [this](const ecs::World&, std::uint64_t) {
        return devices_ ? devices_() : PlayerInput();
    });
}

void Playthrough::say_stopped(const StopSignal& stop) const {
    if (const std::string line = session_.stopped(stop); !line.empty()) {
        say(line);
    }
}

}  // namespace lanthorn::game

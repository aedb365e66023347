#include "tools/lanthorn/replay/replayed_level.h"

#include <cstdio>
#include <filesystem>

#include "engine/build_info/build_info.h"
#include "game/rules/player_input.h"
#include "lanthorn/lamplighter/lamplighter.h"
#include "lanthorn/runtime/sensor_plugin.h"

namespace lanthorn::tools {

namespace {

void fill(App& app, const LevelFile& level, const ReplayChoice& choice) {
    app.add<SensorPlugin>().add<game::GamePlugin>();
    app.set_threads(choice.threads);
    game::load_level(app, level.scene);
    if (choice.extend) {
        choice.extend(app);
    }
}

session::Config config(const LevelFile& level, const std::string& file,
                       std::shared_ptr<const replay::Recording> recording, const ReplayChoice& choice) {
    session::Config config;
    config.content = std::filesystem::path(level.path).filename().string();
    config.content_hash = level.hash;
    config.build = build_words();
    config.replay = file;
    config.record = choice.record;
    config.annotations = recording->annotations;
    config.recording = std::move(recording);
    return config;
}

}  // namespace

ReplayedLevel::ReplayedLevel(const LevelFile& level, const std::string& file,
                             std::shared_ptr<const replay::Recording> recording, const ReplayChoice& choice)
    : shown_([&](App& app) { fill(app, level, choice); }),
      session_(shown_.app(), session::InputStream::of<game::PlayerInput>(game::kInputFormat),
               config(level, file, std::move(recording), choice)) {}

}  // namespace lanthorn::tools

#include "game/level/level_in_window.h"

#include <cstdio>
#include <utility>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/printable.h"
#include "lanthorn/replay/content_hash.h"
#include "lanthorn/shell/kept_file.h"

namespace lanthorn::game {

LevelInWindow::LevelInWindow(const Options& options)
    : options_(options),
      files_(level_files(options)),
      kept_(options.record.empty() && options.replay.empty() && !options.tour
                ? shell::data_file("lamplighter", "sessions")
                : "",
            [](const std::string& line) { std::fprintf(stderr, "lamplighter: %s\n", line.c_str()); }) {}

void LevelInWindow::keep_no_session() {
    if (played_ && options_.record.empty()) {
        played_->session().finish();
        kept_.drop();
    }
}

Playthrough& LevelInWindow::load(int level, const shell::Spending& spending) {
    Options options = options_;
    options.level = file(level).path.string();
    hash_ = replay::hash_file(options.level);
    const SceneData scene = import_gltf(options.level);
    for (const std::string& warning : scene.warnings) {
        std::fprintf(stderr, "lamplighter: warning: %s: %s\n", printable(options.level).c_str(),
                     warning.c_str());
    }
    played_.reset();  // two at once would need twice the memory
    if (options.record.empty()) {
        options.record = kept_.begin().string();
    }
    spending_ = spending;
    auto played = std::make_unique<Playthrough>(options, scene);
    quality_.emplace(options, played->session().seed());
    quality_->draw(played->app(), spending);
    played_ = std::move(played);
    return *played_;
}

void LevelInWindow::draw_as(const shell::Spending& spending) {
    if (played_ && !(spending == spending_)) {
        quality_->draw(played_->app(), spending);
        spending_ = spending;
    }
}

}  // namespace lanthorn::game

#include "game/level/level_in_window.h"

#include <cstdio>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/printable.h"
#include "lanthorn/replay/content_hash.h"

namespace lanthorn::game {

ShownLevel& LevelInWindow::load(int level, const shell::Spending& spending) {
    Options options = options_;
    options.level = file(level).path.string();
    hash_ = replay::hash_file(options.level);
    const SceneData scene = import_gltf(options.level);
    for (const std::string& warning : scene.warnings) {
        std::fprintf(stderr, "lamplighter: warning: %s: %s\n", printable(options.level).c_str(),
                     warning.c_str());
    }
    shown_.reset();  // two at once would need twice the memory
    spending_ = spending;
    shown_ = std::make_unique<ShownLevel>(options, scene, spending);
    return *shown_;
}

void LevelInWindow::draw_as(const shell::Spending& spending) {
    if (shown_ && !(spending == spending_)) {
        shown_->spend(spending);
        spending_ = spending;
    }
}

}  // namespace lanthorn::game

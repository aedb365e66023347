#include "game/level/level_files.h"

#include "game/level/campaign.h"
#include "lanthorn/core/error.h"

namespace lanthorn::game {

namespace {

// A level that cannot be read has its file's name for a title: the rest can be played.
std::string title_of(const std::string& path) {
    try {
        const LevelInfo info = read_level_info(path);
        if (!info.title.empty()) {
            return info.title;
        }
    } catch (const InputError&) {
        // It is said when the level is chosen.
    }
    return std::filesystem::path(path).stem().string();
}

}  // namespace

std::filesystem::path LevelFile::picture() const {
    return std::filesystem::path(path).replace_extension(".png");
}

std::vector<LevelFile> level_files(const Options& options) {
    if (options.straight) {
        return {{options.level, title_of(options.level)}};
    }
    std::vector<LevelFile> files;
    for (const std::string_view stem : campaign()) {
        const std::string path = level_path(stem);
        files.push_back({path, title_of(path)});
    }
    return files;
}

}  // namespace lanthorn::game

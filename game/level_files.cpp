#include "game/level_files.h"

namespace lanthorn::game {

std::filesystem::path LevelFile::picture() const {
    return std::filesystem::path(path).replace_extension(".png");
}

std::vector<LevelFile> level_files(const Options& options) {
    const std::filesystem::path path(options.level);
    return {{path, path.stem().string()}};
}

}  // namespace lanthorn::game

// The levels of the campaign as files: where they are, what they are called, how they look.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "game/presentation/options.h"

namespace lanthorn::game {

struct LevelFile {
    std::filesystem::path path;
    std::string title;

    std::string name() const { return path.stem().string(); }  // as Progress has it
    // Of the level choice, 16:9; there may be none.
    std::filesystem::path picture() const;
};

// The campaign's, or the one that the command line names.
std::vector<LevelFile> level_files(const Options& options);

}  // namespace lanthorn::game

// How far the player has come, kept from one run to the next.
#pragma once

#include <optional>

#include "game/level/level_in_window.h"
#include "game/presentation/progress.h"

namespace lanthorn::game {

class ProgressFile {
  public:
    // An empty `path` keeps nothing.
    ProgressFile(std::filesystem::path path, const shell::Say& say)
        : file_(std::move(path), "progress", say), say_(say) {}

    // Reads it; then the level that the player goes on with, a number of `files`, if there is one.
    std::optional<int> read(const std::vector<LevelFile>& files);
    // Puts that level, loaded from its beginning, back to where it was left; what another build kept of it
    // and this one has no place for is said in one line. A state that cannot be read, of a later version for
    // one, is said, the file is put aside, and the level begins anew. Throws InputError where that was
    // another level.
    void restore(LevelInWindow& level);

    // The level as it is, the `number`-th; nothing where none could be loaded.
    void keep(const LevelInWindow& level, int number);

    bool solved(const LevelFile& level) const { return progress_.solved.contains(level.name()); }

  private:
    void unite();

    shell::KeptFile file_;
    shell::Say say_;
    Progress progress_;
};

}  // namespace lanthorn::game

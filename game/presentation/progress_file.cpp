#include "game/presentation/progress_file.h"

#include <algorithm>

#include "game/rules/components.h"
#include "lanthorn/core/error.h"

namespace lanthorn::game {

std::optional<int> ProgressFile::read(const std::vector<LevelFile>& files) {
    progress_ = read_progress(file_);
    const auto found = std::ranges::find(files, progress_.level, &LevelFile::name);
    return found != files.end() ? std::optional(static_cast<int>(found - files.begin())) : std::nullopt;
}

void ProgressFile::restore(LevelInWindow& level) {
    if (level.played() == nullptr || progress_.state.empty()) {
        return;
    }
    if (progress_.level_hash != level.hash()) {
        throw InputError(file_.path().string(), progress_.level, "the level is another now");
    }
    try {
        const std::vector<std::string> left_out =
            level.played()->shown().restore(progress_.state, file_.path().string());
        if (!left_out.empty()) {
            say_(left_out_line(file_.path().string(), left_out));
        }
    } catch (const InputError& error) {
        file_.put_aside(error.what());
    }
}

// With what another game has solved meanwhile.
void ProgressFile::unite() {
    if (const std::optional<std::string> others = file_.written_by_others()) {
        try {
            progress_.solved.merge(progress_from_bytes(*others, file_.path().string()).solved);
        } catch (const InputError&) {
            // It is kept beside, whatever it is.
        }
    }
}

void ProgressFile::keep(const LevelInWindow& level, int number) {
    if (file_.path().empty() || level.played() == nullptr) {
        return;
    }
    const std::string name = level.file(number).name();
    if (game::solved(level.played()->world())) {
        progress_.solved.insert(name);
    }
    unite();
    progress_.level = name;
    progress_.level_hash = level.hash();
    progress_.state = level.played()->shown().state();
    file_.write(to_bytes(progress_));
}

}  // namespace lanthorn::game

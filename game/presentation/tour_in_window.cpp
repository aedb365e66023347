#include "game/presentation/tour_in_window.h"

#include <cstdio>

#include "game/rules/components.h"

namespace lanthorn::game {

bool TourInWindow::pass(const LevelInWindow& level, int number, double seconds) {
    if (!lingering_.pass(level.played()->session().done(), seconds)) {
        return false;
    }
    lingering_.forget();
    if (!solved(level.played()->world())) {
        const std::string file = level.file(number).path.string();
        std::fprintf(stderr, "lamplighter: %s: its tour does not solve it\n", file.c_str());
        unsolved_ = true;
    }
    return true;
}

}  // namespace lanthorn::game

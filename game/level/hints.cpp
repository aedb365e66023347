#include "game/level/hints.h"

#include <algorithm>

namespace lanthorn::game {

void Hints::ask(const std::vector<std::string>& hints) {
    shown_ = hints.empty() ? "There is no hint for this level." : hints[std::min(next_, hints.size() - 1)];
    next_ = std::min(next_ + 1, hints.size());
    left_ = kShownSeconds;
}

void Hints::pass(double seconds) {
    left_ -= seconds;
    if (left_ <= 0) {
        shown_.clear();
    }
}

}  // namespace lanthorn::game

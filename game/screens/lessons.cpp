#include "game/screens/lessons.h"

#include <algorithm>
#include <cmath>

namespace lanthorn::game {

namespace {

constexpr float kKnown = 0.55f;  // strength of what was learned and is still of use
constexpr double kFade = 2.5;    // seconds

bool has(const Doing& doing, Action action) {
    return doing.used[static_cast<std::size_t>(action)];
}

}  // namespace

void Lessons::pass(const Doing& doing, double seconds) {
    used_ |= doing.used;
    walked_ += doing.walked ? seconds : 0;
    turned_ += std::abs(doing.turned);
    played_ += seconds;
    if (has(doing, Action::hint)) {
        asked_ = played_;
    }
}

std::vector<Prompt> Lessons::prompts(const Hud& hud) const {
    std::vector<Prompt> all;
    const auto add = [&](std::vector<Action> actions, const char* words) {
        const bool known = std::ranges::all_of(actions, [&](Action action) { return knows(action); });
        all.push_back({std::move(actions), words, known ? kKnown : 1.0f});
    };
    if (walked_ < kWalkSeconds) {
        all.push_back({{Action::forward, Action::left, Action::back, Action::right}, "walk"});
    }
    if (turned_ < kTurn) {
        all.push_back({{}, "look about"});
    }
    if (hud.carries) {
        add({Action::light}, hud.lit ? "put out" : "light");
        if (hud.glasses > 0) {
            add({Action::colour}, "another glass");
        }
        if (hud.lit) {
            add({Action::dim_up, Action::dim_down}, "brighter, darker");
        }
        add({Action::carry}, "put down");
        std::ranges::stable_sort(all, std::greater{}, &Prompt::strength);
    }
    // The keys of always: for a while, and again for those who are stuck.
    const double since = std::min(std::fmod(played_ - asked_, kStuckSeconds), played_);
    const auto strength = static_cast<float>(std::clamp((kAlwaysSeconds - since) / kFade, 0.0, 0.9));
    if (strength > 0) {
        all.push_back({{Action::hint}, "hint", strength});
        all.push_back({{Action::menu}, "menu", strength});
        if (walked_ >= kWalkSeconds && turned_ >= kTurn && !knows(Action::view)) {
            all.push_back({{Action::view}, "see with her eyes", strength});
        }
    }
    return all;
}

}  // namespace lanthorn::game

// What to press for what, for people: --help, the manual page and docs/playing.md show it.
#pragma once

#include <string>
#include <vector>

namespace lanthorn::game {

struct ControlWords {
    std::string what;
    std::string keys;  // and mouse
    std::string pad;   // empty: nothing
};

// Unless told otherwise: looking about, then all actions in their order.
std::vector<ControlWords> control_words();

// A line each, aligned.
std::string control_lines();
// "look about: mouse or right stick; walk forward: W or left stick; ..."
std::string control_sentence();

}  // namespace lanthorn::game

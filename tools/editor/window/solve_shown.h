// Whether the scene can still be solved as somebody once solved it, as far as that has been found out.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lanthorn::edit_window {

struct SolveShown {
    struct Row {
        std::string node;  // its name; empty: it is about none
        std::string words;
        bool kept = false;  // what is asked for happens
    };
    double share = 0;            // 0..1 of what is to be played
    std::optional<bool> solved;  // nothing: not known yet
    std::string words;           // one line
    std::vector<Row> rows;
};

}  // namespace lanthorn::edit_window

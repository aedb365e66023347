#include "game/screens/notices.h"

#include <algorithm>
#include <cstdio>

namespace lanthorn::game {

void Notices::add(const std::string& line) {
    std::fprintf(stderr, "lamplighter: %s\n", line.c_str());
    lines_.push_back({line});
    if (lines_.size() > kMost) {
        lines_.pop_front();
    }
}

void Notices::pass(double seconds) {
    for (Line& line : lines_) {
        line.left -= seconds;
    }
    std::erase_if(lines_, [](const Line& line) { return line.left <= 0; });
}

std::vector<std::string> Notices::lines() const {
    std::vector<std::string> words;
    std::ranges::transform(lines_, std::back_inserter(words), &Line::words);
    return words;
}

}  // namespace lanthorn::game

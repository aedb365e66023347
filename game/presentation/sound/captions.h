// What is heard, in words, for those who do not hear it.
#pragma once

#include <string>
#include <vector>

#include "game/presentation/sound/ear.h"

namespace lanthorn::game {

class Captions {
  public:
    static constexpr double kShownSeconds = 2.5;
    static constexpr std::size_t kMost = 3;  // at a time: the newest

    // Of a frame. Steps and what the menu sounds like have no words.
    void hear(const Heard& heard);
    // Time passes: old words go.
    void pass(double seconds);
    // In English, the newest last.
    std::vector<std::string> lines() const;

  private:
    struct Line {
        const char* words;
        double left;
    };
    std::vector<Line> lines_;
};

}  // namespace lanthorn::game

// Lines for the player: on stderr at once, and on the picture for a while.
#pragma once

#include <deque>
#include <string>
#include <vector>

namespace lanthorn::game {

class Notices {
  public:
    void add(const std::string& line);
    // Time passes: old lines go.
    void pass(double seconds);
    std::vector<std::string> lines() const;

    static constexpr double kShownSeconds = 8;
    static constexpr std::size_t kMost = 4;  // on the picture

  private:
    struct Line {
        std::string words;
        double left = kShownSeconds;
    };
    std::deque<Line> lines_;
};

}  // namespace lanthorn::game

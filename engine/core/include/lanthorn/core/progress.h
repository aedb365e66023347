// A progress bar with the remaining time for people at a terminal; nothing at all in a pipe or a file.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace lanthorn {

// How long something takes, for people: tenths below 10 s ("0.4 s"), then "18 s", "2 min 05 s", "1 h 30 min",
// rounded to the nearest. At least 0.1 s, also of what is negative or NaN; at most 1e9 s.
std::string duration_words(double seconds);

class Progress {
  public:
    // `total` steps of `what` ("rendering"). Draws on standard error, and only if that is a terminal.
    Progress(std::string what, std::uint64_t total);
    ~Progress();  // erases the bar
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // `done` steps are done; redraws at most ten times a second. From one thread.
    void update(std::uint64_t done);

    bool visible() const { return visible_; }  // there is a terminal to draw on

    // "rendering [#####     ]  50 %  3.0 s left": one line, `seconds` after the start.
    static std::string line(const std::string& what, std::uint64_t done, std::uint64_t total, double seconds);

  private:
    using Clock = std::chrono::steady_clock;
    std::string what_;
    std::uint64_t total_;
    bool visible_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point drawn_;
};

}  // namespace lanthorn

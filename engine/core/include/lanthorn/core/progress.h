// A progress bar with the remaining time for people at a terminal; nothing at all in a pipe or a file.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace lanthorn {

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

    // "rendering [#####     ]  50 %  3 s left": one line, `seconds` after the start.
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

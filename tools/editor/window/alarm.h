// Wakes a window that sleeps, once, when something is due.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace lanthorn::edit_window {

class Alarm {
  public:
    using Clock = std::chrono::steady_clock;

    // `ring` is called from another thread; it must not block.
    explicit Alarm(std::function<void()> ring);

    // Rings once at that time, or at once if it has passed, and no more for what was asked for before.
    void set(Clock::time_point at);

  private:
    void run(const std::stop_token& stop);

    std::function<void()> ring_;
    std::mutex mutex_;  // of at_
    std::condition_variable_any changed_;
    std::optional<Clock::time_point> at_;
    std::jthread thread_;  // last: it ends before what it uses
};

}  // namespace lanthorn::edit_window

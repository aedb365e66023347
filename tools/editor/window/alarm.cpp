#include "tools/editor/window/alarm.h"

#include <utility>

namespace lanthorn::edit_window {

Alarm::Alarm(std::function<void()> ring)
    : ring_(std::move(ring)), thread_([this](const std::stop_token& stop) { run(stop); }) {}

void Alarm::set(Clock::time_point at) {
    const std::lock_guard lock(mutex_);
    at_ = at;
    changed_.notify_one();
}

void Alarm::run(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
        if (!at_) {
            changed_.wait(lock, stop, [this] { return at_.has_value(); });
        } else if (const Clock::time_point at = *at_; Clock::now() < at) {
            changed_.wait_until(lock, stop, at, [this, at] { return at_ != at; });
        } else {
            at_.reset();
            ring_();
        }
    }
}

}  // namespace lanthorn::edit_window

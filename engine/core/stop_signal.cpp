#include "lanthorn/core/stop_signal.h"

#include <atomic>
#include <cstdint>
#include <ctime>

namespace lanthorn {

namespace {

// When the first signal came and which it was, in one number; 0: none came. Handlers may run in any thread.
std::atomic<std::int64_t> first{0};
std::int64_t request_ms = 0;
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

constexpr std::int64_t kNumbers = 256;  // more than there are signals

std::int64_t milliseconds() {
    std::timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return std::int64_t{now.tv_sec} * 1000 + now.tv_nsec / 1'000'000;
}

// Calls nothing that POSIX does not allow in a handler.
void note(int number) {
    const std::int64_t now = milliseconds();
    std::int64_t before = 0;
    if (first.compare_exchange_strong(before, now * kNumbers + number) ||
        now - before / kNumbers < request_ms) {
        return;
    }
    std::signal(number, SIG_DFL);
    std::raise(number);  // takes effect when this returns
}

}  // namespace

StopSignal::StopSignal(std::chrono::milliseconds one_request) {
    first = 0;
    request_ms = one_request.count();
    struct sigaction action {};
    action.sa_handler = note;
    action.sa_flags = SA_RESTART;  // writing goes on
    sigemptyset(&action.sa_mask);
    for (const int number : kSignals) {
        sigaddset(&action.sa_mask, number);
    }
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
        sigaction(kSignals[i], nullptr, &before_[i]);
        if (before_[i].sa_handler != SIG_IGN) {
            sigaction(kSignals[i], &action, nullptr);
        }
    }
}

StopSignal::~StopSignal() {
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
        sigaction(kSignals[i], &before_[i], nullptr);
    }
    first = 0;
}

int StopSignal::number() {
    return static_cast<int>(first % kNumbers);
}

const char* StopSignal::name() {
    switch (number()) {
        case SIGINT:
            return "SIGINT";
        case SIGTERM:
            return "SIGTERM";
        case SIGHUP:
            return "SIGHUP";
        default:
            return "";
    }
}

}  // namespace lanthorn

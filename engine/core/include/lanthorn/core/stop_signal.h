// Being asked to stop: Ctrl+C, a system that shuts down, a terminal that is closed. A program that writes
// what it has done so far looks here between two pieces of work.
#pragma once

#include <array>
#include <chrono>
#include <csignal>

namespace lanthorn {

// While it lives, notes the first SIGINT, SIGTERM or SIGHUP instead of ending the program; the next one ends
// it at once. One that is ignored stays so: nohup ignores SIGHUP, scripts SIGINT for what they run in the
// background. One at a time, for the whole process.
class StopSignal {
  public:
    // Signals that follow the first within `one_request` are part of it: `timeout`, for one, sends its signal
    // to the program and then to its group.
    explicit StopSignal(std::chrono::milliseconds one_request = std::chrono::milliseconds(250));
    ~StopSignal();
    StopSignal(const StopSignal&) = delete;
    StopSignal& operator=(const StopSignal&) = delete;

    // The first signal's number; 0 if there was none. A load: cheap enough for every turn of a loop, anywhere
    // in the program.
    static int number();
    static bool asked() { return number() != 0; }  // whether a signal has come; as cheap as number()

    // "SIGINT"; empty if there was none.
    static const char* name();
    // What a shell reports of a program that a signal ended, 128 + number(); 0 if there was none.
    static int exit_code() { return asked() ? 128 + number() : 0; }

  private:
    static constexpr std::array<int, 3> kSignals = {SIGINT, SIGTERM, SIGHUP};
    std::array<struct sigaction, kSignals.size()> before_{};
};

}  // namespace lanthorn

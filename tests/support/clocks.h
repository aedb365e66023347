// Milliseconds and seconds since some moment, by two clocks: differences tell how long something took.
#pragma once

#include <chrono>
#include <ctime>

namespace lanthorn::support {

inline double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
inline double wall_ms() {
    return 1e3 * wall_seconds();
}

// What all threads of this process have computed: other programs disturb it less.
inline double processor_seconds() {
    std::timespec t{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}
inline double processor_ms() {
    return 1e3 * processor_seconds();
}

}  // namespace lanthorn::support

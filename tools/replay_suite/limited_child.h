// A program run under limits, and how it ended.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace lanthorn::suite {

struct Limits {
    double seconds = 600;             // of a run, wall clock
    double stuck_seconds = 60;        // without a further step
    std::uint64_t memory_mib = 8192;  // of address space; 0: none
};

struct ChildRun {
    enum class End {
        exited,
        signalled,
        timed_out,    // past Limits::seconds
        stuck,        // past Limits::stuck_seconds without a step
        stopped,      // because `stop` asked for it
        not_started,  // no process could be made, or the program is not there
    };
    End end = End::not_started;
    int code = 0;                            // of exited
    int signal = 0;                          // of signalled
    std::string out, err;                    // the last 64 KiB of each
    std::optional<std::uint64_t> last_step;  // that the progress file named
    double wall_s = 0, cpu_s = 0;
};

// Runs `arguments[0]` with `environment` ("NAME=VALUE") on top of this process's, in a process group of its
// own, and waits. `progress`: a file whose first number is the step that the child has reached. One past a
// limit is asked for a backtrace first (SIGABRT) and killed two seconds later. If this process is killed, the
// child is too. Does not throw; may be called from several threads.
ChildRun run_limited(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
                     const Limits& limits, const std::filesystem::path& progress,
                     const std::function<bool()>& stop);

}  // namespace lanthorn::suite

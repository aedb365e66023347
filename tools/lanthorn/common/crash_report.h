// What a program writes when a signal ends it: which, in which step, and where.
#pragma once

#include <cstdint>

namespace lanthorn::tools {

// The environment's name for the file that a crash is to be told in. Empty or absent: no report.
inline constexpr const char* kCrashFileVariable = "LANTHORN_CRASH_FILE";

// If the environment names a file, SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT write it before they end the
// program as they would have: "signal N", "step N" and a line a frame of the stack, as backtrace_symbols_fd
// writes it. Call once, at the start.
void install_crash_report();

// The steps that are done, for the report. A store; from any thread.
void note_step(std::uint64_t steps);

}  // namespace lanthorn::tools

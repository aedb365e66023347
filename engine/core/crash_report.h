// What a program writes when a signal ends it: which, in which step, and where.
#pragma once

#include <cstdint>
#include <string>

namespace lanthorn {

// The environment's name for the file that a crash is to be told in. Empty or absent: no report.
inline constexpr const char* kCrashFileVariable = "LANTHORN_CRASH_FILE";

// From now on SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT write `file` before they end the program as they
// would have: "signal N", "step N" and a line a frame of the stack, as backtrace_symbols_fd writes it.
// Nothing for a path that is empty or longer than 4095 bytes. A later call names another file.
void install_crash_report(const std::string& file);
// The same with the file that the environment names, if it names one.
void install_crash_report();

// The steps that are done, for the report. A store; from any thread.
void note_step(std::uint64_t steps);

}  // namespace lanthorn

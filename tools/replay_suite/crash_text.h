// A crash report as people read it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace lanthorn::suite {

struct Crash {
    int signal = 0;
    std::uint64_t step = 0;           // steps that were done
    std::vector<std::string> frames;  // innermost first, without those of the handler
    std::string where() const;        // the innermost frame of the program itself; may be empty
};

// What install_crash_report() (engine/core/crash_report.h) wrote; none where there is no report.
// Names of functions come from `addr2line`, a second or two, where that is installed; else frames are places
// in files.
std::optional<Crash> read_crash(const std::filesystem::path& report, const std::string& program);

// "SIGSEGV", "signal 99".
std::string signal_words(int signal);

}  // namespace lanthorn::suite

#include "tools/replay_suite/crash_text.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstring>
#include <map>
#include <regex>
#include <sstream>

#include "tools/replay_suite/files.h"
#include "tools/replay_suite/limited_child.h"

namespace lanthorn::suite {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFrames = 24;  // that are told

struct Frame {
    std::string module, symbol, offset;  // of "MODULE(SYMBOL+OFFSET) [ADDRESS]"
};

std::optional<Frame> frame_of(const std::string& line) {
    static const std::regex kFrame(R"(^(.+)\(([^+()]*)(?:\+(0x[0-9a-f]+))?\) ?\[)");
    std::smatch found;
    if (!std::regex_search(line, found, kFrame)) {
        return {};
    }
    return Frame{found[1], found[2], found[3]};
}

bool same_file(const std::string& a, const std::string& b) {
    std::error_code error;
    return a == b || a == "/proc/self/exe" || fs::equivalent(a, b, error);
}

// Parameters say little and are long: "f" of "f(std::vector<int>) const".
std::string without_parameters(const std::string& function) {
    const std::size_t end = function.rfind(')');
    int depth = 0;
    for (std::size_t at = end == std::string::npos ? 0 : end + 1; at-- > 1;) {
        depth += function[at] == ')' ? 1 : function[at] == '(' ? -1 : 0;
        if (depth == 0) {
            return function.substr(0, at);
        }
    }
    return function;
}

// Function and place of every offset of the program; empty without addr2line.
std::map<std::string, std::string> names_of(const std::string& program,
                                            const std::vector<std::string>& offsets) {
    const char* const kTool = "/usr/bin/addr2line";
    std::map<std::string, std::string> names;
    if (offsets.empty() || access(kTool, X_OK) != 0) {
        return names;
    }
    std::vector<std::string> command = {kTool, "-f", "-C", "-s", "-e", program};
    command.insert(command.end(), offsets.begin(), offsets.end());
    const ChildRun run = run_limited(command, {}, {30, 30, 0}, {}, [] { return false; });
    std::istringstream lines(run.out);
    std::string function, place;
    for (const std::string& offset : offsets) {
        if (!std::getline(lines, function) || !std::getline(lines, place)) {
            break;
        }
        if (function != "??") {
            const std::string file = place.substr(0, place.find(':'));
            const bool has_line = place.find_first_of("123456789", file.size()) != std::string::npos;
            names[offset] = without_parameters(function) +
                            (file == "??" ? "" : fmt::format(" ({})", has_line ? place : file));
        }
    }
    return names;
}

}  // namespace

std::string signal_words(int signal) {
    const char* name = sigabbrev_np(signal);
    return name != nullptr ? std::string("SIG") + name : fmt::format("signal {}", signal);
}

std::string Crash::where() const {
    for (const std::string& frame : frames) {
        if (!frame.starts_with("in ")) {
            return frame;
        }
    }
    return frames.empty() ? "" : frames.front();
}

std::optional<Crash> read_crash(const fs::path& report, const std::string& program) {
    std::istringstream lines(read_if_there(report));
    std::string word;
    Crash crash;
    if (!(lines >> word >> crash.signal) || word != "signal" || !(lines >> word >> crash.step)) {
        return {};
    }
    std::vector<Frame> frames;
    for (std::string line; std::getline(lines, line);) {
        if (const auto frame = frame_of(line)) {
            frames.push_back(*frame);
        }
    }
    // The handler, then the C library's way to it; what follows had been going on.
    std::size_t first = 0;
    while (first < frames.size() && same_file(frames[first].module, program)) {
        ++first;
    }
    first = std::min(first + 1, frames.size());
    std::vector<std::string> offsets;
    for (std::size_t i = first; i < frames.size() && i < first + kMostFrames; ++i) {
        if (same_file(frames[i].module, program) && frames[i].symbol.empty()) {
            offsets.push_back(frames[i].offset);
        }
    }
    const auto names = names_of(program, offsets);
    for (std::size_t i = first; i < frames.size() && i < first + kMostFrames; ++i) {
        const Frame& frame = frames[i];
        const std::string module = fs::path(frame.module).filename();
        if (!same_file(frame.module, program)) {
            crash.frames.push_back(
                fmt::format("in {}{}", module, frame.symbol.empty() ? "" : ": " + frame.symbol));
        } else if (const auto named = names.find(frame.offset); named != names.end()) {
            crash.frames.push_back(named->second);
        } else {
            crash.frames.push_back(
                fmt::format("{}{}+{}", module, frame.symbol.empty() ? "" : ":" + frame.symbol, frame.offset));
        }
    }
    return crash;
}

}  // namespace lanthorn::suite

#include "lanthorn/shell/kept_session.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

#include "engine/core/crash_report.h"

namespace lanthorn::shell {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kRecording = ".rec", kCrash = ".crash";

std::string name_of(long process) {
    return fmt::format("session-{}", process);
}

fs::path file_in(const fs::path& folder, const std::string& name, std::string_view ending) {
    return folder / (name + std::string(ending));
}

// The number of "WORD-NUMBER.rec"; nothing for another name.
std::optional<long> number_of(const fs::path& file, std::string_view word) {
    const std::string name = file.filename().string();
    long number = 0;
    if (!name.starts_with(word) || !name.ends_with(kRecording) || name.size() <= word.size()) {
        return std::nullopt;
    }
    const char* const end = name.data() + name.size() - kRecording.size();
    const auto [at, error] = std::from_chars(name.data() + word.size(), end, number);
    return error == std::errc() && at == end ? std::optional(number) : std::nullopt;
}

std::vector<long> numbers_in(const fs::path& folder, std::string_view word) {
    std::vector<long> numbers;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        if (const auto number = number_of(at->path(), word)) {
            numbers.push_back(*number);
        }
    }
    std::ranges::sort(numbers);
    return numbers;
}

bool lives(long process) {
    return kill(static_cast<pid_t>(process), 0) == 0 || errno == EPERM;
}

void move_to(const fs::path& from, const fs::path& to) {
    std::error_code ignored;  // what cannot be moved stays
    fs::rename(from, to, ignored);
}

void remove_file(const fs::path& file) {
    std::error_code ignored;
    fs::remove(file, ignored);
}

}  // namespace

KeptSession::KeptSession(fs::path folder, std::function<void(const std::string&)> say)
    : folder_(std::move(folder)), say_(std::move(say)) {
    sort_out();
}

void KeptSession::sort_out() {
    if (folder_.empty()) {
        return;
    }
    std::vector<long> crashes = numbers_in(folder_, "crash-");
    for (const long process : numbers_in(folder_, "session-")) {
        const fs::path recording = file_in(folder_, name_of(process), kRecording);
        const fs::path crash = file_in(folder_, name_of(process), kCrash);
        std::error_code error;
        if (lives(process)) {
            continue;
        }
        if (!fs::exists(crash, error)) {
            move_to(recording, folder_ / "previous.rec");
            continue;
        }
        crashes.push_back(crashes.empty() ? 1 : crashes.back() + 1);
        const std::string name = fmt::format("crash-{}", crashes.back());
        move_to(recording, file_in(folder_, name, kRecording));
        move_to(crash, file_in(folder_, name, kCrash));
        say_(fmt::format("an earlier session crashed; what led to it: {}",
                         file_in(folder_, name, kRecording).string()));
    }
    for (std::size_t i = 0; i + kMostCrashes < crashes.size(); ++i) {
        const std::string name = fmt::format("crash-{}", crashes[i]);
        remove_file(file_in(folder_, name, kRecording));
        remove_file(file_in(folder_, name, kCrash));
    }
}

fs::path KeptSession::begin() {
    std::error_code error;
    if (folder_.empty() || (fs::create_directories(folder_, error), error) ||
        access(folder_.c_str(), W_OK | X_OK) != 0) {
        return {};
    }
    const std::string name = name_of(getpid());
    remove_file(file_in(folder_, name, kRecording));
    install_crash_report(file_in(folder_, name, kCrash).string());
    return file_in(folder_, name, kRecording);
}

void KeptSession::drop() {
    if (!folder_.empty()) {
        remove_file(file_in(folder_, name_of(getpid()), kRecording));
    }
}

}  // namespace lanthorn::shell

#include "lanthorn/core/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lanthorn {

std::string duration_words(double seconds) {
    seconds = std::min(std::max(0.1, seconds), 1e9);  // of a NaN, max() returns the first
    if (seconds < 9.95) {
        return fmt::format("{:.1f} s", seconds);
    }
    const long long whole = std::llround(seconds);
    if (whole < 60) {
        return fmt::format("{} s", whole);
    }
    if (whole < 3600) {
        return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    }
    const long long minutes = std::llround(seconds / 60);
    return fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
}

Progress::Progress(std::string what, std::uint64_t total)
    : what_(std::move(what)), total_(total), visible_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
    if (visible_) {
        std::fputs("\r\x1b[K", stderr);  // carriage return, erase to the end of the line
        std::fflush(stderr);
    }
}

void Progress::update(std::uint64_t done) {
    const Clock::time_point now = Clock::now();
    if (!visible_ || now - drawn_ < std::chrono::milliseconds(100)) {
        return;
    }
    drawn_ = now;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    std::fputs(("\r\x1b[K" + line(what_, done, total_, seconds)).c_str(), stderr);
    std::fflush(stderr);
}

std::string Progress::line(const std::string& what, std::uint64_t done, std::uint64_t total, double seconds) {
    constexpr std::size_t kWidth = 30;
    done = std::min(done, total);
    const double share = total == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(total);
    const auto filled = static_cast<std::size_t>(share * kWidth);
    std::string text = fmt::format("{} [{}{}] {:3.0f} %", what, std::string(filled, '#'),
                                   std::string(kWidth - filled, ' '), std::floor(100 * share));
    if (done > 0 && done < total) {
        text += fmt::format("  {} left", duration_words(seconds * (1 - share) / share));
    }
    return text;
}

}  // namespace lanthorn

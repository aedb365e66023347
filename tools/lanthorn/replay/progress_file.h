// How far a replay has come, for another program that watches.
#pragma once

#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <utility>

#include "lanthorn/core/atomic_file.h"

namespace lanthorn::tools {

// Tells the step reached, about twice a second, in a file for who watches. An empty path: nobody does.
class ProgressFile {
  public:
    explicit ProgressFile(std::string path) : path_(std::move(path)) { write(0); }
    void update(std::uint64_t step) {
        const auto now = Clock::now();
        if (!path_.empty() && now - written_ > std::chrono::milliseconds(500)) {
            written_ = now;
            write(step);
        }
    }

  private:
    using Clock = std::chrono::steady_clock;
    void write(std::uint64_t step) const {
        if (!path_.empty()) {
            write_file(path_, fmt::format("{}\n", step));
        }
    }
    std::string path_;
    Clock::time_point written_ = Clock::now();
};

}  // namespace lanthorn::tools

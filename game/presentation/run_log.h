// How the game runs, for tools that look at it from outside: one line of JSON a second.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::game {

// What the process holds now. Counting takes some milliseconds: names of OpenGL objects are asked one by one.
struct Holdings {
    std::uint64_t heap = 0, resident = 0, gpu = 0;  // bytes
    std::uint64_t textures = 0, buffers = 0, framebuffers = 0, queries = 0, programs = 0;
    std::uint64_t files = 0, threads = 0;  // descriptors that are open; threads

    bool operator==(const Holdings&) const = default;
};

// An OpenGL context must be current.
Holdings holdings();

class RunLog {
  public:
    // Appends to `file`; an empty name: nothing is written. Throws InputError if it cannot be opened. A line
    // that cannot be written (a full disk) is said once on standard error, and ends the log; the file keeps
    // whole lines.
    explicit RunLog(const std::string& file);
    ~RunLog();
    RunLog(const RunLog&) = delete;
    RunLog& operator=(const RunLog&) = delete;

    // What a frame was drawn as.
    struct Drawn {
        std::string level, screen, preset;
        ivec2 picture{0};  // pixels
    };
    // Call after every frame. A line is written, whole, when a second has passed, and when `drawn` is
    // another. Names that are no UTF-8 are written with their bytes as \x text.
    void frame(double ms, const Drawn& drawn);

  private:
    void write();
    void append(const std::string& line);

    std::string file_;
    int out_ = -1;  // descriptor
    Drawn drawn_;
    std::vector<double> frames_;  // milliseconds
    double passed_ = 0, total_ = 0;
};

}  // namespace lanthorn::game

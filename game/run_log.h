// How the game runs, for tools that look at it from outside: one line of JSON a second.
#pragma once

#include <cstdint>
#include <fstream>
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
    // Appends to `file`; an empty name: nothing is written. Throws InputError if it cannot be opened.
    explicit RunLog(const std::string& file);

    // What a frame was drawn as.
    struct Drawn {
        std::string level, screen, preset;
        ivec2 picture{0};  // pixels
    };
    // Call after every frame. A line is written, whole, when a second has passed, and when `drawn` is
    // another.
    void frame(double ms, const Drawn& drawn);

  private:
    void write();

    std::ofstream out_;
    Drawn drawn_;
    std::vector<double> frames_;  // milliseconds
    double passed_ = 0, total_ = 0;
};

}  // namespace lanthorn::game

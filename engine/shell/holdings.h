// What a process with OpenGL holds, counted: tests and logs see from it that nothing grows.
#pragma once

#include <cstdint>

namespace lanthorn::shell {

// Now. Counting takes some milliseconds: names of OpenGL objects are asked one by one.
struct Holdings {
    std::uint64_t heap = 0, resident = 0, gpu = 0;  // bytes
    std::uint64_t textures = 0, buffers = 0, framebuffers = 0, queries = 0, programs = 0;
    std::uint64_t files = 0, threads = 0;  // descriptors that are open; threads

    bool operator==(const Holdings&) const = default;
};

// An OpenGL context must be current.
Holdings holdings();

}  // namespace lanthorn::shell

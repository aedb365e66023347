// What of OpenGL is in use: whether frames leave something behind.
#pragma once

#include <cstddef>
#include <ostream>

namespace lanthorn::gi::test {

struct GlObjects {
    int buffers = 0;
    int textures = 0;
    int framebuffers = 0;
    int programs = 0;
    std::size_t bytes = 0;  // of buffers and textures, of all contexts

    bool operator==(const GlObjects&) const = default;
};

// Of the current context. Some 100 000 calls.
GlObjects gl_objects();

std::ostream& operator<<(std::ostream& out, const GlObjects& objects);

}  // namespace lanthorn::gi::test

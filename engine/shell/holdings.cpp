#include "engine/shell/holdings.h"

#include <epoxy/gl.h>
#include <malloc.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "engine/gpu/memory.h"

namespace lanthorn::shell {

namespace {

// How many of the names up to the next new one are those of objects.
template <class Gen, class Delete, class Is>
std::uint64_t living(Gen gen, Delete remove, Is is) {
    GLuint next = 0;
    gen(1, &next);
    remove(1, &next);
    std::uint64_t count = 0;
    for (GLuint name = 1; name < next; ++name) {
        count += is(name) == GL_TRUE ? 1 : 0;
    }
    return count;
}

// Programs and shaders share their names.
std::uint64_t living_programs() {
    const GLuint next = glCreateProgram();
    glDeleteProgram(next);
    std::uint64_t count = 0;
    for (GLuint name = 1; name < next; ++name) {
        count += glIsProgram(name) == GL_TRUE || glIsShader(name) == GL_TRUE ? 1 : 0;
    }
    return count;
}

std::uint64_t entries(const char* folder) {
    std::uint64_t count = 0;
    std::error_code error;
    for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end;
         at.increment(error)) {
        ++count;
    }
    return count;
}

std::uint64_t resident_bytes() {
    std::ifstream statm("/proc/self/statm");
    std::uint64_t whole = 0, resident = 0;
    statm >> whole >> resident;
    return resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

}  // namespace

Holdings holdings() {
    const struct mallinfo2 heap = mallinfo2();
    return {.heap = heap.uordblks + heap.hblkhd,
            .resident = resident_bytes(),
            .gpu = gpu::allocated_bytes(),
            .textures = living(glGenTextures, glDeleteTextures, glIsTexture),
            .buffers = living(glGenBuffers, glDeleteBuffers, glIsBuffer),
            .framebuffers = living(glGenFramebuffers, glDeleteFramebuffers, glIsFramebuffer),
            .queries = living(glGenQueries, glDeleteQueries, glIsQuery),
            .programs = living_programs(),
            .files = entries("/proc/self/fd") - 1,  // the folder itself
            .threads = entries("/proc/self/task")};
}

}  // namespace lanthorn::shell

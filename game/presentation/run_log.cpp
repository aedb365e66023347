#include "game/presentation/run_log.h"

#include <epoxy/gl.h>
#include <fcntl.h>
#include <malloc.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "engine/gpu/memory.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/printable.h"

namespace lanthorn::game {

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

RunLog::RunLog(const std::string& file) : file_(file) {
    if (file.empty()) {
        return;
    }
    out_ = ::open(file.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
    if (out_ < 0) {
        throw InputError(file, "", std::string("cannot be written: ") + std::strerror(errno));
    }
}

RunLog::~RunLog() {
    if (out_ >= 0) {
        ::close(out_);
    }
}

void RunLog::frame(double ms, const Drawn& drawn) {
    if (out_ < 0) {
        return;
    }
    const bool another = drawn.level != drawn_.level || drawn.screen != drawn_.screen ||
                         drawn.preset != drawn_.preset || drawn.picture != drawn_.picture;
    if (!frames_.empty() && (another || passed_ > 1000)) {
        write();
    }
    drawn_ = drawn;
    frames_.push_back(std::round(100 * ms) / 100);
    passed_ += ms;
    total_ += ms;
}

void RunLog::write() {
    const Holdings now = holdings();
    const nlohmann::ordered_json line = {{"seconds", std::round(total_) / 1000},
                                         {"level", printable(drawn_.level)},
                                         {"screen", printable(drawn_.screen)},
                                         {"preset", printable(drawn_.preset)},
                                         {"picture", {drawn_.picture.x, drawn_.picture.y}},
                                         {"frame_ms", frames_},
                                         {"heap", now.heap},
                                         {"resident", now.resident},
                                         {"gpu", now.gpu},
                                         {"textures", now.textures},
                                         {"buffers", now.buffers},
                                         {"framebuffers", now.framebuffers},
                                         {"queries", now.queries},
                                         {"programs", now.programs},
                                         {"files", now.files},
                                         {"threads", now.threads}};
    append(line.dump() + "\n");
    frames_.clear();
    passed_ = 0;
}

void RunLog::append(const std::string& line) {
    const off_t size = ::lseek(out_, 0, SEEK_END);
    std::string_view rest = line;
    while (!rest.empty()) {
        const ssize_t written = ::write(out_, rest.data(), rest.size());
        if (written < 0 && errno != EINTR) {
            std::fprintf(
                stderr, "lamplighter: warning: %s\n",
                InputError(file_, "",
                           std::string("cannot be written: ") + std::strerror(errno) + "; the log ends here")
                    .what());
            // Nothing of the line that has no room. A pipe or a device has no size to go back to.
            [[maybe_unused]] const int ignored = size >= 0 ? ::ftruncate(out_, size) : 0;
            ::close(std::exchange(out_, -1));
            return;
        }
        rest.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
    }
}

}  // namespace lanthorn::game

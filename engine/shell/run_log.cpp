#include "lanthorn/shell/run_log.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "engine/shell/holdings.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/printable.h"

namespace lanthorn::shell {

RunLog::RunLog(std::string program, const std::string& file) : program_(std::move(program)), file_(file) {
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
    if (!frames_.empty() && (drawn != drawn_ || passed_ > 1000)) {
        write();
    }
    drawn_ = drawn;
    frames_.push_back(std::round(100 * ms) / 100);
    passed_ += ms;
    total_ += ms;
}

void RunLog::write() {
    const Holdings now = holdings();
    nlohmann::ordered_json line = {{"seconds", std::round(total_) / 1000}};
    for (const auto& [name, word] : drawn_.words) {
        line[name] = printable(word);
    }
    line.update({{"picture", {drawn_.picture.x, drawn_.picture.y}},
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
                 {"threads", now.threads}});
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
                stderr, "%s: warning: %s\n", program_.c_str(),
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

}  // namespace lanthorn::shell

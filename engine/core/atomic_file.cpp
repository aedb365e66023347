#include "engine/core/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

#include "engine/core/error.h"

namespace lanthorn {

namespace fs = std::filesystem;

namespace {

// Unique among processes and threads, with the target's ending so that writers can tell the format from it.
fs::path temporary_beside(const fs::path& target) {
    static std::atomic<unsigned> counter{0};
    const std::string name = "." + target.stem().string() + "." + std::to_string(::getpid()) + "-" +
                             std::to_string(counter++) + ".part" + target.extension().string();
    return target.parent_path() / name;
}

}  // namespace

AtomicFile::AtomicFile(fs::path target) : target_(std::move(target)) {
    const std::string name = target_.string();
    if (target_.filename().empty()) {
        throw InputError(name.empty() ? "output" : name, "", "found no file name, expected a file to write");
    }
    std::error_code ignored;
    const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, ignored)) {
        throw InputError(name, "", "cannot be written: there is no folder '" + folder.string() + "'");
    }
    if (fs::exists(target_, ignored) && !fs::is_regular_file(target_, ignored)) {
        throw InputError(name, "", "cannot be written: it exists and is not a regular file");
    }
    temporary_ = temporary_beside(target_);
    const int file = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file < 0) {
        const int error = errno;
        throw InputError(name, "", std::string("cannot be written: ") + std::strerror(error));
    }
    ::close(file);
}

AtomicFile::~AtomicFile() {
    if (!committed_) {
        std::error_code ignored;
        fs::remove(temporary_, ignored);
    }
}

void AtomicFile::commit() {
    assert(!committed_);
    std::error_code error;
    fs::rename(temporary_, target_, error);
    if (error) {
        throw InputError(target_.string(), "", "cannot be written: " + error.message());
    }
    committed_ = true;
}

void check_writable(const fs::path& path) {
    AtomicFile probe(path);
}

}  // namespace lanthorn

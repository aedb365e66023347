#include "lanthorn/core/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

#include "lanthorn/core/error.h"

namespace lanthorn {

namespace fs = std::filesystem;

namespace {

// Unique among processes and threads.
fs::path temporary_beside(const fs::path& target) {
    static std::atomic<unsigned> counter{0};
    const std::string name = "." + target.filename().string() + "." + std::to_string(::getpid()) + "-" +
                             std::to_string(counter++) + ".part";
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
    file_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file_ < 0) {
        fail(errno);
    }
}

AtomicFile::~AtomicFile() {
    if (file_ >= 0) {
        ::close(file_);
    }
    if (!committed_) {
        std::error_code ignored;
        fs::remove(temporary_, ignored);
    }
}

void AtomicFile::write(std::string_view bytes) {
    assert(file_ >= 0);
    while (!bytes.empty()) {
        const ssize_t written = ::write(file_, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) {
            fail(errno);
        }
        bytes.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
    }
}

void AtomicFile::finish() {
    const int file = std::exchange(file_, -1);
    if (file >= 0 && ::close(file) != 0) {  // some file systems tell of a full disk only now
        fail(errno);
    }
}

void AtomicFile::commit() {
    assert(!committed_);
    finish();
    std::error_code error;
    fs::rename(temporary_, target_, error);
    if (error) {
        fail(error.value());
    }
    committed_ = true;
}

void AtomicFile::fail(int error) const {
    throw InputError(target_.string(), "", std::string("cannot be written: ") + std::strerror(error));
}

void write_file(const fs::path& path, std::string_view bytes) {
    AtomicFile file(path);
    file.write(bytes);
    file.commit();
}

void check_writable(const fs::path& path) {
    AtomicFile probe(path);
}

}  // namespace lanthorn

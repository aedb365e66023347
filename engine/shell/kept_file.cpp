#include "lanthorn/shell/kept_file.h"

#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <utility>

#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"

namespace lanthorn::shell {

namespace {

namespace fs = std::filesystem;

fs::path user_file(const char* variable, const char* below_home, std::string_view program,
                   std::string_view name) {
    for (const auto& [root, below] : {std::pair(variable, ""), std::pair("HOME", below_home)}) {
        const char* value = std::getenv(root);
        if (value != nullptr && fs::path(value).is_absolute()) {
            return fs::path(value) / below / program / name;
        }
    }
    return {};
}

std::size_t hash_of(std::string_view bytes) {
    return std::hash<std::string_view>()(bytes);
}

}  // namespace

KeptFile::KeptFile(fs::path path, std::string what, Say say)
    : path_(std::move(path)), what_(std::move(what)), say_(std::move(say)) {}

// Nothing where it cannot be read.
std::optional<std::string> KeptFile::bytes() const {
    // Opening a pipe would wait for somebody to write into it.
    std::error_code error;
    std::ifstream stream;
    if (fs::is_regular_file(path_, error) && fs::file_size(path_, error) <= kMostBytes && !error) {
        stream.open(path_, std::ios::binary);
    }
    return stream.is_open() ? std::optional(std::string(std::istreambuf_iterator<char>(stream), {}))
                            : std::nullopt;
}

std::optional<std::string> KeptFile::read() {
    std::error_code error;
    known_ = 0;
    if (path_.empty() || !fs::exists(path_, error)) {
        return std::nullopt;
    }
    std::optional<std::string> found = bytes();
    if (found) {
        known_ = hash_of(*found);
    } else {
        locked_ = true;
        say_(path_.string() + ": " + what_ + " cannot be read");
    }
    return found;
}

void KeptFile::put_aside(std::string_view problem) {
    fs::path aside = path_;
    aside += ".damaged";
    std::error_code error;
    fs::rename(path_, aside, error);
    locked_ = static_cast<bool>(error);
    known_ = 0;
    say_(std::string(problem) +
         (error ? "; cannot be put aside: " + error.message() : "; kept as " + aside.filename().string()));
}

std::optional<std::string> KeptFile::written_by_others() const {
    const std::optional<std::string> there = known_ ? bytes() : std::nullopt;
    return there && hash_of(*there) != *known_ ? there : std::nullopt;
}

void KeptFile::keep_others() {
    if (!written_by_others()) {
        return;
    }
    fs::path other = path_;
    other += ".other";
    std::error_code error;
    fs::rename(path_, other, error);
    if (!error) {
        say_(path_.string() + ": " + what_ + " was written by another program meanwhile; that is kept as " +
             other.filename().string());
    }
}

bool KeptFile::write(std::string_view bytes) {
    if (path_.empty() || locked_) {
        fail(what_ + " will not be kept");
        return false;
    }
    std::error_code error;
    fs::create_directories(path_.parent_path(), error);
    keep_others();
    try {
        write_file(path_, bytes);
        known_ = hash_of(bytes);
    } catch (const InputError& e) {
        fail(std::string(e.what()) + "; " + what_ + " will not be kept");
        return false;
    }
    return true;
}

void KeptFile::fail(const std::string& line) {
    if (!std::exchange(said_failure_, true)) {
        say_(line);
    }
}

fs::path config_file(std::string_view program, std::string_view name) {
    return user_file("XDG_CONFIG_HOME", ".config", program, name);
}
fs::path data_file(std::string_view program, std::string_view name) {
    return user_file("XDG_DATA_HOME", ".local/share", program, name);
}
fs::path cache_file(std::string_view program, std::string_view name) {
    return user_file("XDG_CACHE_HOME", ".cache", program, name);
}

}  // namespace lanthorn::shell

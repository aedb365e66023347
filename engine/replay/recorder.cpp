#include "lanthorn/replay/recorder.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <utility>

#include "engine/replay/recording_format.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"

namespace lanthorn::replay {

namespace {

constexpr double kSecondsBetweenWrites = 0.5;

// False if the system refuses; errno says why.
bool write_all(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) {
            return false;
        }
        bytes.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
    }
    return true;
}

}  // namespace

Recorder::Recorder(std::string path, RecordingHeader header, const Annotations& annotations)
    : path_(std::move(path)),
      header_(std::move(header)),
      chunk_(static_cast<std::size_t>(std::max(1.0, kSecondsBetweenWrites * header_.step_rate))) {
    const std::string beginning = encoded_beginning(header_) + encoded_annotations(annotations);
    write_file(path_, beginning);
    size_ = beginning.size();
    file_ = ::open(path_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
    if (file_ < 0) {
        throw InputError(path_, "", std::string("cannot be written: ") + std::strerror(errno));
    }
}

Recorder::~Recorder() {
    if (file_ >= 0) {
        write_waiting();
    }
    if (file_ >= 0) {
        ::close(file_);
    }
}

void Recorder::add(RecordedStep step) {
    assert(step.input.size() == header_.input_size);
    if (file_ < 0) {
        return;
    }
    waiting_.push_back(std::move(step));
    if (waiting_.size() >= chunk_) {
        write_waiting();
    }
}

void Recorder::finish() {
    if (file_ < 0) {
        return;
    }
    write_waiting();
    if (file_ >= 0) {
        append(encoded_end(written_));
    }
    if (file_ >= 0) {
        ::close(std::exchange(file_, -1));
        pack();
    }
}

// Where there is no room to do it, the file stays as it is: whole.
void Recorder::pack() const {
    try {
        write_recording(path_, read_recording(path_));
    } catch (const InputError&) {
    }
}

void Recorder::write_waiting() {
    if (waiting_.empty()) {
        return;
    }
    append(encoded_steps(header_, written_, waiting_));
    if (failure_.empty()) {
        written_ += waiting_.size();
    }
    waiting_.clear();
}

void Recorder::append(const std::string& bytes) {
    if (write_all(file_, bytes)) {
        size_ += bytes.size();
        return;
    }
    failure_ = InputError(path_, "",
                          std::string("cannot be written: ") + std::strerror(errno) + "; it ends after " +
                              std::to_string(written_) + " steps")
                   .what();
    // Nothing of the chunk that has no room, so that the file ends with a whole one. Where that fails too,
    // reading passes over the rest.
    [[maybe_unused]] const int ignored = ::ftruncate(file_, static_cast<off_t>(size_));
    ::close(std::exchange(file_, -1));
}

}  // namespace lanthorn::replay

#include "tools/editor/window/file_watch.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <mutex>
#include <thread>

namespace lanthorn::edit_window {

namespace {
constexpr int kQuiet = 200, kPoll = 2000;  // milliseconds
constexpr std::uint32_t kEvents = IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE | IN_CREATE;
}  // namespace

struct FileWatch::State {
    std::function<void()> wake;
    int notify = -1, stop = -1;
    std::mutex mutex;  // of `file` and `folder`
    std::filesystem::path file;
    int folder = -1;  // inotify's number of it
    std::atomic<bool> happened{false}, ended{false};
    std::jthread thread;

    void run();
    std::filesystem::file_time_type time_of() {
        const std::lock_guard lock(mutex);
        std::error_code error;
        return std::filesystem::last_write_time(file, error);
    }
};

void FileWatch::State::run() {
    std::array<pollfd, 2> wait{pollfd{stop, POLLIN, 0}, pollfd{notify, POLLIN, 0}};
    bool pending = false;
    auto time = time_of();
    while (!ended) {
        bool watched = false;
        {
            const std::lock_guard lock(mutex);
            watched = folder >= 0 || file.empty();
        }
        const int ready = ::poll(wait.data(), wait.size(), pending ? kQuiet : watched ? -1 : kPoll);
        if (ended) {
            return;
        }
        if ((wait[0].revents & POLLIN) != 0) {
            std::uint64_t count = 0;
            [[maybe_unused]] const auto got = ::read(stop, &count, sizeof count);
            time = time_of();
        }
        if ((wait[1].revents & POLLIN) != 0) {
            alignas(inotify_event) std::array<char, 4096> bytes;
            const auto got = ::read(notify, bytes.data(), bytes.size());
            const std::lock_guard lock(mutex);
            for (long at = 0; at < got;) {
                const auto* event = reinterpret_cast<const inotify_event*>(bytes.data() + at);
                pending = pending || (event->len > 0 && file.filename() == event->name);
                at += static_cast<long>(sizeof(inotify_event) + event->len);
            }
        } else if (ready == 0 && pending) {
            pending = false;
            happened = true;
            wake();
        } else if (ready == 0) {
            const auto now = time_of();
            if (now != time) {
                time = now;
                pending = true;
            }
        }
    }
}

FileWatch::FileWatch(std::function<void()> wake) : state_(std::make_unique<State>()) {
    state_->wake = std::move(wake);
    state_->notify = ::inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
    state_->stop = ::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
    state_->thread = std::jthread([state = state_.get()] { state->run(); });
}

FileWatch::~FileWatch() {
    state_->ended = true;
    const std::uint64_t one = 1;
    [[maybe_unused]] const auto sent = ::write(state_->stop, &one, sizeof one);
    state_->thread.join();
    ::close(state_->notify);
    ::close(state_->stop);
}

void FileWatch::watch(const std::filesystem::path& file) {
    {
        const std::lock_guard lock(state_->mutex);
        if (state_->folder >= 0) {
            ::inotify_rm_watch(state_->notify, state_->folder);
            state_->folder = -1;
        }
        std::error_code error;
        state_->file = file.empty() ? file : std::filesystem::absolute(file, error);
        if (!file.empty() && state_->notify >= 0) {
            state_->folder = ::inotify_add_watch(state_->notify, state_->file.parent_path().c_str(), kEvents);
        }
    }
    state_->happened = false;
    const std::uint64_t one = 1;
    [[maybe_unused]] const auto sent = ::write(state_->stop, &one, sizeof one);
}

bool FileWatch::happened() {
    return state_->happened.exchange(false);
}

}  // namespace lanthorn::edit_window

#include "engine/assets/work_apart.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <mutex>
#include <new>
#include <vector>

namespace lanthorn {

namespace {

constexpr std::uint8_t kEnd = 255;
constexpr int kSilence = 120'000;  // ms without a record, waited for whatever the processor does meanwhile

struct Head {
    std::uint8_t kind;
    std::uint32_t size;
};

bool write_all(int to, const void* data, std::size_t size) {
    const char* at = static_cast<const char*>(data);
    while (size > 0) {
        const ssize_t written = ::write(to, at, size);
        if (written < 0 && errno == EINTR) {
            continue;
        }
        if (written <= 0) {
            return false;
        }
        at += written;
        size -= static_cast<std::size_t>(written);
    }
    return true;
}

// The pipe's end of this side.
class Receiver {
  public:
    explicit Receiver(int from) : from_(from) {}
    Receiver(const Receiver&) = delete;
    Receiver& operator=(const Receiver&) = delete;
    ~Receiver() { ::close(from_); }

    // False at the end, on an error, and after kSilence.
    bool read(void* data, std::size_t size) {
        char* at = static_cast<char*>(data);
        while (size > 0) {
            pollfd wanted = {from_, POLLIN, 0};
            const int ready = ::poll(&wanted, 1, kSilence);
            if (ready < 0 && errno == EINTR) {
                continue;
            }
            silent_ = ready == 0;
            const ssize_t got = silent_ ? 0 : ::read(from_, at, size);
            if (got < 0 && errno == EINTR) {
                continue;
            }
            if (got <= 0) {
                return false;
            }
            at += got;
            size -= static_cast<std::size_t>(got);
        }
        return true;
    }
    bool silent() const { return silent_; }

  private:
    int from_;
    bool silent_ = false;
};

enum class End { whole, broken_off, unwanted };

End receive(Receiver& receiver, const std::function<bool(std::uint8_t, std::span<const std::byte>)>& take) {
    std::vector<std::byte> record;
    for (Head head = {}; receiver.read(&head, sizeof head);) {
        if (head.kind == kEnd) {
            return End::whole;
        }
        if (head.size > kLargestRecord) {
            return End::unwanted;
        }
        record.resize(head.size);
        if (!receiver.read(record.data(), record.size())) {
            break;
        }
        if (!take(head.kind, record)) {
            return End::unwanted;
        }
    }
    return receiver.silent() ? End::unwanted : End::broken_off;
}

int wait_for(pid_t copy) {
    int status = 0;
    while (::waitpid(copy, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

std::uint64_t address_space() {
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

void limit(int what, std::uint64_t value) {
    rlimit limits = {};
    ::getrlimit(static_cast<__rlimit_resource>(what), &limits);
    limits.rlim_cur = std::min<rlim_t>(value, limits.rlim_max);
    ::setrlimit(static_cast<__rlimit_resource>(what), &limits);
}

[[noreturn]] void run_copy(int to, const std::function<void(Sender&)>& work) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGPIPE, SIGXCPU}) {
        std::signal(signal, SIG_DFL);
    }
    const int nowhere = ::open("/dev/null", O_WRONLY);
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
    limit(RLIMIT_CORE, 0);
    Sender::allow(kWorkSeconds, kWorkBytes);
    int code = 0;
    try {
        Sender sender(to);
        work(sender);
        sender.send(kEnd, {});
    } catch (const std::bad_alloc&) {
        code = ENOMEM;
    } catch (...) {
        code = 1;
    }
    ::_exit(code);
}

std::string ending_of(int status) {
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        return signal == SIGXCPU || signal == SIGKILL ? std::string("keeps its reader busy for too long")
                                                      : fmt::format("ends its reader (signal {})", signal);
    }
    return WEXITSTATUS(status) == ENOMEM ? std::string("needs more memory than a picture of its size")
                                         : fmt::format("ends its reader (code {})", WEXITSTATUS(status));
}

}  // namespace

void Sender::send(std::uint8_t kind, std::span<const std::byte> record) {
    const Head head = {kind, static_cast<std::uint32_t>(record.size())};
    if (!write_all(to_, &head, sizeof head) || !write_all(to_, record.data(), record.size())) {
        ::_exit(1);  // nobody listens
    }
}

void Sender::allow(double seconds, std::uint64_t bytes) {
    limit(RLIMIT_CPU, static_cast<std::uint64_t>(std::ceil(seconds)));
    limit(RLIMIT_AS, address_space() + bytes);
}

std::string work_apart(const std::function<void(Sender&)>& work,
                       const std::function<bool(std::uint8_t, std::span<const std::byte>)>& take) {
    static std::mutex mutex;  // or another copy would hold this one's pipe open
    int ends[2];
    pid_t copy = -1;
    {
        const std::scoped_lock lock(mutex);
        if (::pipe2(ends, O_CLOEXEC) != 0) {
            return std::string("cannot be read now: ") + std::strerror(errno);
        }
        copy = ::fork();
        if (copy == 0) {
            ::close(ends[0]);
            run_copy(ends[1], work);
        }
        ::close(ends[1]);
    }
    if (copy < 0) {
        ::close(ends[0]);
        return std::string("cannot be read now: ") + std::strerror(errno);
    }
    Receiver receiver(ends[0]);
    End end = End::unwanted;
    try {
        end = receive(receiver, take);
    } catch (...) {
        ::kill(copy, SIGKILL);
        wait_for(copy);
        throw;
    }
    if (end == End::unwanted) {
        ::kill(copy, SIGKILL);
    }
    const int status = wait_for(copy);
    return end == End::whole ? std::string() : ending_of(status);
}

}  // namespace lanthorn

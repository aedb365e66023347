#include "tools/replay_suite/limited_child.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "tools/replay_suite/files.h"

extern char** environ;

namespace lanthorn::suite {

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr int kLook = 50;              // ms between two looks at clocks and the progress file
constexpr double kLastWords = 2;       // seconds from SIGABRT to SIGKILL
constexpr std::size_t kMost = 65'536;  // bytes kept of an output

// One output of the child.
struct Pipe {
    int ends[2] = {-1, -1};
    std::string* text = nullptr;

    bool open(std::string& to) {
        text = &to;
        return pipe2(ends, O_CLOEXEC) == 0;
    }
    void close_end(int i) {
        if (ends[i] >= 0) {
            close(std::exchange(ends[i], -1));
        }
    }
    ~Pipe() {
        close_end(0);
        close_end(1);
    }
    void take() {
        char buffer[4096];
        const ssize_t n = read(ends[0], buffer, sizeof buffer);
        if (n > 0) {
            text->append(buffer, static_cast<std::size_t>(n));
            if (text->size() > 2 * kMost) {
                text->erase(0, text->size() - kMost);
            }
        } else if (n == 0 || errno != EINTR) {
            close_end(0);
        }
    }
};

std::vector<char*> pointers(const std::vector<std::string>& texts) {
    std::vector<char*> list;
    for (const std::string& text : texts) {
        list.push_back(const_cast<char*>(text.c_str()));
    }
    list.push_back(nullptr);
    return list;
}

std::vector<std::string> with(const std::vector<std::string>& environment) {
    std::vector<std::string> all = environment;
    for (char** variable = environ; *variable != nullptr; ++variable) {
        all.emplace_back(*variable);  // getenv() finds the first of a name
    }
    return all;
}

std::optional<std::uint64_t> step_in(const std::filesystem::path& progress) {
    const std::string text = read_if_there(progress);
    std::uint64_t step = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), step);
    return error == std::errc() ? std::optional(step) : std::nullopt;
}

double cpu_seconds(const rusage& usage) {
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// In the child, between fork and exec: calls that are safe there alone.
[[noreturn]] void become(char** arguments, char** environment, const Pipe& out, const Pipe& err,
                         const Limits& limits, pid_t parent) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) {
        _exit(127);
    }
    dup2(out.ends[1], STDOUT_FILENO);
    dup2(err.ends[1], STDERR_FILENO);
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    if (limits.memory_mib > 0) {
        const rlim_t bytes = limits.memory_mib << 20;
        const rlimit memory{bytes, bytes};
        setrlimit(RLIMIT_AS, &memory);
    }
    execve(arguments[0], arguments, environment);
    _exit(127);
}

// Watches a child until its outputs are closed and it has ended.
class Watch {
  public:
    Watch(pid_t child, const Limits& limits, const std::filesystem::path& progress,
          const std::function<bool()>& stop)
        : child_(child), limits_(limits), progress_(progress), stop_(stop) {}

    void look(ChildRun& run) {
        const auto now = Clock::now();
        if (const auto step = step_in(progress_); step && step != run.last_step) {
            run.last_step = step;
            moved_ = now;
        }
        if (end_) {
            if (now - asked_ > Seconds(kLastWords)) {
                kill(-child_, SIGKILL);
            }
        } else if (stop_()) {
            end(ChildRun::End::stopped, SIGKILL);
        } else if (now - start_ > Seconds(limits_.seconds)) {
            end(ChildRun::End::timed_out, SIGABRT);
        } else if (now - moved_ > Seconds(limits_.stuck_seconds)) {
            end(ChildRun::End::stuck, SIGABRT);
        }
    }
    std::optional<ChildRun::End> ended_by_us() const { return end_; }
    double seconds() const { return Seconds(Clock::now() - start_).count(); }

  private:
    void end(ChildRun::End how, int signal) {
        end_ = how;
        asked_ = Clock::now();
        kill(-child_, signal);
    }

    pid_t child_;
    const Limits& limits_;
    const std::filesystem::path& progress_;
    const std::function<bool()>& stop_;
    Clock::time_point start_ = Clock::now(), moved_ = start_;
    Clock::time_point asked_ = start_;  // when end_ began
    std::optional<ChildRun::End> end_;
};

}  // namespace

ChildRun run_limited(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
                     const Limits& limits, const std::filesystem::path& progress,
                     const std::function<bool()>& stop) {
    ChildRun run;
    Pipe out, err;
    const std::vector<std::string> variables = with(environment);
    std::vector<char*> argv = pointers(arguments), envp = pointers(variables);
    if (!out.open(run.out) || !err.open(run.err)) {
        run.err = std::strerror(errno);
        return run;
    }
    const pid_t parent = getpid();
    const pid_t child = fork();
    if (child < 0) {
        run.err = std::strerror(errno);
        return run;
    }
    if (child == 0) {
        become(argv.data(), envp.data(), out, err, limits, parent);
    }
    setpgid(child, child);  // as the child does: whichever comes first
    out.close_end(1);
    err.close_end(1);
    Watch watch(child, limits, progress, stop);
    int status = 0;
    rusage usage{};
    for (bool ended = false; !ended;) {
        pollfd ready[] = {{out.ends[0], POLLIN, 0}, {err.ends[0], POLLIN, 0}};
        const bool closed = out.ends[0] < 0 && err.ends[0] < 0;  // it is about to end
        if (poll(ready, 2, closed ? 1 : kLook) > 0) {
            for (Pipe* pipe : {&out, &err}) {
                if (pipe->ends[0] >= 0 && ready[pipe == &err].revents != 0) {
                    pipe->take();
                }
            }
        }
        watch.look(run);
        ended = wait4(child, &status, WNOHANG, &usage) == child;
    }
    for (Pipe* pipe : {&out, &err}) {  // what was written before the end
        pollfd rest{pipe->ends[0], POLLIN, 0};
        while (pipe->ends[0] >= 0 && poll(&rest, 1, 0) > 0) {
            pipe->take();
        }
    }
    kill(-child, SIGKILL);  // what it left behind
    if (const auto step = step_in(progress)) {
        run.last_step = step;
    }
    run.wall_s = watch.seconds();
    run.cpu_s = cpu_seconds(usage);
    if (const auto end = watch.ended_by_us()) {
        run.end = *end;
    } else if (WIFSIGNALED(status)) {
        run.end = ChildRun::End::signalled;
        run.signal = WTERMSIG(status);
    } else {
        run.end = WEXITSTATUS(status) == 127 ? ChildRun::End::not_started : ChildRun::End::exited;
        run.code = WEXITSTATUS(status);
    }
    return run;
}

}  // namespace lanthorn::suite

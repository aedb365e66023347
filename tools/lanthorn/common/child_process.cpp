#include "tools/lanthorn/common/child_process.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include "lanthorn/core/stop_signal.h"

namespace lanthorn::tools {

namespace {

// Everything until the other end is closed; its last line that is not empty, and of that the last 64 KiB. If
// this program is asked to stop meanwhile, `child` is asked too, however much it has to say: a signal to this
// one alone does not reach it.
std::string read_last_line(int file, pid_t child) {
    constexpr int kLook = 100;  // ms
    constexpr std::size_t kMost = 64 * 1024;
    std::string text;
    char buffer[4096];
    bool asked = false;
    for (;;) {
        if (StopSignal::asked() && !asked) {
            asked = true;
            kill(child, StopSignal::number());
        }
        pollfd ready{file, POLLIN, 0};
        if (poll(&ready, 1, kLook) <= 0) {
            continue;
        }
        const ssize_t n = read(file, buffer, sizeof buffer);
        if (n < 0 && errno == EINTR) {
            continue;
        }
        if (n <= 0) {
            break;
        }
        text.append(buffer, static_cast<std::size_t>(n));
        if (text.size() > 2 * kMost) {
            text.erase(0, text.size() - kMost);
        }
    }
    text.erase(text.find_last_not_of("\r\n") + 1);
    return text.substr(text.find_last_of('\n') + 1);
}

}  // namespace

std::string ChildOutcome::why() const {
    if (signal != 0) {
        return fmt::format("ended by signal {} ({})", signal, strsignal(signal));
    }
    return last_line.empty() ? fmt::format("exit code {}", code) : last_line;
}

ChildOutcome run_child(const std::vector<std::string>& arguments) {
    std::vector<char*> argv;
    for (const std::string& argument : arguments) {
        argv.push_back(const_cast<char*>(argument.c_str()));
    }
    argv.push_back(nullptr);
    int ends[2];
    if (pipe(ends) != 0) {
        throw std::system_error(errno, std::generic_category(), "pipe");
    }
    const pid_t child = fork();
    if (child < 0) {
        const int error = errno;
        close(ends[0]);
        close(ends[1]);
        throw std::system_error(error, std::generic_category(), "fork");
    }
    if (child == 0) {
        dup2(ends[1], STDERR_FILENO);
        close(ends[0]);
        close(ends[1]);
        execv(argv[0], argv.data());
        _exit(127);
    }
    close(ends[1]);
    ChildOutcome outcome;
    outcome.last_line = read_last_line(ends[0], child);
    close(ends[0]);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    outcome.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    return outcome;
}

std::string own_executable() {
    return "/proc/self/exe";
}

}  // namespace lanthorn::tools

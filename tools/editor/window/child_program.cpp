#include "tools/editor/window/child_program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

#include "lanthorn/core/error.h"

namespace lanthorn::edit_window {

ChildProgram::ChildProgram(std::function<void()> ended) : ended_(std::move(ended)) {}

ChildProgram::~ChildProgram() {
    stop();
    if (thread_.joinable()) {
        thread_.join();
    }
    remove_folder();
}

void ChildProgram::remove_folder() {
    if (!folder_.empty()) {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
        folder_.clear();
    }
}

std::filesystem::path ChildProgram::make_folder(const std::string& pattern) {
    remove_folder();
    std::string name = (std::filesystem::temp_directory_path() / pattern).string();
    if (::mkdtemp(name.data()) == nullptr) {
        throw InputError(name, "", "cannot be made: a folder for a program's files");
    }
    folder_ = name;
    return folder_;
}

void ChildProgram::stop() {
    if (running_) {
        ::kill(child_, SIGTERM);
    }
}

void ChildProgram::start(const std::vector<std::string>& command, int niceness) {
    if (thread_.joinable()) {
        thread_.join();
    }
    std::vector<char*> argv;
    argv.reserve(command.size() + 1);
    for (const std::string& word : command) {
        argv.push_back(const_cast<char*>(word.c_str()));
    }
    argv.push_back(nullptr);
    const std::string errors = (folder_ / "errors").string();
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                       0600);
    const int problem = ::posix_spawn(&child_, argv[0], &actions, nullptr, argv.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    if (problem != 0) {
        throw InputError(command.front(), "", fmt::format("cannot be run: {}", std::strerror(problem)));
    }
    if (niceness > 0) {
        ::setpriority(PRIO_PROCESS, static_cast<id_t>(child_), niceness);
    }
    running_ = true;
    thread_ = std::jthread([this] { wait(); });
}

void ChildProgram::wait() {
    int status = 0;
    while (::waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
    std::string end;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        std::ifstream file(folder_ / "errors");
        for (std::string line; std::getline(file, line);) {
            end = line.empty() ? end : line;
        }
        if (end.empty()) {
            end = WIFEXITED(status) ? fmt::format("ended with {}", WEXITSTATUS(status))
                                    : fmt::format("ended by signal {}", WTERMSIG(status));
        }
    }
    {
        const std::lock_guard lock(mutex_);
        end_ = std::move(end);
    }
    running_ = false;
    ended_();
}

std::optional<std::string> ChildProgram::take_end() {
    const std::lock_guard lock(mutex_);
    return std::exchange(end_, std::nullopt);
}

}  // namespace lanthorn::edit_window

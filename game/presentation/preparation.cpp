#include "game/presentation/preparation.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

namespace lanthorn::game {

void Preparation::start(std::vector<std::string> arguments) {
    stop();
    arguments.insert(arguments.begin(), "/proc/self/exe");
    std::vector<char*> argv;
    argv.reserve(arguments.size() + 1);
    for (std::string& argument : arguments) {
        argv.push_back(argument.data());
    }
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        ::posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
    }
    if (::posix_spawn(&child_, argv[0], &actions, nullptr, argv.data(), environ) != 0) {
        child_ = 0;
    }
    ::posix_spawn_file_actions_destroy(&actions);
}

bool Preparation::running() {
    if (child_ != 0 && ::waitpid(child_, nullptr, WNOHANG) != 0) {
        child_ = 0;
    }
    return child_ != 0;
}

void Preparation::stop() {
    if (child_ == 0) {
        return;
    }
    ::kill(child_, SIGKILL);  // what it writes appears whole or not at all
    while (::waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
    }
    child_ = 0;
}

}  // namespace lanthorn::game

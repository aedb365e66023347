#include "tools/lanthorn/common/game_program.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "lanthorn/core/error.h"

namespace lanthorn::tools {

namespace fs = std::filesystem;

std::string game_program() {
    std::error_code error;
    const fs::path own = fs::read_symlink("/proc/self/exe", error).parent_path();
    for (const fs::path& path : {own / "lamplighter", own / "../../game/lamplighter"}) {
        if (!error && fs::is_regular_file(path)) {
            return path.lexically_normal().string();
        }
    }
    throw InputError("lamplighter", "", "is not installed, expected it beside this program");
}

void become_game(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), game_program());
    std::vector<char*> argv;
    for (std::string& argument : arguments) {
        argv.push_back(argument.data());
    }
    argv.push_back(nullptr);
    std::fflush(stdout);
    ::execv(argv[0], argv.data());
    throw InputError(arguments[0], "", std::string("cannot be run: ") + std::strerror(errno));
}

}  // namespace lanthorn::tools

#include "tests/unit/tools/run_program.h"

#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace lanthorn::testing_tools {

namespace fs = std::filesystem;

long Outcome::error_lines() const {
    return std::count(err.begin(), err.end(), '\n');
}

Outcome run_program(const std::string& program, const std::vector<std::string>& arguments,
                    const std::vector<std::string>& environment) {
    const TemporaryFolder folder;
    const std::string out = folder.path("stdout"), err = folder.path("stderr");
    std::vector<char*> argv = {const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments) {
        argv.push_back(const_cast<char*>(argument.c_str()));
    }
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        for (const std::string& variable : environment) {
            putenv(const_cast<char*>(variable.c_str()));
        }
        if (freopen(out.c_str(), "w", stdout) == nullptr || freopen(err.c_str(), "w", stderr) == nullptr) {
            _exit(127);
        }
        execv(program.c_str(), argv.data());
        _exit(127);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), file_bytes(out), file_bytes(err)};
}

std::string file_bytes(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TemporaryFolder::TemporaryFolder() : path_((fs::temp_directory_path() / "lanthorn-XXXXXX").string()) {
    if (mkdtemp(path_.data()) == nullptr) {
        throw std::runtime_error("no temporary folder");
    }
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

std::vector<std::string> files_in(const std::string& folder) {
    std::vector<std::string> list;
    for (const auto& entry : fs::directory_iterator(folder)) {
        list.push_back(entry.path().filename());
    }
    std::sort(list.begin(), list.end());
    return list;
}

}  // namespace lanthorn::testing_tools

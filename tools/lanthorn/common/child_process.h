// Running a program and waiting for it.
#pragma once

#include <string>
#include <vector>

namespace lanthorn::tools {

struct ChildOutcome {
    int code = 0;           // exit code; 0 as well where a signal ended it
    int signal = 0;         // that ended it; 0: none
    std::string last_line;  // of its standard error, without the newline

    bool ok() const { return code == 0 && signal == 0; }
    std::string why() const;  // "ended by signal 11 (Segmentation fault)", or its last line
};

// Runs `arguments[0]` with its standard error caught; standard output is this process's. A signal that this
// process handles does not end the waiting. Throws std::system_error if no process can be made.
ChildOutcome run_child(const std::vector<std::string>& arguments);

// This program's own executable, for run_child(): the one that runs, even if its file is replaced meanwhile.
std::string own_executable();

}  // namespace lanthorn::tools

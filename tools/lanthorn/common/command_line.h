// A program of subcommands: reads its arguments, runs what they name, and tells what went wrong.
#pragma once

#include <span>
#include <string>

#include "tools/lanthorn/commands.h"

namespace lanthorn::tools {

using AddCommand = Command (*)(CLI::App&);

// The whole of main(): returns the exit code. Every error is one line on standard error that begins with the
// program's name; exit codes are engine/core/include/lanthorn/core/error.h's.
int run_command_line(const std::string& program, const std::string& purpose,
                     std::span<const AddCommand> commands, int argc, char** argv);

}  // namespace lanthorn::tools

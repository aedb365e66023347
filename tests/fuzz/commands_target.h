// Target `commands`: the command line of `lanthorn`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/fuzz/mutation.h"

namespace lanthorn::fuzz {

// Runs `lanthorn` with one argument a line, in a folder of its own with a scene, two images and settings; '/'
// becomes '_', so that nothing outside is written. inspect, compare and convert do all that they do; commands
// that draw come as far as the missing scene. Expects the exit codes that there are, and of a refusal one
// line of at most 500 characters.
void run_commands(std::string_view input);
std::vector<std::string> command_inputs();
// Adds, takes away or exchanges whole arguments: options as they are declared, and values worth trying.
std::string damage_commands(const std::string& input, Mutator& mutator);

}  // namespace lanthorn::fuzz

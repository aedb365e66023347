// What `bash` offers when Tab is pressed behind a program's name, made from what it declares to CLI11.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

namespace lanthorn::manual {

// The values of an option, "--preset" say, in every command that has it, where the declaration itself does
// not list them. One that ends with '=' is the beginning of a value: no space is put behind it. An empty
// list: whatever it is, it is no file.
using Values = std::map<std::string, std::vector<std::string>>;

// A script for bash 4 or newer, with or without the package bash-completion: offers commands, options, and
// the values of options; where a value is a number nothing, and file names everywhere else.
std::string bash_completion(const CLI::App& app, const Values& values);

}  // namespace lanthorn::manual

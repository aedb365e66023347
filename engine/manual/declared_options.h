// What a program declares to CLI11, as its manual page and its completion need it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace lanthorn::manual {

struct DeclaredOption {
    std::vector<std::string> names;    // "-o", "--output"; of a positional argument its own name alone
    std::string value;                 // what stands behind it: "TEXT", "INT:[1 - 64]"; empty: nothing
    std::string words;                 // its help
    std::string initial;               // its default, where one is declared; may be empty
    std::vector<std::string> choices;  // the values that it accepts, where they are declared
    bool positional = false;
    bool required = false;

    bool takes_value() const { return !value.empty(); }
};

// Those that --help shows, in its order: positional ones first. A flag's opposite is a name of its own.
std::vector<DeclaredOption> declared_options(const CLI::App& app);

// The subcommands that --help shows, in the order of their declaration.
std::vector<const CLI::App*> declared_commands(const CLI::App& app);

}  // namespace lanthorn::manual

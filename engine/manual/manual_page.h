// A program's manual page (roff, for `man`) from what it declares to CLI11: what its --help says stands in
// it, and nothing of it is written twice.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace lanthorn::manual {

// What a page says besides options: sentences in plain text.
struct PageText {
    std::string version;                   // of the program: "0.1.0"
    int section = 1;                       // of the manual: 1 programs, 6 games
    std::vector<std::string> description;  // paragraphs
    struct Item {
        std::string name, words;
    };
    std::vector<Item> exit_codes, environment, files, examples;
    std::vector<std::string> see_also;  // "lamplighter(6)"
};

// The page of the program `app`, whose description begins with its purpose in one line. Every option and
// every subcommand that
// --help shows is in it.
std::string manual_page(const CLI::App& app, const PageText& text);

}  // namespace lanthorn::manual

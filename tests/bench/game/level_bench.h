// What programs that measure the game's levels have in common: words on the command line, levels by name.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace lanthorn::game {

struct LevelBench {
    std::string name;   // of the program
    std::string words;  // what comes before the levels: "WIDTH HEIGHT PRESET FRAMES"

    // Runs `measure` with those words and the levels that follow them (all of the campaign where none does),
    // in a context without a window. The exit status: 2, with a line that says why, where words are missing
    // or something is thrown.
    int run(int argc, char** argv,
            const std::function<void(const std::vector<std::string>& words,
                                     const std::vector<std::string>& levels)>& measure) const;

    // A word as a number; throws InputError below `least`.
    int number(const std::string& word, int least = 1) const;
};

}  // namespace lanthorn::game

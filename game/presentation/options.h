// The command line of lamplighter.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lanthorn/core/math.h"
#include "lanthorn/shell/frame_budget.h"

namespace lanthorn::game {

inline constexpr const char* kProgram = "lamplighter";

struct Options {
    std::string level;  // glTF file
    std::string record;
    std::string replay;
    bool headless = false;
    bool tour = false;          // every level plays itself
    bool prepare = false;       // no picture is shown: what pictures need is compiled
    bool straight = false;      // into the level, without a title: it is named, recorded or replayed
    int frames = 0;             // pictures, headless; 0: 30, or one a step where there are fewer
    std::string out;            // folder for pictures; empty: none are made
    std::optional<ivec2> size;  // of the picture; without: picture_size()
    std::string preset;
    std::vector<std::string> set;
    std::uint64_t seed = 1;
    int threads = 0;
    bool print_schedule = false;
    std::string log;             // file for lines on how the game runs; empty: none
    int close_after = 0;         // frames, for tests; 0: never
    bool escape_leaves = false;  // instead of opening the menu: for an editor that is behind the game
};

// Throws InputError on bad usage. Returns nothing after --help and its like, which it prints.
std::optional<Options> parse_options(int argc, const char* const* argv);

// The picture's size: as asked for, else what the machine can be expected to draw while somebody plays.
inline ivec2 picture_size(const Options& options, bool software_gl) {
    return options.size.value_or(shell::usual_picture_size(software_gl));
}

}  // namespace lanthorn::game

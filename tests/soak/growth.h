// Whether what a program holds grows while it runs.
#pragma once

#include <string>
#include <vector>

#include "engine/shell/holdings.h"

namespace lanthorn::game {

struct Sample {
    std::string state;  // samples of one state can be held against each other: a level in a size and preset
    shell::Holdings held;
};

// What is the least of a state comes and goes with what moves, and is the same again when all is quiet. A
// state's samples, in order of time, without the first fifth, are halved: the least of the second half must
// be no more than that of the first, but for some hundredths of the bytes and a few objects (growth.cpp). A
// line for every kind that grew, "red-wall: textures 120 -> 180". States with fewer than `fewest` samples say
// nothing.
std::vector<std::string> growth(const std::vector<Sample>& samples, std::size_t fewest = 10);

// How many states have samples enough for growth() to say something.
std::size_t states_seen(const std::vector<Sample>& samples, std::size_t fewest = 10);

// "heap 31.2 MB, ...": the least of all, and the most.
std::string summary(const std::vector<Sample>& samples);

}  // namespace lanthorn::game

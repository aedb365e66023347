// Keys of animations that are not as glTF wants them: a bad key costs the key, and the others are played.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lanthorn/scene/animation_clip.h"

namespace lanthorn {

inline constexpr float kLargestKeyValue = 1e18f;  // so that no interpolation leaves the range of floats
inline constexpr float kLargestKeyTime = 1e9f;    // seconds, after 0 and before it

// How many keys of a channel were found to be what.
struct KeyFaults {
    std::size_t bad_times = 0;       // no number or beyond kLargestKeyTime: the key is left out
    std::size_t bad_values = 0;      // no number, beyond kLargestKeyValue, a rotation of length 0: left out
    std::size_t unordered = 0;       // earlier than a key before them: sorted by time
    std::size_t repeated = 0;        // of the time of a key before them: the values leap there
    std::size_t early = 0;           // before 0: they stay, and clips are played from 0
    std::size_t long_rotations = 0;  // not of length 1: normalised

    // What was found, each with what was done, of the times and of the values; empty where nothing was.
    std::vector<std::string> about_times() const, about_values() const;
};

// Makes the keys of `channel` such as AnimationChannel wants them: times that increase and finite values,
// width (three times width of splines) for each time. Of several keys of one time the first is kept for what
// comes before and the last, the smallest step of a float later, for what comes after. Tangents before the
// first and behind the last key, which nothing uses, need not be numbers. May leave no keys at all.
// O(n log n).
KeyFaults repair_keys(AnimationChannel& channel);

}  // namespace lanthorn

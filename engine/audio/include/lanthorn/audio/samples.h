// Sound as numbers.
#pragma once

#include <vector>

namespace lanthorn::audio {

inline constexpr int kSampleRate = 44100;  // samples a second

// One channel, -1..1.
using Samples = std::vector<float>;

// Whole samples within `seconds` (0 or more), rounded down.
inline std::size_t samples_in(double seconds) {
    return static_cast<std::size_t>(seconds * kSampleRate);
}

}  // namespace lanthorn::audio

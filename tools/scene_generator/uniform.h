// Random numbers that are the same on every machine.
#pragma once

#include <cstdint>

namespace lanthorn::scene_generator {

// Number `counter` of stream `seed`, uniform in [0, 1): SplitMix64's finaliser (Steele et al. 2014).
inline double uniform(std::uint64_t seed, std::uint64_t counter) {
    std::uint64_t z = seed + (counter + 1) * 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

}  // namespace lanthorn::scene_generator

// Counter-based random numbers: a pure function of (seed, pixel, sample, dimension), so that any thread may
// draw any number and the image is the same.
//
// Every pair of numbers is the (0,2)-sequence of Sobol' under a hash-based Owen scrambling, its index
// shuffled anew for each dimension (Burley 2020, "Practical Hash-based Owen Scrambling", JCGT 9(4), sec. 4
// and 5). The samples of even and odd number are two independently scrambled sequences: the halves that noise
// is estimated from.
#pragma once

#include <cstdint>

#include "lanthorn/core/math.h"

namespace lanthorn::reference {

// A permutation of 32 bits that mixes well (Wellons 2018, "lowbias32").
inline std::uint32_t mix_bits(std::uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    x ^= x >> 16;
    return x;
}

inline std::uint32_t reverse_bits(std::uint32_t x) {
    x = (x >> 1 & 0x55555555u) | (x & 0x55555555u) << 1;
    x = (x >> 2 & 0x33333333u) | (x & 0x33333333u) << 2;
    x = (x >> 4 & 0x0f0f0f0fu) | (x & 0x0f0f0f0fu) << 4;
    return __builtin_bswap32(x);
}

// Laine and Karras 2011 with the constants of Burley 2020, listing 2: flips each bit by a hash of those
// below.
inline std::uint32_t owen_scramble_reversed(std::uint32_t x, std::uint32_t seed) {
    x += seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return x;
}

// The second dimension of Sobol's sequence, bits reversed: Pascal's triangle modulo 2, whose row and column
// meet in a 1 exactly where the one's bits contain the other's (Lucas 1878).
inline std::uint32_t sobol_second_reversed(std::uint32_t i) {
    i ^= (i & 0xaaaaaaaau) >> 1;
    i ^= (i & 0xccccccccu) >> 2;
    i ^= (i & 0xf0f0f0f0u) >> 4;
    i ^= (i & 0xff00ff00u) >> 8;
    i ^= (i & 0xffff0000u) >> 16;
    return i;
}

inline float unit_float(std::uint32_t bits) {
    return static_cast<float>(bits >> 8) * (1.0f / 16777216.0f);  // 0 <= x < 1
}

// The numbers of one sample of one pixel.
class RandomNumbers {
  public:
    RandomNumbers() = default;
    RandomNumbers(std::uint32_t seed, std::uint32_t pixel, std::uint32_t sample)
        : key_(mix_bits(mix_bits(mix_bits(seed) + pixel) ^ (sample & 1u) * 0x9e3779b9u)),
          index_(reverse_bits(sample >> 1)) {}
    // What key() and index() of another were.
    RandomNumbers(std::uint32_t key, std::uint32_t index) : key_(key), index_(index) {}

    // Two numbers in [0, 1). Pairs of different dimensions are independent of each other.
    vec2 pair(std::uint32_t dimension) const {
        const std::uint32_t key = mix_bits(key_ + dimension * 0x9e3779b9u);
        const std::uint32_t i = reverse_bits(owen_scramble_reversed(index_, key));
        const std::uint32_t x = owen_scramble_reversed(i, key * 0x2545f491u + 0x632be5abu);
        const std::uint32_t y =
            owen_scramble_reversed(sobol_second_reversed(i), key * 0x5851f42du + 0x14057b7eu);
        return {unit_float(reverse_bits(x)), unit_float(reverse_bits(y))};
    }
    std::uint32_t key() const { return key_; }
    std::uint32_t index() const { return index_; }

  private:
    std::uint32_t key_ = 0;
    std::uint32_t index_ = 0;  // bits reversed
};

}  // namespace lanthorn::reference

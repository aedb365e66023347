// Sums of numbers that are not negative, the same whatever order they come in: 64-bit integers in two words, of units that the
// passes agree on. Needs a storage buffer `uint sums[]`.
#ifndef LANTHORN_EMC_FIXED_SUMS_GLSL
#define LANTHORN_EMC_FIXED_SUMS_GLSL

const float kWord = 4294967296.0;
const float kMostUnits = 1e18;  // of one number

// Adds to sum number `at`, modulo 2^64.
void add_words(uint at, uint low, uint high) {
    uint before = atomicAdd(sums[2u * at], low);
    high += before > 0xffffffffu - low ? 1u : 0u;
    if (high != 0u) atomicAdd(sums[2u * at + 1u], high);
}

// So many units in two words.
uvec2 words_of(float units) {
    units = clamp(units, 0.0, kMostUnits);
    float words = floor(units / kWord);
    return uvec2(uint(units - words * kWord), uint(words));
}

// Adds so many units to sum number `at`.
void add_units(uint at, float units) {
    uvec2 words = words_of(units);
    add_words(at, words.x, words.y);
}

// Takes away what add_units() has added.
void take_units(uint at, float units) {
    uvec2 words = words_of(units);
    add_words(at, 0u - words.x, ~words.y + (words.x == 0u ? 1u : 0u));
}

float units_of(uint low, uint high) { return float(high) * kWord + float(low); }

#endif

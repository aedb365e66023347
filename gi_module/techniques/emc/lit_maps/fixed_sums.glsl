// Sums of numbers that are not negative, the same whatever order they come in: 64-bit integers in two words, of units that the
// passes agree on. Needs a storage buffer `uint sums[]`.
#ifndef LANTHORN_EMC_FIXED_SUMS_GLSL
#define LANTHORN_EMC_FIXED_SUMS_GLSL

const float kWord = 4294967296.0;
const float kMostUnits = 1e18;  // of one number

// Adds so many units to sum number `at`.
void add_units(uint at, float units) {
    units = clamp(units, 0.0, kMostUnits);
    float words = floor(units / kWord);
    uint low = uint(units - words * kWord);
    uint before = atomicAdd(sums[2u * at], low);
    uint high = uint(words) + (before > 0xffffffffu - low ? 1u : 0u);
    if (high != 0u) atomicAdd(sums[2u * at + 1u], high);
}

float units_of(uint low, uint high) { return float(high) * kWord + float(low); }

#endif

// Four floats at once, in the compiler's own vector type (GCC and Clang): the same operations, hence the same
// bits, on every machine.
#pragma once

#include <cmath>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace lanthorn::deform {

inline constexpr std::uint32_t kLanes = 4;

using Lanes = float __attribute__((vector_size(16)));

// Of an address that need not be aligned.
struct __attribute__((packed, may_alias)) UnalignedLanes {
    Lanes value;
};

inline Lanes splat(float x) {
    return Lanes{x, x, x, x};
}

inline void store(float* to, Lanes x) {
    reinterpret_cast<UnalignedLanes*>(to)->value = x;
}

inline Lanes square_root(Lanes x) {
#if defined(__SSE2__)
    return reinterpret_cast<Lanes>(_mm_sqrt_ps(reinterpret_cast<__m128>(x)));
#else
    return Lanes{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
#endif
}

inline Lanes least(Lanes a, Lanes b) {
    return a < b ? a : b;
}

inline Lanes greatest(Lanes a, Lanes b) {
    return a > b ? a : b;
}

// Rows become columns.
inline void transpose(Lanes& a, Lanes& b, Lanes& c, Lanes& d) {
    const Lanes ab_low = __builtin_shufflevector(a, b, 0, 4, 1, 5);
    const Lanes ab_high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
    const Lanes cd_low = __builtin_shufflevector(c, d, 0, 4, 1, 5);
    const Lanes cd_high = __builtin_shufflevector(c, d, 2, 6, 3, 7);
    a = __builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5);
    b = __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7);
    c = __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5);
    d = __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7);
}

}  // namespace lanthorn::deform

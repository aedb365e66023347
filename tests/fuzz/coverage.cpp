#include "tests/fuzz/coverage.h"

#include <cstring>

// None of what __sanitizer_cov_trace_pc calls may be instrumented, or it would call itself: it calls nothing.
namespace {

constexpr std::size_t kSize = std::tuple_size_v<lanthorn::fuzz::CoverageMap>;
std::uint8_t counts[kSize];
thread_local std::uintptr_t last = 0;

}  // namespace

extern "C" void __sanitizer_cov_trace_pc();
extern "C" [[gnu::no_sanitize_coverage, gnu::no_sanitize("address", "undefined")]] void
__sanitizer_cov_trace_pc() {
    const auto place = reinterpret_cast<std::uintptr_t>(__builtin_return_address(0));
    const std::uintptr_t mixed = (place * 0x9e3779b97f4a7c15u) >> 40u;
    std::uint8_t* count = counts + (mixed ^ last) % kSize;
    *count = static_cast<std::uint8_t>(*count == 255 ? 255 : *count + 1);
    last = mixed >> 1u;
}

namespace lanthorn::fuzz {

void begin_coverage() {
    std::memset(counts, 0, kSize);
    last = 0;
}

[[gnu::no_sanitize_coverage]] bool add_coverage(CoverageMap& seen) {
    std::uint8_t* mark = seen.data();
    bool is_new = false;
    for (std::size_t i = 0; i < kSize; ++i) {
        if (counts[i] != 0) {
            const auto bit =
                static_cast<std::uint8_t>(1u << (31u - static_cast<unsigned>(__builtin_clz(counts[i]))));
            is_new = is_new || (mark[i] & bit) == 0;
            mark[i] = static_cast<std::uint8_t>(mark[i] | bit);
        }
    }
    return is_new;
}

}  // namespace lanthorn::fuzz

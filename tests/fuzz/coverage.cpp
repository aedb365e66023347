#include "tests/fuzz/coverage.h"

#include <bit>

namespace {

lanthorn::fuzz::CoverageMap counts;
thread_local std::uintptr_t last = 0;

}  // namespace

extern "C" void __sanitizer_cov_trace_pc();
extern "C" [[gnu::no_sanitize_coverage]] void __sanitizer_cov_trace_pc() {
    const auto place = reinterpret_cast<std::uintptr_t>(__builtin_return_address(0));
    const std::uintptr_t mixed = (place * 0x9e3779b97f4a7c15u) >> 40u;
    std::uint8_t& count = counts[(mixed ^ last) % counts.size()];
    count = static_cast<std::uint8_t>(count == 255 ? 255 : count + 1);
    last = mixed >> 1u;
}

namespace lanthorn::fuzz {

[[gnu::no_sanitize_coverage]] void begin_coverage() {
    counts.fill(0);
    last = 0;
}

[[gnu::no_sanitize_coverage]] bool add_coverage(CoverageMap& seen) {
    bool is_new = false;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i] != 0) {
            const auto bit = static_cast<std::uint8_t>(1u << (std::bit_width(counts[i]) - 1u));
            is_new = is_new || (seen[i] & bit) == 0;
            seen[i] |= bit;
        }
    }
    return is_new;
}

}  // namespace lanthorn::fuzz

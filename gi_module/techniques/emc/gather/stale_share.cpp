#include "gi_module/techniques/emc/gather/stale_share.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace lanthorn::gi {

namespace {

constexpr int kUnderWay = 2;

float share(std::uint32_t held, std::uint32_t stale, int rays) {
    return static_cast<float>(stale) / std::max(static_cast<float>(held) * static_cast<float>(rays), 1.0f);
}

}  // namespace

void StaleShare::note(const EntryList& held, const EntryList& stale, int rays) {
    if (!counts_) {
        counts_ = gpu::Buffer(2 * sizeof(std::uint32_t));
    }
    if (under_way_ == kUnderWay) {
        back_.wait();
        --under_way_;
    }
    held.copy_count(counts_, 0);
    stale.copy_count(counts_, sizeof(std::uint32_t));
    back_.begin(counts_, counts_.bytes(), static_cast<std::uint64_t>(rays));
    ++under_way_;
}

float StaleShare::now(const EntryList& held, const EntryList& stale, int rays) {
    return share(held.count(), stale.count(), rays);
}

std::optional<float> StaleShare::late() {
    if (under_way_ < kUnderWay) {
        return std::nullopt;
    }
    const gpu::ReadBack::Arrived arrived = *back_.wait();
    --under_way_;
    std::array<std::uint32_t, 2> counts{};
    std::memcpy(counts.data(), arrived.bytes.data(), sizeof(counts));
    return share(counts[0], counts[1], static_cast<int>(arrived.tag));
}

void StaleShare::forget() {
    for (; under_way_ > 0; --under_way_) {
        back_.wait();
    }
}

}  // namespace lanthorn::gi

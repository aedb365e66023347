#include "gi_module/reference/free_ranges.h"

#include <algorithm>

namespace lanthorn::reference {

std::optional<std::uint32_t> FreeRanges::take(std::uint32_t count) {
    const auto fits = std::ranges::find_if(ranges_, [&](const auto& range) { return range.second >= count; });
    if (fits == ranges_.end()) {
        return std::nullopt;
    }
    const std::uint32_t first = fits->first;
    fits->first += count;
    fits->second -= count;
    if (fits->second == 0) {
        ranges_.erase(fits);
    }
    return first;
}

void FreeRanges::give(std::uint32_t first, std::uint32_t count) {
    if (count == 0) {
        return;
    }
    auto range =
        std::ranges::lower_bound(ranges_, first, {}, &std::pair<std::uint32_t, std::uint32_t>::first);
    if (range != ranges_.end() && first + count == range->first) {
        range->first = first;
        range->second += count;
    } else {
        range = ranges_.insert(range, {first, count});
    }
    if (range != ranges_.begin()) {
        const auto before = std::prev(range);
        if (before->first + before->second == range->first) {
            before->second += range->second;
            ranges_.erase(range);
        }
    }
}

}  // namespace lanthorn::reference

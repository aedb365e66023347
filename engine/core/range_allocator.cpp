#include "lanthorn/core/range_allocator.h"

#include <algorithm>
#include <iterator>

namespace lanthorn {

std::optional<std::size_t> RangeAllocator::take(std::size_t count) {
    if (count == 0) {
        return 0;
    }
    const auto range = std::ranges::find_if(ranges_, [&](const auto& r) { return r.second >= count; });
    if (range == ranges_.end()) {
        return std::nullopt;
    }
    const auto [first, size] = *range;
    ranges_.erase(range);
    if (size > count) {
        ranges_.emplace(first + count, size - count);
    }
    free_ -= count;
    return first;
}

void RangeAllocator::give_back(std::size_t first, std::size_t count) {
    if (count == 0) {
        return;
    }
    free_ += count;
    auto next = ranges_.lower_bound(first);
    if (next != ranges_.end() && next->first == first + count) {
        count += next->second;
        next = ranges_.erase(next);
    }
    if (next != ranges_.begin()) {
        const auto before = std::prev(next);
        if (before->first + before->second == first) {
            before->second += count;
            return;
        }
    }
    ranges_.emplace_hint(next, first, count);
}

void RangeAllocator::grow(std::size_t capacity) {
    if (capacity > capacity_) {
        const std::size_t first = capacity_;
        capacity_ = capacity;
        give_back(first, capacity - first);
    }
}

}  // namespace lanthorn

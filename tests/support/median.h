// The value in the middle of those that were measured.
#pragma once

#include <algorithm>
#include <ranges>
#include <vector>

namespace lanthorn::support {

// The greater of the two in the middle of an even number; 0 of none.
template <std::ranges::input_range Values>
std::ranges::range_value_t<Values> median(const Values& values) {
    std::vector<std::ranges::range_value_t<Values>> sorted(std::ranges::begin(values),
                                                           std::ranges::end(values));
    if (sorted.empty()) {
        return {};
    }
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::ranges::nth_element(sorted, middle);
    return *middle;
}

}  // namespace lanthorn::support

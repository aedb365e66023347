#pragma once

#include <algorithm>
#include <vector>

namespace lanthorn::workbench {

// The middle value, or the mean of the middle two; 0 of none. O(n log n).
inline double median_of(std::vector<double> values) {
    if (values.empty()) {
        return 0;
    }
    std::ranges::sort(values);
    const std::size_t n = values.size();
    return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

}  // namespace lanthorn::workbench

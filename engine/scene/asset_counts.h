// How many refer to each slot of an AssetTable, and which slots are free.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <queue>
#include <vector>

namespace lanthorn {

class AssetCounts {
  public:
    // A slot for a new asset, which nobody refers to yet: the lowest free one, else slot `size`, one past the
    // end of the table. O(log free slots).
    std::uint32_t take(std::size_t size) {
        std::size_t slot = size;
        if (!free_.empty()) {
            slot = free_.top();
            free_.pop();
        }
        counts_.resize(std::max(counts_.size(), slot + 1), 0);
        counts_[slot] = 0;
        return static_cast<std::uint32_t>(slot);
    }
    void free(std::uint32_t slot) { free_.push(slot); }

    std::size_t& operator[](std::uint32_t slot) { return counts_[slot]; }
    std::size_t operator[](std::uint32_t slot) const { return counts_[slot]; }

  private:
    std::vector<std::size_t> counts_;
    std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> free_;
};

}  // namespace lanthorn

// Ranges of an array that nothing uses: what is given back is taken again before the array grows.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace lanthorn::reference {

class FreeRanges {
  public:
    // Where a free range of `count` elements begins (count > 0), now taken: the first that is long enough;
    // none where there is none. O(free ranges).
    std::optional<std::uint32_t> take(std::uint32_t count);
    // Frees `count` elements from `first` on (none of them free before) and joins them with their free
    // neighbours. O(free ranges).
    void give(std::uint32_t first, std::uint32_t count);

    std::size_t size() const { return ranges_.size(); }  // free ranges; no two of them touch

  private:
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ranges_;  // where, how many; by where
};

}  // namespace lanthorn::reference

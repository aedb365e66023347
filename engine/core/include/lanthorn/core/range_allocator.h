// Ranges of a buffer, given out and taken back: first fit, neighbours joined.
#pragma once

#include <cstddef>
#include <map>
#include <optional>

namespace lanthorn {

class RangeAllocator {
  public:
    // The first place with room for `count` elements; none: the buffer must grow. A count of 0 fits anywhere.
    // O(free ranges).
    std::optional<std::size_t> take(std::size_t count);
    // A range that take() gave. O(log free ranges).
    void give_back(std::size_t first, std::size_t count);
    // Room for that many elements, not fewer than before.
    void grow(std::size_t capacity);

    std::size_t capacity() const { return capacity_; }  // in elements, as grow() was told
    std::size_t free() const { return free_; }          // in all ranges together

  private:
    std::map<std::size_t, std::size_t> ranges_;  // first free element, how many
    std::size_t capacity_ = 0;
    std::size_t free_ = 0;
};

}  // namespace lanthorn

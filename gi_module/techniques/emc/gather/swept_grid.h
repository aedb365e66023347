// Where many movers sweep, in columns of bits: so many boxes are too many to test each ray against.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::gi {

class SweptGrid {
  public:
    static constexpr int kSide = 64;    // columns along both of the longer axes of what is swept
    static constexpr int kLayers = 32;  // of a column, along the shortest: the bits of a word

    // Cells that any of the boxes, widened by `margin` metres, touches; none without boxes. O(cells touched).
    void fill(std::span<const Aabb> boxes, float margin);
    bool empty() const { return columns_.empty(); }

    // As swept_grid.glsl has them.
    const std::vector<std::uint32_t>& columns() const { return columns_; }
    vec3 lower() const { return bounds_.lower; }  // render space
    vec3 cells_a_metre() const;
    int up() const { return up_; }  // the axis of columns

  private:
    Aabb bounds_;
    int up_ = 1;
    std::vector<std::uint32_t> columns_;  // kSide * kSide
};

}  // namespace lanthorn::gi

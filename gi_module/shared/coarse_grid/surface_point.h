// A point that light is computed at. surface_points.comp writes these as two vec4.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::gi {

struct SurfacePoint {
    vec3 position{0};         // render space
    float distance = 0;       // as GBuffer::distance(); 0: nothing is seen there
    vec3 normal{0};           // the triangle's own, unit, towards the viewer
    std::uint32_t pixel = 0;  // x | y << 16, rows from the bottom
    ivec2 xy() const { return {static_cast<int>(pixel & 0xffffu), static_cast<int>(pixel >> 16)}; }
};
static_assert(sizeof(SurfacePoint) == 32);

// All of a picture: one a cell of the lattice of every `spacing`-th pixel, row by row from the bottom, then
// the extra ones between, by pixel (y, then x).
struct GridPoints {
    ivec2 size{0};    // of the picture, pixels
    int spacing = 1;  // pixels
    ivec2 cells{0};   // of the lattice
    std::vector<SurfacePoint> points;

    std::size_t lattice() const {
        return static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y);
    }
    std::size_t cell_index(ivec2 cell) const {
        return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(cells.x) +
               static_cast<std::size_t>(cell.x);
    }
    bool has_cell(ivec2 cell) const {
        return cell.x >= 0 && cell.y >= 0 && cell.x < cells.x && cell.y < cells.y;
    }
    std::span<const SurfacePoint> extras() const { return std::span(points).subspan(lattice()); }
};

}  // namespace lanthorn::gi

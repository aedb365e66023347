// Triangles over some of an instance's vertices, which rays meet in place of its own.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace lanthorn::reference {

struct ReducedShape {
    std::vector<std::uint32_t> vertices;  // of the instance's: those in use, ascending
    std::vector<std::uint32_t> indices;   // into `vertices`, 3 a triangle
    float error = 0;  // how far they lie from the instance's own, a share of the diagonal of its box
};

// By instance in FrameScene's order; null: its own triangles. Empty: all have their own.
using ReducedShapes = std::vector<std::shared_ptr<const ReducedShape>>;

}  // namespace lanthorn::reference

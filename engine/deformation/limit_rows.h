// OpenSubdiv's limit masks carried back to the control points. For surface_builder.cpp alone.
#pragma once

#include <opensubdiv/far/topologyRefiner.h>

#include "engine/deformation/sparse_rows.h"

namespace lanthorn::deform {

// Limit positions and tangents of the last level's vertices, as sums of control points.
struct LimitRows {
    SparseRows position, du, dv;
};

// `refiner` is refined uniformly with full topology in its last level. O(vertices of that level).
LimitRows limit_rows(const OpenSubdiv::Far::TopologyRefiner& refiner, std::size_t controls);

}  // namespace lanthorn::deform

// A refined surface as sums of control points: each vertex's limit position and two tangents there, linear in
// the control points with weights that never change (Stam 1998; OpenSubdiv's limit stencils).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/deformation/vertex_group.h"

namespace lanthorn::deform {

// What one control point adds to a vertex.
struct StencilEntry {
    std::uint32_t control;
    float position, du, dv;
};

struct LimitVertex {
    std::uint32_t first, end;  // into LimitStencils::entries; several vertices may share theirs
    // The tangent of the texture (glTF 2.0, 3.7.2.1) as the sum of so much of du and dv; its bitangent's
    // sign.
    float along_du, along_dv, sign;
    vec3 normal;  // of the bind pose: where the surface has none
};

struct LimitStencils {
    std::uint32_t control_count = 0;
    std::vector<StencilEntry> entries;
    std::vector<LimitVertex> vertices;
};

// Vertices [first, end) of the surface over `controls` (xyz; one a control point) to to[first..end).
// `mirrored`: the controls are a mirror image of the bind pose, so du x dv points inwards. Adds to `bounds`.
// first is a multiple of 4. O(entries), about 1.5 ns each.
void evaluate(const LimitStencils& stencils, std::span<const Lanes> controls, bool mirrored,
              std::uint32_t first, std::uint32_t end, VertexFrame* to, BoundsLanes& bounds);

}  // namespace lanthorn::deform

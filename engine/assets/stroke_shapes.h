// Points and lines as surfaces that light falls on: glTF gives them no thickness, and a pixel's would differ
// from view to view.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "engine/assets/vertex_frames.h"

namespace lanthorn {

using Stroke = std::pair<std::uint32_t, std::uint32_t>;  // vertices; twice the same: a point

// The radius that suits strokes between such vertices: 1/500 of their extent, 5 mm where they have none.
float stroke_radius(const Mesh& mesh);

// Replaces the triangles and vertices of `mesh`: a point becomes an octahedron, a line a rod of four sides,
// both with smooth normals, any tangents, and all else as their vertices have it. Lines without length become
// points. O(strokes).
VertexSources make_strokes(Mesh& mesh, const std::vector<Stroke>& strokes, float radius);

}  // namespace lanthorn

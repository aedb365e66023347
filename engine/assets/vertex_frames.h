// Normals and tangents: generating those that a mesh lacks, mending those that are none.
#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/scene/mesh.h"

namespace lanthorn {

// Removes triangles without area: two equal corners, or a height below 1e-12 of an edge. Returns how many.
// O(n).
std::size_t remove_flat_triangles(Mesh& mesh);

// Removes vertices that no triangle uses; the others keep their order. O(n).
void remove_unused_vertices(Mesh& mesh);

// Gives each triangle its own three vertices with the triangle's normal (glTF 2.0, 3.7.2.1). The mesh must
// have no flat triangles.
void make_flat_normals(Mesh& mesh);

// Normalises the normals; those that are zero or not finite become the area-weighted mean of the triangles
// around the vertex (+Z if that is zero too). Returns how many were replaced.
std::size_t mend_normals(Mesh& mesh);

// Normalises the tangents; those that are zero, not finite or parallel to the normal become any unit vector
// perpendicular to it, and w becomes +1 or -1. Returns how many were replaced. Normals must be mended.
std::size_t mend_tangents(Mesh& mesh);

// Tangents along the texture's U axis (Lengyel 2001), weighted by corner angles as MikkTSpace does; vertices
// shared by mirrored and unmirrored triangles are split. `uv_set` is 0 or 1. Normals must be mended.
void generate_tangents(Mesh& mesh, std::uint32_t uv_set);

// Unit tangents perpendicular to the normals, for materials that do not care. Normals must be mended.
void make_any_tangents(Mesh& mesh);

}  // namespace lanthorn

// Normals and tangents: generating those that a mesh lacks, mending those that are none.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "lanthorn/scene/mesh.h"

namespace lanthorn {

// Where each vertex comes from: vertex i of the mesh after is vertex sources[i] of the mesh before.
using VertexSources = std::vector<std::uint32_t>;

// Removes triangles without area: two equal corners, or a height below 1e-12 of an edge. One with three
// different corners stays if `may_open` says so: deformation may give it an area. Returns how many. O(n).
std::size_t remove_flat_triangles(
    Mesh& mesh, const std::function<bool(const std::array<std::uint32_t, 3>&)>& may_open = {});

// Removes vertices that no triangle uses; the others keep their order. O(n).
VertexSources remove_unused_vertices(Mesh& mesh);

// Gives each triangle its own three vertices with the triangle's normal (glTF 2.0, 3.7.2.1; +Z for one
// without area).
VertexSources make_flat_normals(Mesh& mesh);

// The unit normal of triangle `corners`, which are counter-clockwise; zero without area.
vec3 triangle_normal(const std::array<vec3, 3>& corners);

// Normalises the normals; those that are zero or not finite become the area-weighted mean of the triangles
// around the vertex (+Z if that is zero too). Returns how many were replaced.
std::size_t mend_normals(Mesh& mesh);

// Normalises the tangents; those that are zero, not finite or parallel to the normal become any unit vector
// perpendicular to it, and w becomes +1 or -1. Returns how many were replaced. Normals must be mended.
std::size_t mend_tangents(Mesh& mesh);

// Tangents along the texture's U axis (Lengyel 2001), weighted by corner angles as MikkTSpace does; vertices
// shared by mirrored and unmirrored triangles are split if `may_split`. `uv_set` is 0 or 1. Normals must be
// mended.
VertexSources generate_tangents(Mesh& mesh, std::uint32_t uv_set, bool may_split = true);

// Unit tangents perpendicular to the normals, for materials that do not care. Normals must be mended.
void make_any_tangents(Mesh& mesh);

}  // namespace lanthorn

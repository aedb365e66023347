// Subdivision cages made for these tests.
#pragma once

#include <vector>

#include "lanthorn/scene/mesh.h"
#include "tests/unit/deformation/evaluator.h"

namespace deformation_test {

// A mesh of these faces, fans of triangles, with a cage of them.
Mesh cage_of(const std::vector<vec3>& positions, const std::vector<std::vector<std::uint32_t>>& faces,
             SubdivisionScheme scheme, std::uint32_t level);
// -1..1, six quads over eight vertices.
Mesh cube_cage(std::uint32_t level);
// The same with four vertices a face, as texture seams split it; uv0 is 0..1 on each face.
Mesh split_cube_cage(std::uint32_t level);
// (+-1, 0, 0), (0, +-1, 0), (0, 0, +-1), eight triangles.
Mesh octahedron_cage(std::uint32_t level);
// Two storeys over a pentagon with a roof of triangles and one wall left out: faces of three, four and five
// corners, and a boundary.
Mesh house_cage(std::uint32_t level);
// size x size quads over 0..1 in z = 0; uv0 is x, y.
Mesh grid_cage(std::uint32_t size, std::uint32_t level);

// The limit positions of the mesh's refined vertices, by OpenSubdiv's own interpolation in double precision
// with the mesh's vertices at `vertices`; each once, unordered. Only for cages without two vertices in one
// place.
std::vector<dvec3> limit_positions(const Mesh& mesh, const std::vector<ExactVertex>& vertices);

}  // namespace deformation_test

// The faces of a subdivision cage, joined where glTF had to split vertices.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lanthorn/scene/mesh.h"

namespace lanthorn::deform {

// Vertices that lie on each other bit for bit in the bind pose and are moved by the same joints and morphs
// are one control point: what tells them apart is uv, colour or normal.
struct CageTopology {
    std::vector<std::uint32_t> control_vertices;  // a mesh vertex of each control point
    std::vector<int> face_sizes;                  // corners
    std::vector<int> corners;                     // control point of each corner, face by face
    std::vector<int> corner_vertices;             // mesh vertex of each corner
    std::vector<int> crease_ends;                 // two control points a crease
    std::vector<float> crease_sharpness;

    std::string problem;  // what forbids to subdivide it; then the rest is of no use
    std::string remark;   // what was left out
};

// Needs mesh.cage. Refuses faces that do not use up the triangles, that are no fan, or that have a control
// point twice, edges of more than two faces, and neighbours that turn opposite ways. O(n log n) of the
// corners.
CageTopology cage_topology(const Mesh& mesh);

}  // namespace lanthorn::deform

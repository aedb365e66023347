// Where a refined surface is not smooth: pieces between creases. For surface_builder.cpp alone.
#pragma once

#include <opensubdiv/far/topologyLevel.h>

#include <cstddef>
#include <vector>

namespace lanthorn::deform {

// The faces around a vertex from one sharp edge (or boundary) to the next: one smooth piece of the surface.
struct Sector {
    std::vector<int> spokes;  // the vertices at the other ends of its edges, counter-clockwise
};

// Splits the faces around each vertex of the last level where an edge between two of them is still sharp.
class Sectors {
  public:
    explicit Sectors(const OpenSubdiv::Far::TopologyLevel& level) : level_(level) {}

    // Of the vertex: none if it is smooth all around, and then `of_face` all 0; else `of_face` says to which
    // the faces belong, in the order of GetVertexFaces.
    void split(int vertex);
    std::vector<Sector> sectors;
    std::vector<std::size_t> of_face;

  private:
    bool divides(int edge) const { return level_.IsEdgeBoundary(edge) || level_.GetEdgeSharpness(edge) > 0; }
    int other_end(int edge, int vertex) const {
        const auto ends = level_.GetEdgeVertices(edge);
        return ends[0] == vertex ? ends[1] : ends[0];
    }
    const OpenSubdiv::Far::TopologyLevel level_;
};

}  // namespace lanthorn::deform

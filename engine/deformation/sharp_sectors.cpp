#include "engine/deformation/sharp_sectors.h"

#include <utility>

namespace lanthorn::deform {

void Sectors::split(int vertex) {
    const auto faces = level_.GetVertexFaces(vertex);
    const auto corners = level_.GetVertexFaceLocalIndices(vertex);
    sectors.clear();
    of_face.assign(static_cast<std::size_t>(faces.size()), 0);
    const auto leading = [&](int f) { return level_.GetFaceEdges(faces[f])[corners[f]]; };
    const auto trailing = [&](int f) {
        const auto edges = level_.GetFaceEdges(faces[f]);
        return edges[(corners[f] + edges.size() - 1) % edges.size()];
    };
    std::vector<int> starts;
    bool sharp = false;
    for (int f = 0; f < faces.size(); ++f) {
        if (!divides(leading(f))) {
            continue;
        }
        starts.push_back(f);
        sharp = sharp || !level_.IsEdgeBoundary(leading(f));
    }
    if (starts.size() < 2 || !sharp) {
        return;
    }
    for (const int start : starts) {
        Sector sector;
        sector.spokes.push_back(other_end(leading(start), vertex));
        for (int f = start;;) {
            of_face[static_cast<std::size_t>(f)] = sectors.size();
            const int edge = trailing(f);
            sector.spokes.push_back(other_end(edge, vertex));
            if (divides(edge)) {
                break;
            }
            for (f = 0; leading(f) != edge;) {
                ++f;
            }
        }
        sectors.push_back(std::move(sector));
    }
}

}  // namespace lanthorn::deform

#include "engine/deformation/cage_topology.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <utility>

namespace lanthorn::deform {
namespace {

// Everything that moves a vertex, as bytes.
std::vector<std::string> movers_of(const Mesh& mesh) {
    std::vector<std::string> bytes(mesh.vertices.size());
    const auto append = [](std::string& to, const void* from, std::size_t size) {
        to.append(static_cast<const char*>(from), size);
    };
    for (std::size_t v = 0; v < bytes.size(); ++v) {
        const vec3 position = mesh.vertices[v].position + vec3(0);  // -0 is 0
        append(bytes[v], &position, sizeof position);
        if (v < mesh.skin.size()) {
            append(bytes[v], &mesh.skin[v], sizeof mesh.skin[v]);
        }
    }
    for (std::uint32_t t = 0; t < mesh.morphs.size(); ++t) {
        const MorphTarget& target = mesh.morphs[t];
        for (std::size_t i = 0; i < target.vertices.size(); ++i) {
            append(bytes[target.vertices[i]], &t, sizeof t);
            append(bytes[target.vertices[i]], &target.positions[i], sizeof(vec3));
        }
    }
    return bytes;
}

// Fills face_sizes and corner_vertices from the fans.
void read_faces(const Mesh& mesh, CageTopology& cage) {
    const std::size_t triangles = mesh.indices.size() / 3;
    std::vector<std::uint32_t> sizes = mesh.cage->face_sizes;
    if (sizes.empty()) {
        sizes.assign(triangles, 3);
    }
    std::size_t triangle = 0;
    for (const std::uint32_t size : sizes) {
        const std::string face = "face " + std::to_string(cage.face_sizes.size());
        if (size < 3 || size - 2 > triangles - triangle) {
            cage.problem =
                face + " of its cage has " + std::to_string(size) + " corners, which its triangles do not";
            return;
        }
        if (size != 3 && mesh.cage->scheme == SubdivisionScheme::loop) {
            cage.problem =
                face + " of its cage has " + std::to_string(size) + " corners, Loop's scheme wants 3";
            return;
        }
        const std::uint32_t* fan = mesh.indices.data() + triangle * 3;
        cage.face_sizes.push_back(static_cast<int>(size));
        cage.corner_vertices.push_back(static_cast<int>(fan[0]));
        cage.corner_vertices.push_back(static_cast<int>(fan[1]));
        for (std::uint32_t t = 0; t + 2 < size; ++t) {
            if (fan[t * 3] != fan[0] || static_cast<int>(fan[t * 3 + 1]) != cage.corner_vertices.back()) {
                cage.problem = face + " of its cage is not a fan of triangles";
                return;
            }
            cage.corner_vertices.push_back(static_cast<int>(fan[t * 3 + 2]));
        }
        triangle += size - 2;
    }
    if (triangle != triangles) {
        cage.problem = "the faces of its cage do not use up its triangles";
    }
}

void join_vertices(const Mesh& mesh, CageTopology& cage, std::vector<int>& control_of) {
    const std::vector<std::string> movers = movers_of(mesh);
    std::map<std::string_view, int> controls;
    control_of.assign(mesh.vertices.size(), -1);
    for (const int v : cage.corner_vertices) {
        const auto vertex = static_cast<std::size_t>(v);
        const auto [found, fresh] = controls.emplace(movers[vertex], static_cast<int>(controls.size()));
        if (fresh) {
            cage.control_vertices.push_back(static_cast<std::uint32_t>(v));
        }
        control_of[vertex] = found->second;
        cage.corners.push_back(found->second);
    }
}

using Edge = std::pair<int, int>;

// Each edge once in each direction at most.
std::set<Edge> check_edges(CageTopology& cage) {
    std::set<Edge> directed;
    const int* corner = cage.corners.data();
    for (std::size_t f = 0; f < cage.face_sizes.size(); ++f) {
        const int size = cage.face_sizes[f];
        const std::string face = "face " + std::to_string(f);
        std::vector<int> sorted(corner, corner + size);
        std::sort(sorted.begin(), sorted.end());
        if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
            cage.problem = face + " of its cage is degenerate: it has a corner twice";
            return directed;
        }
        for (int i = 0; i < size; ++i) {
            if (!directed.emplace(corner[i], corner[(i + 1) % size]).second) {
                cage.problem = face +
                               " of its cage makes it non-manifold: another face has one of its edges in the "
                               "same direction";
                return directed;
            }
        }
        corner += size;
    }
    return directed;
}

void read_creases(const Mesh& mesh, const std::vector<int>& control_of, const std::set<Edge>& edges,
                  CageTopology& cage) {
    std::size_t lost = 0;
    for (const SubdivisionCrease& crease : mesh.cage->creases) {
        const bool exists = crease.from < control_of.size() && crease.to < control_of.size();
        const Edge edge = exists ? Edge(control_of[crease.from], control_of[crease.to]) : Edge(-1, -1);
        const bool found = edges.count(edge) > 0 || edges.count({edge.second, edge.first}) > 0;
        if (!found || std::isnan(crease.sharpness)) {
            ++lost;
        } else if (crease.sharpness > 0) {
            cage.crease_ends.insert(cage.crease_ends.end(), {edge.first, edge.second});
            cage.crease_sharpness.push_back(std::min(crease.sharpness, 10.0f));
        }
    }
    if (lost > 0) {
        cage.remark =
            std::to_string(lost) + " of the creases of its cage are no edges of it or not numbers; left out";
    }
}

}  // namespace

CageTopology cage_topology(const Mesh& mesh) {
    CageTopology cage;
    read_faces(mesh, cage);
    if (!cage.problem.empty()) {
        return cage;
    }
    std::vector<int> control_of;
    join_vertices(mesh, cage, control_of);
    const std::set<Edge> edges = check_edges(cage);
    if (cage.problem.empty()) {
        read_creases(mesh, control_of, edges, cage);
    }
    return cage;
}

}  // namespace lanthorn::deform

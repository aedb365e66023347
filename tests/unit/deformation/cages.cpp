#include "tests/unit/deformation/cages.h"

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <cmath>
#include <memory>

namespace deformation_test {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

Mesh cage_of(const std::vector<vec3>& positions, const std::vector<std::vector<std::uint32_t>>& faces,
             SubdivisionScheme scheme, std::uint32_t level) {
    Mesh mesh;
    mesh.name = "cage";
    for (const vec3& p : positions) {
        Vertex v;
        v.position = p;
        mesh.vertices.push_back(v);
        mesh.bounds.add(p);
    }
    mesh.cage = SubdivisionCage{scheme, level, {}, {}};
    for (const auto& face : faces) {
        mesh.cage->face_sizes.push_back(std::uint32_t(face.size()));
        for (std::size_t i = 1; i + 1 < face.size(); ++i) {
            mesh.indices.insert(mesh.indices.end(), {face[0], face[i], face[i + 1]});
        }
    }
    return mesh;
}

namespace {

std::vector<vec3> cube_corners() {
    std::vector<vec3> corners;
    for (int i = 0; i < 8; ++i) {
        corners.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    }
    return corners;
}

// Counter-clockwise seen from outside.
const std::vector<std::vector<std::uint32_t>> kCubeFaces{{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3},
                                                         {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}};

}  // namespace

Mesh cube_cage(std::uint32_t level) {
    return cage_of(cube_corners(), kCubeFaces, SubdivisionScheme::catmull_clark, level);
}

Mesh split_cube_cage(std::uint32_t level) {
    const std::vector<vec3> corners = cube_corners();
    std::vector<vec3> positions;
    std::vector<std::vector<std::uint32_t>> faces;
    for (const auto& face : kCubeFaces) {
        faces.emplace_back();
        for (const std::uint32_t corner : face) {
            faces.back().push_back(std::uint32_t(positions.size()));
            positions.push_back(corners[corner]);
        }
    }
    Mesh mesh = cage_of(positions, faces, SubdivisionScheme::catmull_clark, level);
    for (std::size_t i = 0; i < mesh.vertices.size(); i += 4) {
        const vec3 a = positions[i], b = positions[i + 1], d = positions[i + 3];
        for (std::size_t k = 0; k < 4; ++k) {
            mesh.vertices[i + k].uv0 = vec2(k == 1 || k == 2, k >= 2);
            mesh.vertices[i + k].normal = glm::normalize(glm::cross(b - a, d - a));
            mesh.vertices[i + k].tangent = vec4(glm::normalize(b - a), 1);
        }
    }
    return mesh;
}

Mesh octahedron_cage(std::uint32_t level) {
    return cage_of({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                   {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}},
                   SubdivisionScheme::loop, level);
}

Mesh house_cage(std::uint32_t level) {
    std::vector<vec3> positions;
    std::vector<std::vector<std::uint32_t>> faces{{4, 3, 2, 1, 0}};
    for (std::uint32_t i = 0; i < 15; ++i) {
        const float angle = 2 * kPi * float(i % 5) / 5;
        positions.emplace_back(std::sin(angle), i / 5, std::cos(angle));
    }
    positions.emplace_back(0, 3, 0);
    // The upper storey lacks a wall.
    for (std::uint32_t i = 0; i < 5; ++i) {
        const std::uint32_t next = (i + 1) % 5;
        faces.push_back({i, next, next + 5, i + 5});
        if (i > 0) {
            faces.push_back({i + 5, next + 5, next + 10, i + 10});
        }
    }
    for (std::uint32_t i = 0; i < 5; ++i) {
        faces.push_back({i + 10, (i + 1) % 5 + 10, 15});
    }
    return cage_of(positions, faces, SubdivisionScheme::catmull_clark, level);
}

Mesh grid_cage(std::uint32_t size, std::uint32_t level) {
    std::vector<vec3> positions;
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::uint32_t y = 0; y <= size; ++y) {
        for (std::uint32_t x = 0; x <= size; ++x) {
            positions.emplace_back(float(x) / size, float(y) / size, 0);
        }
    }
    for (std::uint32_t y = 0; y < size; ++y) {
        for (std::uint32_t x = 0; x < size; ++x) {
            const std::uint32_t i = y * (size + 1) + x;
            faces.push_back({i, i + 1, i + size + 2, i + size + 1});
        }
    }
    Mesh mesh = cage_of(positions, faces, SubdivisionScheme::catmull_clark, level);
    for (Vertex& v : mesh.vertices) {
        v.uv0 = vec2(v.position);
    }
    return mesh;
}

namespace {

struct Point {
    dvec3 at{0};
    void Clear() { at = dvec3(0); }
    void AddWithWeight(const Point& p, double w) { at += w * p.at; }
};

}  // namespace

std::vector<dvec3> limit_positions(const Mesh& mesh, const std::vector<ExactVertex>& vertices) {
    std::vector<int> sizes, corners, crease_ends;
    std::vector<float> sharpness;
    const std::uint32_t* fan = mesh.indices.data();
    for (const std::uint32_t size : mesh.cage->face_sizes) {
        sizes.push_back(int(size));
        corners.insert(corners.end(), {int(fan[0]), int(fan[1])});
        for (std::uint32_t t = 0; t + 2 < size; ++t, fan += 3) {
            corners.push_back(int(fan[2]));
        }
    }
    for (const SubdivisionCrease& crease : mesh.cage->creases) {
        crease_ends.insert(crease_ends.end(), {int(crease.from), int(crease.to)});
        sharpness.push_back(crease.sharpness);
    }
    Far::TopologyDescriptor topology;
    topology.numVertices = int(mesh.vertices.size());
    topology.numFaces = int(sizes.size());
    topology.numVertsPerFace = sizes.data();
    topology.vertIndicesPerFace = corners.data();
    topology.numCreases = int(sharpness.size());
    topology.creaseVertexIndexPairs = crease_ends.data();
    topology.creaseWeights = sharpness.data();
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    Sdc::Options options;
    options.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
    const auto type = mesh.cage->scheme == SubdivisionScheme::loop ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK;
    const std::unique_ptr<Far::TopologyRefiner> refiner(
        Factory::Create(topology, Factory::Options(type, options)));
    Far::TopologyRefiner::UniformOptions uniform(int(mesh.cage->level));
    uniform.fullTopologyInLastLevel = true;
    refiner->RefineUniform(uniform);
    std::vector<Point> points;
    for (const ExactVertex& v : vertices) {
        points.push_back({v.position});
    }
    const Far::PrimvarRefinerReal<double> interpolate(*refiner);
    for (int level = 1; level <= refiner->GetMaxLevel(); ++level) {
        std::vector<Point> next(std::size_t(refiner->GetLevel(level).GetNumVertices()));
        interpolate.Interpolate(level, points, next);
        points = std::move(next);
    }
    std::vector<Point> limit(points.size());
    interpolate.Limit(points, limit);
    std::vector<dvec3> result;
    for (const Point& p : limit) {
        result.push_back(p.at);
    }
    return result;
}

}  // namespace deformation_test

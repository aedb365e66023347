// Corners and subdivision.
#include "gi_module/techniques/vertex-map/vertex_mesh.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/shapes.h"

namespace lanthorn::gi {
namespace {

struct Shape {
    explicit Shape(const Mesh& mesh) : indices(mesh.indices) {
        for (const Vertex& v : mesh.vertices) {
            positions.push_back(v.position);
            normals.push_back(v.normal);
        }
    }
    VertexMesh made(std::vector<std::uint8_t> levels, bool shared = true) const {
        return make_vertex_mesh({positions, normals, indices}, levels, shared);
    }
    VertexMesh made(std::uint8_t level, bool shared = true) const {
        return made(std::vector<std::uint8_t>(indices.size() / 3, level), shared);
    }
    vec3 at(const VertexMesh& mesh, std::uint32_t corner) const {
        return mesh.corners[corner].of(std::span<const vec3>(positions));
    }
    // Signed by the normal of the mesh's triangle: 0 if any is turned over.
    double area(const VertexMesh& mesh) const {
        double sum = 0;
        for (std::size_t t = 0; t < mesh.sources.size(); ++t) {
            const vec3 a = at(mesh, mesh.triangles[3 * t]), b = at(mesh, mesh.triangles[3 * t + 1]),
                       c = at(mesh, mesh.triangles[3 * t + 2]);
            const std::uint32_t* own = &indices[3 * mesh.sources[t]];
            const vec3 normal = glm::normalize(
                glm::cross(positions[own[1]] - positions[own[0]], positions[own[2]] - positions[own[0]]));
            const float part = 0.5f * glm::dot(glm::cross(b - a, c - a), normal);
            EXPECT_GT(part, 0);
            sum += static_cast<double>(part);
        }
        return sum;
    }

    std::vector<vec3> positions, normals;
    std::vector<std::uint32_t> indices;
};

const Shape kRoom(support::box(vec3(0), vec3(1, 2, 3), true, 0));

// A box has 8 vertices in space; walls meet at right angles and share none: 24, by fig. 20 not 36.
TEST(VertexMesh, CornersOfABoxAreSharedWithinItsWalls) {
    EXPECT_EQ(kRoom.made(std::uint8_t{0}).corners.size(), 24u);
    EXPECT_EQ(kRoom.made(std::uint8_t{0}, false).corners.size(), 36u);
}

TEST(VertexMesh, ASphereHasOneCornerAVertex) {
    const Shape ball(support::sphere(vec3(0), 1, 3, false, 0));
    const VertexMesh mesh = ball.made(std::uint8_t{0});
    EXPECT_EQ(mesh.corners.size(), ball.positions.size());
    EXPECT_TRUE(mesh.hanging.empty());
}

class ByLevel : public ::testing::TestWithParam<int> {};

TEST_P(ByLevel, AWallIsAGridOfCorners) {
    const auto level = static_cast<std::uint8_t>(GetParam());
    const std::size_t n = std::size_t{1} << level;
    const VertexMesh mesh = kRoom.made(level);
    EXPECT_EQ(mesh.sources.size(), 12 * n * n);
    EXPECT_EQ(mesh.corners.size(), 6 * (n + 1) * (n + 1));
    EXPECT_TRUE(mesh.hanging.empty());
    EXPECT_NEAR(kRoom.area(mesh), 22, 1e-4);
    // Without sharing every triangle of the mesh has its own.
    EXPECT_EQ(kRoom.made(level, false).corners.size(), 12 * (n + 1) * (n + 2) / 2);
}

INSTANTIATE_TEST_SUITE_P(Levels, ByLevel, ::testing::Range(0, 5));

TEST(VertexMesh, AFinerTriangleHangsOnItsCoarserNeighbour) {
    const Shape quad(support::quad(vec3(0), vec3(1, 0, 0), vec3(0, 1, 0), 0));
    const VertexMesh mesh = quad.made({3, 1});
    EXPECT_NEAR(quad.area(mesh), 1, 1e-5);
    // Of the 7 corners inside the diagonal the coarser triangle has one: the others lie between its ends.
    ASSERT_EQ(mesh.hanging.size(), 6u);
    std::set<std::uint32_t> hanging;
    for (const HangingCorner& h : mesh.hanging) {
        hanging.insert(h.corner);
    }
    for (const HangingCorner& h : mesh.hanging) {
        EXPECT_FALSE(hanging.contains(h.from) || hanging.contains(h.to));
        const vec3 between = glm::mix(quad.at(mesh, h.from), quad.at(mesh, h.to), h.share);
        EXPECT_LT(glm::distance(quad.at(mesh, h.corner), between), 1e-6f);
        EXPECT_GT(h.share, 0);
        EXPECT_LT(h.share, 1);
        EXPECT_NEAR(glm::distance(quad.at(mesh, h.from), quad.at(mesh, h.to)), std::sqrt(0.5f), 1e-6f);
    }
}

TEST(VertexMesh, NoTrianglesAreNoCorners) {
    const VertexMesh mesh = make_vertex_mesh({}, {}, true);
    EXPECT_TRUE(mesh.corners.empty());
    EXPECT_TRUE(mesh.triangles.empty());
}

TEST(VertexMesh, LevelsHalveEdges) {
    EXPECT_EQ(level_for_edge(1, 1), 0);
    EXPECT_EQ(level_for_edge(1.01f, 1), 1);
    EXPECT_EQ(level_for_edge(8, 1), 3);
    EXPECT_EQ(level_for_edge(8, 0), kMostLevels);
    EXPECT_EQ(level_for_edge(0, 0), 0);
}

// Every place of a triangle, on a grid that is no piece's: by the piece that has it, where it is.
TEST(VertexMesh, PiecesAreFoundByPlace) {
    const Shape triangle(support::quad(vec3(0), vec3(4, 0, 0), vec3(0, 3, 0), 0));
    for (std::uint8_t level = 0; level <= 4; ++level) {
        const VertexMesh mesh = triangle.made(level);
        ASSERT_EQ(mesh.firsts.size(), 2u);
        for (std::size_t t = 0; t < 2; ++t) {
            for (int i = 0; i <= 37; ++i) {
                for (int j = 0; i + j <= 37; ++j) {
                    const vec3 weights = vec3(i, j, 37 - i - j) / 37.0f;
                    const PieceAt at = piece_at(level, weights);
                    const std::size_t piece = mesh.firsts[t] + at.piece;
                    ASSERT_LT(piece, mesh.sources.size());
                    ASSERT_EQ(mesh.sources[piece], t);
                    vec3 wanted(0), got(0);
                    for (std::size_t k = 0; k < 3; ++k) {
                        const auto w = static_cast<glm::length_t>(k);
                        ASSERT_GE(at.weights[w], -1e-5f);
                        wanted += weights[w] * triangle.positions[triangle.indices[3 * t + k]];
                        got += at.weights[w] * triangle.at(mesh, mesh.triangles[3 * piece + k]);
                    }
                    ASSERT_LT(glm::distance(got, wanted), 1e-5f) << i << ' ' << j;
                }
            }
        }
    }
}

}  // namespace
}  // namespace lanthorn::gi

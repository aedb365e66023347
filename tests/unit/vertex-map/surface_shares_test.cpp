// Areas of circles on surfaces, against what is known of them.
#include "gi_module/techniques/vertex-map/surface_shares.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace lanthorn::gi {
namespace {

std::vector<vec3> positions_of(const Mesh& mesh) {
    std::vector<vec3> positions;
    for (const Vertex& v : mesh.vertices) {
        positions.push_back(v.position);
    }
    return positions;
}

SurfaceTriangles triangles_of(const Mesh& mesh, float reach) {
    return {positions_of(mesh), mesh.indices, reach};
}

// A square of 4 m of side^2 quads.
Mesh tiles(int side) {
    Mesh fine;
    const float step = 4.0f / static_cast<float>(side);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const Mesh tile = support::quad(vec3(x, y, 0) * step, vec3(step, 0, 0), vec3(0, step, 0), 0);
            const auto first = static_cast<std::uint32_t>(fine.vertices.size());
            fine.vertices.insert(fine.vertices.end(), tile.vertices.begin(), tile.vertices.end());
            for (const std::uint32_t i : tile.indices) {
                fine.indices.push_back(first + i);
            }
        }
    }
    return fine;
}

// Shares of such a square are those of one quad; `backs`: seen from behind, with both sides.
void expect_as_of_one(const SurfaceTriangles& many, float within, bool backs = false) {
    const SurfaceTriangles one = triangles_of(support::quad(vec3(0), vec3(4, 0, 0), vec3(0, 4, 0), 0), 0.5f);
    const vec3 normal(0, 0, backs ? -1 : 1);
    for (const vec3& p :
         {vec3(0), vec3(2, 2, 0), vec3(4, 1.97f, 0), vec3(0.03f, 3.9f, 0), vec3(2, 2, 0.2f)}) {
        const SurfaceShares a = many.about(p, normal, backs), b = one.about(p, normal, backs);
        for (std::size_t k = 0; k < SurfaceShares::kSteps; ++k) {
            EXPECT_NEAR(a.shares[k], b.shares[k], within) << k;
        }
    }
}

TEST(SurfaceShares, OfARoomAreHalfAtEdgesAndAQuarterInCorners) {
    const SurfaceTriangles room = triangles_of(support::box(vec3(0), vec3(4), true, 0), 1);
    const vec3 up(0, 1, 0);
    EXPECT_NEAR(room.about(vec3(2, 0, 2), up, false).at(0.7f), 1, 1e-4f);
    EXPECT_NEAR(room.about(vec3(0, 0, 2), up, false).at(0.7f), 0.5f, 1e-4f);
    EXPECT_NEAR(room.about(vec3(0, 0, 4), up, false).at(0.7f), 0.25f, 1e-4f);
    // Walls are other surfaces, and so is the floor's back.
    EXPECT_EQ(room.about(vec3(2, 0, 2), -up, false).at(1), 0);
    EXPECT_NEAR(room.about(vec3(2, 0, 2), -up, true).at(1), 1, 1e-4f);
}

// Archimedes: a sphere of radius r about a point of a sphere cuts off a cap of area pi r^2 from it.
TEST(SurfaceShares, OfASphereAreThoseOfACap) {
    const SurfaceTriangles ball = triangles_of(support::sphere(vec3(3), 1, 4, false, 0), 0.8f);
    const SurfaceShares shares =
        ball.about(vec3(3) + glm::normalize(vec3(1, 2, 3)), glm::normalize(vec3(1, 2, 3)), false);
    EXPECT_NEAR(shares.at(0.5f), 1, 0.02f);
    EXPECT_NEAR(shares.at(1), 1, 0.02f);
}

TEST(SurfaceShares, FindEveryTriangleInAnyCell) {
    // Many small triangles and cells: the same as one large one.
    expect_as_of_one(triangles_of(tiles(40), 0.5f), 2e-3f);
}

TEST(SurfaceShares, OfGroupsOfTrianglesAreNearlyThoseOfEach) {
    const Mesh fine = tiles(120);
    ASSERT_GT(fine.indices.size() / 3, SurfaceTriangles::kMany);
    expect_as_of_one(triangles_of(fine, 0.5f), 0.02f);
    expect_as_of_one(triangles_of(fine, 0.5f), 0.02f, true);
}

TEST(SurfaceShares, OfNoTrianglesAreNone) {
    const SurfaceTriangles none(std::span<const vec3>(), {}, 1);
    EXPECT_EQ(none.about(vec3(0), vec3(0, 0, 1), true).at(0.5f), 0);
}

}  // namespace
}  // namespace lanthorn::gi

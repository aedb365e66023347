// Which triangles are one surface.
#include "gi_module/techniques/splat/surface_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/shapes.h"

namespace lanthorn::gi::test {
namespace {

SurfaceParts parts_of(const Mesh& mesh) {
    std::vector<vec3> positions;
    for (const Vertex& v : mesh.vertices) {
        positions.push_back(v.position);
    }
    return surface_parts(positions, mesh.indices);
}

TEST(SurfaceParts, ABoxHasSixSurfaces) {
    const SurfaceParts parts = parts_of(support::box(vec3(0), vec3(1, 2, 3), true, 0));
    EXPECT_EQ(parts.count, 6u);
    for (std::size_t face = 0; face < 6; ++face) {
        EXPECT_EQ(parts.of_triangle[2 * face], parts.of_triangle[2 * face + 1]);
    }
}

TEST(SurfaceParts, ASphereIsOneAndItsNeighboursAreEachOthers) {
    const SurfaceParts parts = parts_of(support::sphere(vec3(0), 1, 2, false, 0));
    EXPECT_EQ(parts.count, 1u);
    for (std::uint32_t t = 0; t < parts.neighbours.size(); ++t) {
        for (const std::uint32_t n : parts.neighbours[t]) {
            ASSERT_NE(n, kNoTriangle);
            EXPECT_TRUE(std::ranges::count(parts.neighbours[n], t) == 1);
        }
    }
}

// A roof whose halves turn by an angle about the ridge.
SurfaceParts roof(float turn) {
    const std::vector<vec3> p{vec3(0, 0, 0), vec3(0, 0, 1), vec3(-1, 0, 0),
                              vec3(std::cos(turn), -std::sin(turn), 0)};
    const std::vector<std::uint32_t> i{0, 1, 3, 1, 0, 2};
    return surface_parts(p, i);
}

TEST(SurfaceParts, ABendEndsASurfaceFrom35DegreesOn) {
    EXPECT_EQ(roof(0.0f).count, 1u);
    EXPECT_EQ(roof(0.6f).count, 1u);
    EXPECT_EQ(roof(0.62f).count, 2u);
    EXPECT_EQ(roof(-0.62f).count, 2u);
}

TEST(SurfaceParts, WhereThreeMeetNoneGoesOn) {
    const std::vector<vec3> p{vec3(0), vec3(0, 0, 1), vec3(1, 0, 0), vec3(-1, 0, 0), vec3(-1, 0.1f, 0)};
    EXPECT_EQ(surface_parts(p, std::vector<std::uint32_t>{0, 1, 2, 1, 0, 3, 1, 0, 4}).count, 3u);
}

TEST(SurfaceParts, FrontsThatDisagreeAreTwo) {
    const std::vector<vec3> p{vec3(0), vec3(0, 0, 1), vec3(1, 0, 0), vec3(-1, 0, 0)};
    EXPECT_EQ(surface_parts(p, std::vector<std::uint32_t>{0, 1, 2, 0, 1, 3}).count, 2u);
}

TEST(SurfaceParts, NothingOneVertexAndNoAreaAreNoTrouble) {
    EXPECT_EQ(surface_parts({}, {}).count, 0u);
    const std::vector<vec3> one{vec3(1)};
    EXPECT_EQ(surface_parts(one, std::vector<std::uint32_t>{0, 0, 0}).count, 1u);
    EXPECT_EQ(surface_parts(one, {}).count, 0u);
}

}  // namespace
}  // namespace lanthorn::gi::test

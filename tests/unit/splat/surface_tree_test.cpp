// The area of a surface within a sphere: closed forms, and the paper's own walk over the mesh.
#include "gi_module/techniques/splat/surface_tree.h"

#include <gtest/gtest.h>

#include <vector>

#include "gi_module/reference/random.h"
#include "gi_module/techniques/splat/surface_parts.h"
#include "tests/support/closed_forms.h"
#include "tests/support/shapes.h"

namespace lanthorn::gi::test {
namespace {

using support::kPiD;

std::vector<std::array<vec3, 3>> triangles_of(const Mesh& mesh) {
    std::vector<std::array<vec3, 3>> result;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        result.push_back({mesh.vertices[mesh.indices[i]].position,
                          mesh.vertices[mesh.indices[i + 1]].position,
                          mesh.vertices[mesh.indices[i + 2]].position});
    }
    return result;
}

// Does the segment come within the radius of 0?
bool cuts(const dvec3& a, const dvec3& b, double radius) {
    const dvec3 d = b - a;
    const double t = glm::clamp(-glm::dot(a, d) / glm::dot(d, d), 0.0, 1.0);
    return glm::length(a + d * t) < radius;
}

// Lavignotte and Paulin 2003, sec. 4.1, steps 1 to 4.
double walk(const std::vector<std::array<vec3, 3>>& triangles, const SurfaceParts& parts, std::uint32_t first,
            const vec3& centre, double radius) {
    std::vector<bool> mailbox(triangles.size(), false);
    std::vector<std::uint32_t> waiting{first};
    mailbox[first] = true;
    double area = 0;
    while (!waiting.empty()) {
        const std::uint32_t t = waiting.back();
        waiting.pop_back();
        const std::array<dvec3, 3> p{dvec3(triangles[t][0] - centre), dvec3(triangles[t][1] - centre),
                                     dvec3(triangles[t][2] - centre)};
        area += sphere_triangle(p, radius).area;
        for (std::size_t side = 0; side < 3; ++side) {
            const std::uint32_t next = parts.neighbours[t][side];
            if (next != kNoTriangle && !mailbox[next] && cuts(p[side], p[(side + 1) % 3], radius)) {
                mailbox[next] = true;
                waiting.push_back(next);
            }
        }
    }
    return area;
}

TEST(SurfaceTree, FindsWhatTheWalkOverTheMeshFinds) {
    const Mesh mesh = support::sphere(vec3(3, 1, 2), 1.5f, 4, false, 0);
    const auto triangles = triangles_of(mesh);
    std::vector<vec3> positions;
    for (const Vertex& v : mesh.vertices) {
        positions.push_back(v.position);
    }
    const SurfaceParts parts = surface_parts(positions, mesh.indices);
    const SurfaceTree tree(triangles);
    for (std::uint32_t i = 0; i < 50; ++i) {
        const auto t = i * 97 % static_cast<std::uint32_t>(triangles.size());
        const vec3 centre = (triangles[t][0] + triangles[t][1] + triangles[t][2]) / 3.0f;
        const double radius = 0.05 * (i + 1);
        const double walked = walk(triangles, parts, t, centre, radius);
        EXPECT_NEAR(tree.within(centre, radius).area / walked, 1, 1e-6) << radius;
    }
}

TEST(SurfaceTree, OfAPlaneIsTheDiscAndItsHalfAtTheEdge) {
    const SurfaceTree tree(triangles_of(support::quad(vec3(0), vec3(0, 0, 4), vec3(4, 0, 0), 0)));
    EXPECT_NEAR(tree.area(), 16, 1e-6);
    EXPECT_NEAR(tree.within(vec3(2, 0, 2), 0.5).area, kPiD * 0.25, 1e-6);
    EXPECT_NEAR(tree.within(vec3(2, 0, 2), 0.5).moment, 0.5 * kPiD * 0.0625, 1e-6);
    EXPECT_NEAR(tree.within(vec3(0, 0, 2), 0.5).area, kPiD * 0.125, 1e-6);
    EXPECT_NEAR(tree.within(vec3(0, 0, 0), 0.5).area, kPiD * 0.0625, 1e-6);
    EXPECT_NEAR(tree.within(vec3(2, 0, 2), 10).area, 16, 1e-6);
    EXPECT_EQ(tree.within(vec3(2, 3, 2), 1).area, 0);
}

// A cap of a sphere has the area of the disc of its chord: pi r^2 (Archimedes).
TEST(SurfaceTree, OfASphereIsTheCap) {
    const SurfaceTree tree(triangles_of(support::sphere(vec3(0), 1, 5, false, 0)));
    for (const double r : {0.3, 0.9, 1.5}) {
        EXPECT_NEAR(tree.within(vec3(0, 1, 0), r).area / (kPiD * r * r), 1, 5e-3) << r;
    }
}

// Sums over whole branches, taken about points far from the origin, against the sum over triangles.
TEST(SurfaceTree, MomentsAreThoseOfTheTriangles) {
    const vec3 far(1000, 200, -3000);
    const auto triangles = triangles_of(support::sphere(far, 2, 3, false, 0));
    const SurfaceTree tree(triangles);
    for (const double radius : {0.7, 2.5, 3.9, 6.0}) {
        const vec3 centre = far + vec3(0, 2, 0);
        AreaMoment sum;
        for (const auto& t : triangles) {
            sum += sphere_triangle(
                {dvec3(t[0]) - dvec3(centre), dvec3(t[1]) - dvec3(centre), dvec3(t[2]) - dvec3(centre)},
                radius);
        }
        const AreaMoment got = tree.within(centre, radius);
        EXPECT_NEAR(got.area / sum.area, 1, 1e-9);
        EXPECT_NEAR(got.moment / sum.moment, 1, 1e-9);
    }
}

TEST(SurfaceTree, NothingAndNoAreaHaveNone) {
    EXPECT_EQ(SurfaceTree().within(vec3(0), 1).area, 0);
    EXPECT_EQ(SurfaceTree().area(), 0);
    const SurfaceTree point({{vec3(1), vec3(1), vec3(1)}});
    EXPECT_EQ(point.area(), 0);
    EXPECT_EQ(point.within(vec3(1), 1).area, 0);
    const SurfaceTree many(
        std::vector<std::array<vec3, 3>>(1000, {vec3(0), vec3(1, 0, 0), vec3(0, 1, 0)}));  // in one place
    EXPECT_NEAR(many.within(vec3(0), 0.5).area, 1000 * kPiD / 16, 1e-6);
}

}  // namespace
}  // namespace lanthorn::gi::test

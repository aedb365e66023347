// Cages that are damaged, degenerate or at the ends of what a float holds.
#include <cmath>
#include <limits>

#include "engine/deformation/vertex_group.h"
#include "tests/unit/deformation/cage_stage.h"
#include "tests/unit/deformation/cages.h"

namespace deformation_test {
namespace {

TEST(Subdivision, ACollapsedCageHasSoundFrames) {
    Mesh mesh = cube_cage(2);
    mesh.skin.assign(8, {{0}, {1}});
    Cage cage(mesh, 1);
    cage.world.get_mut<WorldTransform>(cage.figure.joints[0]).matrix = dmat4(0);
    cage.world.get_mut<WorldTransform>(cage.figure.joints[0]).matrix[3][3] = 1;
    cage.update();
    expect_whole(cage.result());
}

struct BadCage {
    const char* name;
    Mesh (*make)();
    const char* says;
};

class BadCages : public testing::TestWithParam<BadCage> {};

TEST_P(BadCages, AreNamedAndDrawnAsTheyAre) {
    Mesh mesh = GetParam().make();
    Random random(24);
    add_skin(mesh, 2, 2, random);
    Cage cage(mesh, 2);
    ASSERT_EQ(cage.deformation.warnings().size(), 1u);
    EXPECT_NE(cage.deformation.warnings()[0].find("mesh 'cage'"), std::string::npos);
    EXPECT_NE(cage.deformation.warnings()[0].find(GetParam().says), std::string::npos)
        << cage.deformation.warnings()[0];
    EXPECT_FALSE(cage.result().refined);
    expect_near(cage.result(), skinned(mesh, {}, cage.joint_matrices(cage.figure), cage.figure.inverse_binds),
                cage.deformed(cage.figure).skinned_at, mesh.bounds.diagonal());
}

INSTANTIATE_TEST_SUITE_P(
    Cages, BadCages,
    testing::Values(BadCage{"ThreeFacesAtAnEdge",
                            [] {
                                return cage_of({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}},
                                               {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}},
                                               SubdivisionScheme::catmull_clark, 2);
                            },
                            "non-manifold"},
                    BadCage{"NeighboursThatTurnOppositeWays",
                            [] {
                                return cage_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
                                               {{0, 1, 2}, {1, 2, 3}}, SubdivisionScheme::loop, 2);
                            },
                            "non-manifold"},
                    BadCage{"TwoFansAtAVertex",
                            [] {
                                return cage_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}},
                                               {{0, 1, 2}, {0, 3, 4}}, SubdivisionScheme::catmull_clark, 2);
                            },
                            "two fans"},
                    BadCage{"ACornerTwice",
                            [] {
                                return cage_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 1, 2}},
                                               SubdivisionScheme::catmull_clark, 2);
                            },
                            "degenerate"},
                    BadCage{"FacesThatDoNotUseUpTheTriangles",
                            [] {
                                Mesh mesh = cube_cage(2);
                                mesh.cage->face_sizes.pop_back();
                                return mesh;
                            },
                            "use up"},
                    BadCage{"MoreCornersThanTriangles",
                            [] {
                                Mesh mesh = cube_cage(2);
                                mesh.cage->face_sizes.back() = 4000000000u;
                                return mesh;
                            },
                            "corners"},
                    BadCage{"NoFan",
                            [] {
                                Mesh mesh = cube_cage(2);
                                std::swap(mesh.indices[3], mesh.indices[4]);
                                return mesh;
                            },
                            "fan"},
                    BadCage{"QuadsForLoop",
                            [] {
                                Mesh mesh = cube_cage(2);
                                mesh.cage->scheme = SubdivisionScheme::loop;
                                return mesh;
                            },
                            "Loop"}),
    [](const auto& info) { return info.param.name; });

TEST(Subdivision, AnyFacesGiveASurfaceOrAReason) {
    Random random(25);
    int surfaces = 0, refusals = 0;
    for (int i = 0; i < 400; ++i) {
        const std::uint32_t count = 4 + random.below(4);
        std::vector<vec3> positions;
        for (std::uint32_t v = 0; v < count; ++v) {
            // Some in one place, so that they are joined.
            positions.push_back(random.below(6) ? random.vector(1) : vec3(0));
        }
        std::vector<std::vector<std::uint32_t>> faces(1 + random.below(4));
        for (auto& face : faces) {
            const std::uint32_t corners = 3 + random.below(3), first = random.below(count);
            for (std::uint32_t k = 0; k < corners; ++k) {
                face.push_back(random.below(8) ? (first + k) % count : random.below(count));
            }
        }
        Mesh mesh =
            cage_of(positions, faces, i % 2 ? SubdivisionScheme::loop : SubdivisionScheme::catmull_clark,
                    1 + random.below(3));
        for (int c = 0; c < 3; ++c) {
            mesh.cage->creases.push_back({random.below(count), random.below(count), random.between(-2, 12)});
        }
        Cage cage(mesh);
        if (cage.result().vertices) {
            expect_whole(cage.result());
            ++surfaces;
        } else {
            EXPECT_FALSE(cage.deformation.warnings().empty());
            ++refusals;
        }
    }
    EXPECT_GT(surfaces, 20);
    EXPECT_GT(refusals, 20);
}

TEST(Subdivision, CreasesThatAreNoneAreLeftOutAndCounted) {
    Mesh mesh = cube_cage(1);
    mesh.cage->creases = {{0, 7, 2}, {0, 99, 2}, {0, 1, NAN}, {0, 1, 3}};
    Cage cage(mesh);
    expect_whole(cage.result());
    ASSERT_EQ(cage.deformation.warnings().size(), 1u);
    EXPECT_NE(cage.deformation.warnings()[0].find("3 of the creases"), std::string::npos);
}

// At the ends of what a float holds, tangents overflow.
TEST(Subdivision, HugeCagesHaveSoundFrames) {
    int drawn = 0;
    for (const float size : {1e18f, 1e30f, 1e38f, 3e38f}) {
        for (const float other : {1.0f, -1e-38f, -3e38f}) {
            Mesh mesh = cube_cage(2);
            for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
                mesh.vertices[i].position *= vec3(size, i % 3 == 0 ? other : size, i % 2 == 0 ? size : 1.0f);
            }
            Cage cage(mesh);
            if (!cage.result().vertices) {
                continue;  // refused: beyond what a float holds
            }
            ++drawn;
            for (const VertexFrame& v : *cage.result().vertices) {
                for (int axis = 0; axis < 3; ++axis) {
                    ASSERT_TRUE(std::isfinite(v.position[axis]));
                }
                ASSERT_NEAR(glm::length(v.normal), 1, 1e-4f) << size << ' ' << other;
                ASSERT_NEAR(glm::length(vec3(v.tangent)), 1, 1e-4f) << size << ' ' << other;
            }
        }
    }
    EXPECT_GT(drawn, 6);
}

TEST(UnitOr, FallsBackWhateverIsNoDirection) {
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        for (const double bad : {nan, infinity, -infinity}) {
            dvec3 v(1, 2, 3);
            v[axis] = bad;
            EXPECT_EQ(deform::unit_or(v, vec3(0, 1, 0)), vec3(0, 1, 0)) << axis << ' ' << bad;
        }
    }
    EXPECT_EQ(deform::unit_or(dvec3(0), vec3(0, 1, 0)), vec3(0, 1, 0));
    EXPECT_EQ(deform::unit_or(dvec3(0, 0, -1e300), vec3(0, 1, 0)), vec3(0, 0, -1));
    EXPECT_EQ(deform::unit_or(dvec3(1e-300, 0, 0), vec3(0, 1, 0)), vec3(1, 0, 0));
}

}  // namespace
}  // namespace deformation_test

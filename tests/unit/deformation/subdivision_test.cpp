#include <algorithm>
#include <cstring>
#include <map>
#include <set>

#include "engine/deformation/cage_topology.h"
#include "engine/deformation/subdivision_surface.h"
#include "tests/unit/deformation/allocations.h"
#include "tests/unit/deformation/cage_stage.h"
#include "tests/unit/deformation/cages.h"

namespace deformation_test {
namespace {

const VertexFrame* vertex_at(const std::vector<VertexFrame>& vertices, const vec3& at) {
    for (const VertexFrame& v : vertices) {
        if (glm::length(v.position - at) < 1e-5f) {
            return &v;
        }
    }
    return nullptr;
}

// Triangles' own normals and those of their vertices look the same way.
void expect_facing(const DeformedMesh& mesh) {
    const auto& v = *mesh.vertices;
    for (std::size_t i = 0; i < mesh.refined->indices.size(); i += 3) {
        const VertexFrame &a = v[mesh.refined->indices[i]], &b = v[mesh.refined->indices[i + 1]],
                          &c = v[mesh.refined->indices[i + 2]];
        const vec3 normal = glm::cross(b.position - a.position, c.position - a.position);
        EXPECT_GT(glm::dot(normal, a.normal + b.normal + c.normal), 0) << "triangle " << i / 3;
    }
}

// Every edge between two triangles, bit for bit.
void expect_closed(const DeformedMesh& mesh) {
    using Key = std::array<float, 6>;
    std::map<Key, int> edges;
    for (std::size_t i = 0; i < mesh.refined->indices.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const vec3 a = (*mesh.vertices)[mesh.refined->indices[i + k]].position;
            const vec3 b = (*mesh.vertices)[mesh.refined->indices[i + (k + 1) % 3]].position;
            ++edges[Key{a.x, a.y, a.z, b.x, b.y, b.z}];
            --edges[Key{b.x, b.y, b.z, a.x, a.y, a.z}];
        }
    }
    for (const auto& [edge, sides] : edges) {
        ASSERT_EQ(sides, 0);
    }
}

TEST(Subdivision, ACubesCornerGoesHalfWay) {
    // Valence 3: (9 v + 4 (sum of edge neighbours) + (sum of face opposites)) / 24 = (9 + 4 - 1) / 24.
    Cage cage(cube_cage(2));
    expect_whole(cage.result());
    EXPECT_EQ(cage.vertices().size(), 98u);
    EXPECT_EQ(cage.topology().indices.size(), 6u * 16 * 2 * 3);
    const VertexFrame* corner = vertex_at(cage.vertices(), vec3(0.5f));
    ASSERT_TRUE(corner);
    EXPECT_LE(glm::length(corner->normal - glm::normalize(vec3(1))), 1e-6f);
    expect_facing(cage.result());
    expect_closed(cage.result());
    EXPECT_TRUE(cage.deformation.warnings().empty());
}

TEST(Subdivision, AnOctahedronsCornerGoesWhereLoopSays) {
    // Loop's beta for valence 4 is (5/8 - (3/8)^2) / 4; in the limit a neighbour weighs 1 / (3 / (8 beta) +
    // 4).
    const double beta = (5.0 / 8 - 9.0 / 64) / 4, chi = 1 / (3 / (8 * beta) + 4);
    Cage cage(octahedron_cage(3));
    expect_whole(cage.result());
    EXPECT_EQ(cage.topology().indices.size(), 8u * 64 * 3);
    const VertexFrame* corner = vertex_at(cage.vertices(), vec3(0, 0, 1 - 4 * chi));
    ASSERT_TRUE(corner);
    EXPECT_LE(glm::length(corner->normal - vec3(0, 0, 1)), 1e-6f);
    expect_facing(cage.result());
    expect_closed(cage.result());
}

TEST(Subdivision, AFlatGridStaysFlatAndItsTextureInPlace) {
    Cage cage(grid_cage(4, 3));
    expect_whole(cage.result());
    EXPECT_EQ(cage.vertices().size(), 33u * 33);
    for (std::size_t i = 0; i < cage.vertices().size(); ++i) {
        const VertexFrame& v = cage.vertices()[i];
        EXPECT_LE(glm::length(v.normal - vec3(0, 0, 1)), 1e-5f);
        EXPECT_LE(glm::length(vec3(v.tangent) - vec3(1, 0, 0)), 1e-5f);
        EXPECT_EQ(v.position.z, 0);
    }
    for (const vec3 corner :
         {vec3(0, 0, 0), vec3(1, 0, 0), vec3(1, 1, 0), vec3(0, 1, 0), vec3(0.5f, 0.5f, 0)}) {
        const VertexFrame* v = vertex_at(cage.vertices(), corner);
        ASSERT_TRUE(v);
        const vec2 uv = cage.topology().uv0[std::size_t(v - cage.vertices().data())];
        EXPECT_LE(glm::length(uv - vec2(corner)), 1e-6f);
    }
    expect_facing(cage.result());
}

TEST(Subdivision, VerticesThatTheTextureSplitAreJoined) {
    Cage whole(cube_cage(3)), split(split_cube_cage(3));
    expect_whole(split.result());
    expect_closed(split.result());
    expect_facing(split.result());
    EXPECT_GT(split.vertices().size(), whole.vertices().size());
    for (const VertexFrame& v : split.vertices()) {
        const VertexFrame* same = vertex_at(whole.vertices(), v.position);
        ASSERT_TRUE(same);
        EXPECT_LE(glm::length(same->normal - v.normal), 1e-5f);
    }
    // Each face has the whole of the texture.
    for (std::size_t i = 0; i < split.vertices().size(); ++i) {
        const vec2 uv = split.topology().uv0[i];
        EXPECT_TRUE(uv.x >= -1e-6f && uv.y >= -1e-6f && uv.x <= 1 + 1e-6f && uv.y <= 1 + 1e-6f);
    }
    const auto corners = std::count_if(split.topology().uv0.begin(), split.topology().uv0.end(),
                                       [](const vec2& uv) { return uv == vec2(0) || uv == vec2(1); });
    EXPECT_EQ(corners, 12);
}

TEST(Subdivision, SharpCreasesKeepACubeACubeWithFlatSides) {
    Mesh mesh = cube_cage(2);
    for (std::uint32_t a = 0; a < 8; ++a) {
        for (const std::uint32_t bit : {1u, 2u, 4u}) {
            if (!(a & bit)) {
                mesh.cage->creases.push_back({a, a | bit, 10});
            }
        }
    }
    Cage cage(mesh);
    expect_whole(cage.result());
    EXPECT_TRUE(vertex_at(cage.vertices(), vec3(1)));
    for (std::size_t i = 0; i < cage.topology().indices.size(); i += 3) {
        const auto vertex = [&](std::size_t k) { return cage.vertices()[cage.topology().indices[i + k]]; };
        const vec3 normal = glm::normalize(
            glm::cross(vertex(1).position - vertex(0).position, vertex(2).position - vertex(0).position));
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_LE(glm::length(vertex(k).normal - normal), 1e-4f);
        }
    }
    expect_closed(cage.result());
}

TEST(Subdivision, ACornersSectorMayBeWiderThanAHalfTurn) {
    // A floor of three quads around the corner of a pit, and two of the pit's walls.
    Mesh mesh = cage_of({{0, 0, 0},
                         {1, 0, 0},
                         {4, 0, 0},
                         {0, 1, 0},
                         {1, 1, 0},
                         {4, 1, 0},
                         {0, 4, 0},
                         {1, 4, 0},
                         {4, 1, -1},
                         {1, 1, -1},
                         {1, 4, -1}},
                        {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}, {4, 5, 8, 9}, {7, 4, 9, 10}},
                        SubdivisionScheme::catmull_clark, 2);
    mesh.cage->creases = {{4, 5, 10}, {4, 7, 10}, {4, 9, 10}};
    for (Vertex& v : mesh.vertices) {
        v.normal = {1, 0, 0};
    }
    Cage cage(mesh);
    expect_whole(cage.result());
    // One along each axis.
    vec3 normals(0);
    int sides = 0;
    for (const VertexFrame& v : cage.vertices()) {
        if (glm::length(v.position - vec3(1, 1, 0)) > 1e-5f) {
            continue;
        }
        ++sides;
        normals += v.normal;
    }
    EXPECT_LE(glm::length(normals - vec3(1)), 1e-4f);
    EXPECT_EQ(sides, 3);
    expect_facing(cage.result());
}

TEST(Subdivision, AHalfSharpCreaseLiesBetween) {
    Mesh mesh = cube_cage(3);
    const float smooth = Cage(mesh).result().bounds.upper.z;
    for (const auto& [a, b] : {std::pair(4u, 5u), {5u, 7u}, {7u, 6u}, {6u, 4u}}) {
        mesh.cage->creases.push_back({a, b, 1.5f});
    }
    Cage half(mesh);
    expect_whole(half.result());
    expect_facing(half.result());
    for (SubdivisionCrease& crease : mesh.cage->creases) {
        crease.sharpness = 10;
    }
    Cage sharp(mesh);
    expect_facing(sharp.result());
    EXPECT_LT(smooth, half.result().bounds.upper.z);
    EXPECT_LT(half.result().bounds.upper.z, sharp.result().bounds.upper.z);
    EXPECT_NEAR(sharp.result().bounds.upper.z, 1, 1e-6);
}

TEST(Subdivision, FollowsMorphsAndSkin) {
    for (Mesh mesh : {grid_cage(9, 2), octahedron_cage(3), cube_cage(4), house_cage(3)}) {
        Random random(22);
        mesh.cage->creases = {{mesh.indices[0], mesh.indices[1], 1.5f},
                              {mesh.indices[1], mesh.indices[2], 10}};
        add_skin(mesh, 5, 3, random);
        mesh.morphs = {target(mesh, std::uint32_t(mesh.vertices.size()) / 2, random)};
        mesh.morph_weights = {0.7f};
        Cage cage(mesh, 5);
        expect_whole(cage.result());
        const auto exact = limit_positions(
            mesh,
            skinned(mesh, mesh.morph_weights, cage.joint_matrices(cage.figure), cage.figure.inverse_binds));
        const dvec3 at = cage.deformed(cage.figure).skinned_at;
        EXPECT_GE(cage.vertices().size(), exact.size());
        for (const VertexFrame& v : cage.vertices()) {
            double nearest = INFINITY;
            for (const dvec3& p : exact) {
                nearest = std::min(nearest, glm::length(dvec3(v.position) + at - p));
            }
            EXPECT_LE(nearest, 1e-5 * mesh.bounds.diagonal());
        }
    }
}

TEST(Subdivision, FacesOfAnyNumberOfCornersFaceOutwards) {
    Cage cage(house_cage(2));
    expect_whole(cage.result());
    expect_facing(cage.result());
    EXPECT_TRUE(cage.deformation.warnings().empty());
    // Each face of n corners is n quads at level 1 and 4 n at level 2.
    EXPECT_EQ(cage.topology().indices.size() / 3, (5u + 9 * 4 + 5 * 3) * 4 * 2);
}

TEST(Subdivision, NormalsAreThoseOfTheFinerSurface) {
    Mesh mesh = cube_cage(2);
    mesh.vertices[0].position = {-3, -1, -2};
    Cage coarse(mesh);
    mesh.cage->level = 5;
    Cage fine(mesh);
    // The fine mesh's flat triangles against the coarse one's normals at the same point of the limit surface.
    std::map<std::array<float, 3>, vec3> flat;
    for (std::size_t i = 0; i < fine.topology().indices.size(); i += 3) {
        const auto at = [&](std::size_t k) {
            return fine.vertices()[fine.topology().indices[i + k]].position;
        };
        const vec3 normal = glm::cross(at(1) - at(0), at(2) - at(0));
        for (std::size_t k = 0; k < 3; ++k) {
            for (const VertexFrame& v : coarse.vertices()) {
                if (glm::length(v.position - at(k)) < 1e-5f) {
                    flat[{v.position.x, v.position.y, v.position.z}] += normal;
                }
            }
        }
    }
    EXPECT_EQ(flat.size(), coarse.vertices().size());
    for (const VertexFrame& v : coarse.vertices()) {
        const vec3 normal = flat[{v.position.x, v.position.y, v.position.z}];
        EXPECT_GT(glm::dot(glm::normalize(normal), v.normal), 0.995f);
    }
}

TEST(Subdivision, AMirroredFigureIsAMirrorImage) {
    Mesh mesh = split_cube_cage(2);
    mesh.skin.assign(mesh.vertices.size(), {{0}, {1}});
    Cage cage(mesh, 1);
    auto place = [&](double x) {
        cage.world.get_mut<WorldTransform>(cage.figure.joints[0]).matrix = dmat4(1);
        cage.world.get_mut<WorldTransform>(cage.figure.joints[0]).matrix[0][0] = x;
        cage.world.get_mut<SkinInstance>(cage.figure.entity).inverse_binds = {mat4(1)};
        cage.update();
    };
    place(1);
    const DeformedMesh straight = cage.result();
    place(-1);
    const DeformedMesh mirrored = cage.result();
    ASSERT_EQ(straight.vertices->size(), mirrored.vertices->size());
    expect_whole(mirrored);
    expect_facing(mirrored);
    const vec3 flip(-1, 1, 1);
    for (std::size_t i = 0; i < straight.vertices->size(); ++i) {
        const VertexFrame &a = (*straight.vertices)[i], &b = (*mirrored.vertices)[i];
        EXPECT_LE(glm::length(a.position * flip - b.position), 1e-6f);
        EXPECT_LE(glm::length(a.normal * flip - b.normal), 1e-5f);
        EXPECT_LE(glm::length(vec3(a.tangent) * flip - vec3(b.tangent)), 1e-5f);
        EXPECT_EQ(a.tangent.w, -b.tangent.w);
    }
}

TEST(Subdivision, ThePoseOfACageIsRedoneOnlyWhenItChanges) {
    Mesh mesh = grid_cage(20, 2);
    Random random(23);
    add_skin(mesh, 4, 4, random);
    Cage cage(mesh, 4);
    const DeformedMesh before = cage.result();
    cage.update();
    EXPECT_EQ(cage.result().version, before.version);
    cage.pose(cage.figure, cage.random);
    cage.update();
    EXPECT_NE(cage.result().version, before.version);
    EXPECT_EQ(cage.result().refined, before.refined);
    for (int i = 0; i < 4; ++i) {
        cage.pose(cage.figure, cage.random);
        cage.update();
    }
    const std::uint64_t count = allocations();
    for (int i = 0; i < 8; ++i) {
        cage.pose(cage.figure, cage.random);
        cage.update();
    }
    EXPECT_EQ(allocations(), count);
}

TEST(Subdivision, ALevelOfTooManyTrianglesIsLowered) {
    Mesh mesh = grid_cage(100, 5);
    const deform::SubdivisionSurface surface(mesh);
    EXPECT_EQ(surface.finest(), 3u);  // 10000 * 2 * 4^4 > 4 million
    EXPECT_NE(surface.remark().find("level 5"), std::string::npos);
}

TEST(Subdivision, ControlPointsThatMoveDifferentlyStayApart) {
    Mesh mesh = split_cube_cage(1);
    EXPECT_EQ(deform::cage_topology(mesh).control_vertices.size(), 8u);
    mesh.morphs = {{{0}, {vec3(0, 0, 1)}, {}, {}}};
    EXPECT_EQ(deform::cage_topology(mesh).control_vertices.size(), 9u);
    mesh.skin.assign(24, {{0}, {1}});
    mesh.skin[5] = {{1}, {1}};
    EXPECT_EQ(deform::cage_topology(mesh).control_vertices.size(), 10u);
}

TEST(Subdivision, IsRefinedAsFinelyAsIsAskedFor) {
    Cage cage(grid_cage(2, 5));  // edges of half a metre
    const auto triangles = [&](const DetailHints& hints) {
        cage.deformation.update(cage.world, &hints);
        return cage.topology().indices.size() / 3;
    };
    DetailHints hints;
    EXPECT_EQ(triangles(hints), 4u * 4 * 2);  // nobody looks: level 1
    hints.eyes = {
        {{0.5, 0.5, 1}, 1000}};  // 500 pixels an edge, 8 wanted: 6 halvings, of which the cage has 5
    EXPECT_EQ(triangles(hints), 4u * 1024 * 2);
    hints.eyes[0].at.z = 10;
    EXPECT_EQ(triangles(hints), 4u * 64 * 2);
    const std::uint64_t version = cage.result().version;
    hints.eyes[0].at.z = 16;  // 1.97 halvings: 2 would do, but with less than a quarter to spare
    EXPECT_EQ(triangles(hints), 4u * 64 * 2);
    EXPECT_EQ(cage.result().version, version);
    hints.eyes[0].at.z = 30;
    EXPECT_EQ(triangles(hints), 4u * 16 * 2);
    hints.eyes.push_back({{0.5, 0.5, 1}, 81.5});  // a map of 128 texels to the right angle
    EXPECT_EQ(triangles(hints), 4u * 64 * 2);     // 41 texels an edge
    hints.eyes = {{{0.5, 0.5, 100}, 81.5}};
    EXPECT_EQ(triangles(hints), 4u * 4 * 2);
    hints.eyes[0].at.z = 0;  // on it
    EXPECT_EQ(triangles(hints), 4u * 1024 * 2);
    hints.eyes.clear();
    hints.samples_per_metre = 60;  // 30 samples an edge wherever it is
    EXPECT_EQ(triangles(hints), 4u * 16 * 2);
    cage.update();
    EXPECT_EQ(cage.topology().indices.size() / 3, 4u * 1024 * 2);
}

// Whoever comes and goes a little, right where one level becomes the next, sees one change and no more.
TEST(Subdivision, ALevelDoesNotFlicker) {
    Cage cage(grid_cage(2, 5));
    DetailHints hints;
    std::uint64_t version = 0;
    int changes = -1;  // the first is none
    for (int frame = 0; frame < 200; ++frame) {
        const double threshold = 500 / 8.0 / 8;  // metres: 3 halvings
        hints.eyes = {{{0.5, 0.5, threshold * (1 + 0.08 * std::sin(0.37 * frame))}, 1000}};
        cage.deformation.update(cage.world, &hints);
        changes += cage.result().version != version;
        version = cage.result().version;
    }
    EXPECT_EQ(changes, 1);
}

}  // namespace
}  // namespace deformation_test

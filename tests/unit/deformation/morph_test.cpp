#include "tests/unit/deformation/rig.h"

namespace deformation_test {
namespace {

Mesh triangle() {
    Mesh mesh;
    mesh.name = "triangle";
    for (const vec3 p : {vec3(0, 0, 0), vec3(1, 0, 0), vec3(0, 1, 0)}) {
        Vertex v;
        v.position = p;
        mesh.vertices.push_back(v);
        mesh.bounds.add(p);
    }
    mesh.indices = {0, 1, 2};
    return mesh;
}

TEST(Morph, AddsWeightedDifferences) {
    Stage stage;
    Random random(1);
    Mesh mesh = triangle();
    mesh.morphs = {{{1}, {vec3(0, 0, 2)}, {vec3(3, 0, 0)}, {}},
                   {{0, 1, 2}, {vec3(1), vec3(2), vec3(3)}, {}, {}}};
    mesh.morph_weights = {0, 0};
    stage.show({mesh});
    const Figure figure = stage.figure(0, 0, random);
    stage.world.add(figure.entity, MorphWeights{{0.5f, -1}});
    stage.update();
    const DeformedMeshes& deformed = stage.deformed(figure);
    EXPECT_FALSE(deformed.skinned);
    const auto& v = *deformed.meshes.at(0).vertices;
    EXPECT_EQ(v[0].position, vec3(-1, -1, -1));
    EXPECT_EQ(v[1].position, vec3(-1, -2, -1));
    EXPECT_EQ(v[2].position, vec3(-3, -2, -3));
    EXPECT_EQ(v[0].normal, vec3(0, 0, 1));
    EXPECT_LE(glm::length(v[1].normal - glm::normalize(vec3(1.5f, 0, 1))), 1e-6f);
    EXPECT_EQ(deformed.meshes[0].bounds, (Aabb{vec3(-3, -2, -3), vec3(-1, -1, -1)}));
}

TEST(Morph, TheMeshsWeightsHoldUnlessTheEntityHasItsOwn) {
    Stage stage;
    Random random(2);
    Mesh mesh = triangle();
    mesh.morphs = {{{0}, {vec3(1, 0, 0)}, {}, {}}};
    mesh.morph_weights = {2};
    stage.show({mesh});
    const Figure figure = stage.figure(0, 0, random);
    stage.update();
    EXPECT_EQ(stage.deformed(figure).meshes.at(0).vertices->at(0).position, vec3(2, 0, 0));
    stage.world.add(figure.entity, MorphWeights{{}});
    stage.update();
    EXPECT_EQ(stage.deformed(figure).meshes.at(0).vertices->at(0).position, vec3(0, 0, 0));
}

TEST(Morph, ANormalThatVanishesIsTheMeshsOwn) {
    Stage stage;
    Random random(3);
    Mesh mesh = triangle();
    mesh.morphs = {{{0}, {vec3(0)}, {vec3(0, 0, -1)}, {vec3(-1, 0, 0)}}};
    mesh.morph_weights = {1};
    stage.show({mesh});
    const Figure figure = stage.figure(0, 0, random);
    stage.update();
    expect_sound(stage.deformed(figure).meshes.at(0));
    EXPECT_EQ(stage.deformed(figure).meshes[0].vertices->at(0).normal, vec3(0, 0, 1));
}

TEST(Morph, SparseAndDenseTargetsAgreeWithTheSpecification) {
    Random random(4);
    Stage stage;
    Mesh mesh = cloud(3001, random);
    for (const std::uint32_t moved : {3000u, 40u, 1u, 1400u, 2000u}) {
        mesh.morphs.push_back(target(mesh, moved, random));
    }
    mesh.morphs[3].normals.clear();
    mesh.morphs[4].tangents.clear();
    stage.show({mesh});
    const Figure figure = stage.figure(0, 0, random);
    const std::vector<float> weights{0.7f, 1, -0.5f, 0.2f, 1.3f};
    stage.world.add(figure.entity, MorphWeights{weights});
    stage.update();
    expect_near(stage.deformed(figure).meshes.at(0), morphed(mesh, weights), dvec3(0),
                mesh.bounds.diagonal());
}

TEST(Morph, VerticesThatNoActiveTargetListsStayBitForBit) {
    Random random(5);
    Stage stage;
    Mesh mesh = cloud(1000, random);
    mesh.morphs = {target(mesh, 10, random), target(mesh, 900, random)};
    stage.show({mesh});
    const Figure figure = stage.figure(0, 0, random);
    stage.world.add(figure.entity, MorphWeights{{1, 0}});
    stage.update();
    const auto& vertices = *stage.deformed(figure).meshes.at(0).vertices;
    const auto& listed = mesh.morphs[0].vertices;
    for (std::uint32_t i = 0; i < vertices.size(); ++i) {
        if (std::find(listed.begin(), listed.end(), i) != listed.end()) {
            continue;
        }
        EXPECT_EQ(vertices[i].position, mesh.vertices[i].position);
        EXPECT_LE(glm::length(vertices[i].normal - mesh.vertices[i].normal), 2e-7f);
    }
}

TEST(Morph, ComesBeforeSkinning) {
    Random random(6);
    Stage stage;
    Mesh mesh = cloud(1200, random);
    add_skin(mesh, 10, 4, random);
    mesh.morphs = {target(mesh, 100, random), target(mesh, 1100, random)};
    mesh.morph_weights = {0.8f, -0.6f};
    stage.show({mesh});
    const Figure figure = stage.figure(0, 10, random);
    stage.update();
    const DeformedMeshes& deformed = stage.deformed(figure);
    expect_near(deformed.meshes.at(0),
                skinned(mesh, mesh.morph_weights, stage.joint_matrices(figure), figure.inverse_binds),
                deformed.skinned_at, mesh.bounds.diagonal());
}

}  // namespace
}  // namespace deformation_test

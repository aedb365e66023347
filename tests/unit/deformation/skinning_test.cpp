#include "tests/unit/deformation/rig.h"

namespace deformation_test {
namespace {

// Two vertices on a bar along x, each on its own joint, and one between them.
Mesh bar() {
    Mesh mesh;
    mesh.name = "bar";
    for (const float x : {0.0f, 1.0f, 2.0f}) {
        Vertex v;
        v.position = {x, 0, 0};
        v.normal = {0, 1, 0};
        v.tangent = {1, 0, 0, 1};
        mesh.vertices.push_back(v);
        mesh.bounds.add(v.position);
    }
    mesh.indices = {0, 1, 2};
    mesh.skin.resize(3);
    mesh.skin[0] = {{0}, {1}};
    mesh.skin[1] = {{0, 1}, {0.5f, 0.5f}};
    mesh.skin[2] = {{1}, {1}};
    return mesh;
}

struct Bar : Stage {
    Figure figure;

    Bar() {
        show({bar()});
        Random random(1);
        figure = Stage::figure(0, 2, random);
        SkinInstance& skin = world.get_mut<SkinInstance>(figure.entity);
        // The first joint is bound at the origin, the second at (1, 0, 0).
        skin.inverse_binds = {mat4(1),
                              mat4(vec4(1, 0, 0, 0), vec4(0, 1, 0, 0), vec4(0, 0, 1, 0), vec4(-1, 0, 0, 1))};
        set(0, {});
        Transform bound;
        bound.translation = {1, 0, 0};
        set(1, bound);
    }
    void set(std::size_t joint, const Transform& t) {
        world.get_mut<WorldTransform>(figure.joints[joint]).matrix = t.matrix();
    }
    VertexFrame vertex(std::size_t i) { return deformed(figure).meshes.at(0).vertices->at(i); }
};

void expect_vec(const vec3& a, const vec3& b) {
    EXPECT_LE(glm::length(a - b), 1e-6f) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(Skinning, TheBindPoseIsItself) {
    Bar bar;
    bar.update();
    EXPECT_TRUE(bar.deformed(bar.figure).skinned);
    for (std::size_t i = 0; i < 3; ++i) {
        expect_vec(bar.vertex(i).position, {float(i), 0, 0});
        expect_vec(bar.vertex(i).normal, {0, 1, 0});
    }
}

TEST(Skinning, AJointCarriesItsVerticesAndHalfOfThoseItShares) {
    Bar bar;
    Transform bent;  // a quarter turn about z at (1, 0, 0): (2, 0, 0) goes to (1, 1, 0)
    bent.translation = {1, 0, 0};
    bent.rotation = glm::angleAxis(kPi / 2, vec3(0, 0, 1));
    bar.set(1, bent);
    bar.update();
    expect_vec(bar.vertex(0).position, {0, 0, 0});
    expect_vec(bar.vertex(1).position, {1, 0, 0});
    expect_vec(bar.vertex(2).position, {1, 1, 0});
    expect_vec(bar.vertex(2).normal, {-1, 0, 0});
    expect_vec(vec3(bar.vertex(2).tangent), {0, 1, 0});
    // The middle's normal is by half of each joint's turn: by 45 degrees.
    expect_vec(bar.vertex(1).normal, glm::normalize(vec3(-1, 1, 0)));
}

TEST(Skinning, NormalsGoByTheInverseTranspose) {
    Bar bar;
    Mesh mesh = ::deformation_test::bar();
    for (Vertex& v : mesh.vertices) {
        v.normal = glm::normalize(vec3(1, 1, 0));
    }
    bar.show({mesh});
    Transform wide;
    wide.scale = {4, 1, 1};
    bar.set(0, wide);
    bar.update();
    expect_vec(bar.vertex(0).normal, glm::normalize(vec3(0.25f, 1, 0)));
}

TEST(Skinning, AMirrorTurnsTrianglesAndBitangentsButNoNormal) {
    Bar bar;
    Transform mirror, second;
    mirror.scale = {-1, 1, 1};
    second.scale = {-1, 1, 1};
    second.translation = {-1, 0, 0};
    bar.set(0, mirror);
    bar.set(1, second);
    bar.update();
    expect_vec(bar.vertex(2).position, {-2, 0, 0});
    expect_vec(bar.vertex(2).normal, {0, 1, 0});
    EXPECT_EQ(bar.vertex(2).tangent, vec4(-1, 0, 0, -1));
    const DeformedMesh& mesh = bar.deformed(bar.figure).meshes[0];
    ASSERT_TRUE(mesh.refined);
    EXPECT_EQ(mesh.refined->indices, (std::vector<std::uint32_t>{0, 2, 1}));
    EXPECT_EQ(mesh.refined->uv0.size(), 3u);
    EXPECT_NE(mesh.refined->serial, 0u);
}

TEST(Skinning, AFlattenedFigureKeepsSoundFrames) {
    Bar bar;
    for (const vec3 scale : {vec3(0), vec3(0, 1, 1), vec3(1, 0, 1), vec3(1e-20f), vec3(1e-12f, 1, 1e-12f)}) {
        Transform flat;
        flat.scale = scale;
        bar.set(0, flat);
        bar.set(1, flat);
        bar.update();
        expect_sound(bar.deformed(bar.figure).meshes[0]);
    }
    // Tiny as it was last, its directions are as those of one a million million times its size.
    Transform tiny;
    tiny.scale = vec3(1e-12f);
    tiny.rotation = glm::angleAxis(kPi / 2, vec3(0, 0, 1));
    bar.set(0, tiny);
    bar.set(1, tiny);
    bar.update();
    expect_vec(bar.vertex(0).normal, {-1, 0, 0});
    expect_vec(vec3(bar.vertex(0).tangent), {0, 1, 0});
}

TEST(Skinning, WithoutInverseBindsTheJointsMatricesStandAlone) {
    Bar bar;
    bar.world.get_mut<SkinInstance>(bar.figure.entity).inverse_binds.clear();
    bar.update();
    expect_vec(bar.vertex(2).position, {3, 0, 0});
}

TEST(Skinning, AVertexWithoutWeightFollowsItsFirstJoint) {
    Bar bar;
    Mesh mesh = ::deformation_test::bar();
    mesh.skin[2] = {{1}, {0}};
    mesh.skin[0] = {{0}, {std::nanf("")}};
    bar.show({mesh});
    bar.update();
    expect_vec(bar.vertex(0).position, {0, 0, 0});
    expect_vec(bar.vertex(2).position, {2, 0, 0});
}

class Influences : public testing::TestWithParam<std::uint32_t> {};

TEST_P(Influences, AgreeWithTheSpecificationInDoublePrecision) {
    Random random(GetParam());
    Stage stage;
    Mesh mesh = cloud(1000 + GetParam(), random);  // not a multiple of four
    add_skin(mesh, 20, GetParam(), random);
    stage.show({mesh});
    const Figure figure = stage.figure(0, 20, random);
    stage.update();
    const DeformedMeshes& deformed = stage.deformed(figure);
    EXPECT_EQ(deformed.skinned_at, dvec3(stage.joint_matrices(figure)[0][3]));
    expect_near(deformed.meshes.at(0), skinned(mesh, {}, stage.joint_matrices(figure), figure.inverse_binds),
                deformed.skinned_at, mesh.bounds.diagonal());
}

INSTANTIATE_TEST_SUITE_P(OneToEight, Influences, testing::Values(1, 2, 3, 4, 5, 8));

TEST(Skinning, VerticesOfDifferentInfluencesMix) {
    Random random(7);
    Stage stage;
    Mesh mesh = cloud(999, random);
    mesh.skin.resize(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.skin.size(); ++i) {
        Mesh one;
        one.vertices.resize(1);
        add_skin(one, 9, 1 + random.below(8), random);
        mesh.skin[i] = one.skin[0];
    }
    stage.show({mesh});
    const Figure figure = stage.figure(0, 9, random);
    stage.update();
    const DeformedMeshes& deformed = stage.deformed(figure);
    expect_near(deformed.meshes.at(0), skinned(mesh, {}, stage.joint_matrices(figure), figure.inverse_binds),
                deformed.skinned_at, mesh.bounds.diagonal());
}

TEST(Skinning, MirroredAndUnevenlyScaledParentsAgreeWithTheSpecification) {
    Random random(8);
    Stage stage;
    Mesh mesh = cloud(500, random);
    add_skin(mesh, 6, 1, random);
    stage.show({mesh});
    const Figure figure = stage.figure(0, 6, random);
    for (const ecs::Entity joint : figure.joints) {
        Transform parent;
        parent.translation = dvec3(random.vector(1));
        parent.rotation = random.rotation();
        parent.scale = {-2, 0.5f, 3};
        dmat4& matrix = stage.world.get_mut<WorldTransform>(joint).matrix;
        matrix = parent.matrix() * matrix;  // a shear, too
    }
    stage.update();
    const DeformedMeshes& deformed = stage.deformed(figure);
    EXPECT_TRUE(deformed.meshes.at(0).refined);
    expect_near(deformed.meshes.at(0), skinned(mesh, {}, stage.joint_matrices(figure), figure.inverse_binds),
                deformed.skinned_at, mesh.bounds.diagonal());
}

TEST(Skinning, HoldsFarFromTheOrigin) {
    Random random(9);
    Stage stage;
    Mesh mesh = cloud(1000, random);
    add_skin(mesh, 12, 4, random);
    stage.show({mesh});
    const dvec3 far(100e3, -70e3, 100e3);
    const Figure figure = stage.figure(0, 12, random, far);
    stage.update();
    const DeformedMeshes& deformed = stage.deformed(figure);
    expect_near(deformed.meshes.at(0), skinned(mesh, {}, stage.joint_matrices(figure), figure.inverse_binds),
                deformed.skinned_at, mesh.bounds.diagonal());
}

TEST(Skinning, AMeshWithoutInfluencesMovesWithItsEntity) {
    Random random(10);
    Stage stage;
    Mesh skinned_mesh = cloud(40, random), hat = cloud(33, random);
    add_skin(skinned_mesh, 3, 2, random);
    hat.morphs = {target(hat, 20, random)};
    hat.morph_weights = {0.5f};
    stage.show({skinned_mesh, hat});
    const Figure figure = stage.figure(0, 3, random);
    stage.world.insert(figure.entity, MeshInstances{stage.shown});
    Transform place;
    place.translation = {3, 4, 5};
    place.rotation = random.rotation();
    place.scale = {1, 2, 1};
    stage.world.get_mut<WorldTransform>(figure.entity).matrix = place.matrix();
    stage.update();
    const DeformedMeshes& deformed = stage.deformed(figure);
    hat.skin.assign(hat.vertices.size(), {{0}, {1}});
    expect_near(deformed.meshes.at(1), skinned(hat, hat.morph_weights, {place.matrix()}, {mat4(1)}),
                deformed.skinned_at, hat.bounds.diagonal());
}

}  // namespace
}  // namespace deformation_test

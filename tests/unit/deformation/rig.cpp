#include "tests/unit/deformation/rig.h"

namespace deformation_test {

vec3 Random::direction() {
    for (;;) {
        const vec3 v = vector(1);
        if (glm::length(v) > 0.1f && glm::length(v) < 1) {
            return glm::normalize(v);
        }
    }
}

quat Random::rotation() {
    return glm::angleAxis(between(-3, 3), direction());
}

Mesh cloud(std::uint32_t vertices, Random& random) {
    Mesh mesh;
    mesh.name = "cloud";
    for (std::uint32_t i = 0; i < vertices; ++i) {
        Vertex v;
        v.position = random.vector(0.5f);
        v.normal = random.direction();
        v.tangent = vec4(random.direction(), random.below(2) ? 1 : -1);
        v.uv0 = vec2(random.between(0, 1), random.between(0, 1));
        mesh.vertices.push_back(v);
        mesh.bounds.add(v.position);
        for (std::uint32_t k = 0; k < 3; ++k) {
            mesh.indices.push_back((i + k) % vertices);
        }
    }
    return mesh;
}

void add_skin(Mesh& mesh, std::uint32_t joints, std::uint32_t influences, Random& random) {
    mesh.skin.resize(mesh.vertices.size());
    for (SkinInfluences& by : mesh.skin) {
        float sum = 0;
        for (std::uint32_t k = 0; k < influences; ++k) {
            by.joints[k] = std::uint16_t(random.below(joints));
            by.weights[k] = random.between(0.05f, 1);
            sum += by.weights[k];
        }
        for (float& w : by.weights) {
            w /= sum;
        }
    }
}

MorphTarget target(const Mesh& mesh, std::uint32_t moved, Random& random) {
    MorphTarget result;
    const auto count = std::uint32_t(mesh.vertices.size());
    const std::uint32_t step = count / moved;
    for (std::uint32_t i = 0; i < moved; ++i) {
        result.vertices.push_back(i * step + random.below(step));
        result.positions.push_back(random.vector(0.2f));
        result.normals.push_back(random.vector(0.3f));
        result.tangents.push_back(random.vector(0.3f));
    }
    return result;
}

void Stage::show(const std::vector<Mesh>& meshes) {
    AssetStore& store = asset_store(world);
    if (shown.empty()) {
        store.add(Material());
    }
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        if (i < shown.size()) {
            store.edit_mesh(shown[i], [&](Mesh& mesh) { mesh = meshes[i]; });
        } else {
            shown.push_back(store.add(meshes[i]));
        }
    }
}

Figure Stage::figure(std::uint32_t mesh, std::uint32_t joints, Random& random, const dvec3& at) {
    Figure figure;
    for (std::uint32_t j = 0; j < joints; ++j) {
        figure.joints.push_back(world.create(WorldTransform{}));
        Transform bind;
        bind.translation = dvec3(random.vector(0.5f));
        bind.rotation = random.rotation();
        figure.inverse_binds.push_back(mat4(glm::inverse(bind.matrix())));
    }
    figure.entity = world.create(MeshInstances{{shown.at(mesh)}}, WorldTransform{});
    if (joints > 0) {
        world.add(figure.entity, SkinInstance{figure.joints, figure.inverse_binds});
    }
    pose(figure, random, at);
    return figure;
}

void Stage::pose(const Figure& figure, Random& random, const dvec3& at) {
    for (const ecs::Entity joint : figure.joints) {
        Transform pose;
        pose.translation = at + dvec3(random.vector(0.5f));
        pose.rotation = random.rotation();
        pose.scale = vec3(random.between(0.6f, 1.6f), random.between(0.6f, 1.6f), random.between(0.6f, 1.6f));
        world.get_mut<WorldTransform>(joint).matrix = pose.matrix();
    }
}

std::vector<dmat4> Stage::joint_matrices(const Figure& figure) {
    std::vector<dmat4> matrices;
    for (const ecs::Entity joint : figure.joints) {
        matrices.push_back(world.get<WorldTransform>(joint).matrix);
    }
    return matrices;
}

void expect_near(const DeformedMesh& mesh, const std::vector<ExactVertex>& exact, const dvec3& at,
                 double size) {
    ASSERT_TRUE(mesh.vertices);
    ASSERT_EQ(mesh.vertices->size(), exact.size());
    double position = 0, normal = 0, tangent = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const VertexFrame& v = (*mesh.vertices)[i];
        position = std::max(position, glm::length(dvec3(v.position) + at - exact[i].position));
        normal = std::max(normal, glm::length(dvec3(v.normal) - exact[i].normal));
        tangent = std::max(tangent, glm::length(dvec3(vec3(v.tangent)) - exact[i].tangent));
        EXPECT_EQ(v.tangent.w, float(exact[i].sign)) << "vertex " << i;
    }
    EXPECT_LE(position, 1e-5 * size);
    EXPECT_LE(normal, 1e-3);
    EXPECT_LE(tangent, 1e-3);
    expect_sound(mesh);
}

void expect_sound(const DeformedMesh& mesh) {
    ASSERT_TRUE(mesh.vertices);
    Aabb bounds;
    for (const VertexFrame& v : *mesh.vertices) {
        bounds.add(v.position);
        ASSERT_TRUE(glm::all(glm::lessThan(glm::abs(v.position), vec3(1e30f))));  // false for a NaN
        ASSERT_NEAR(glm::length(v.normal), 1, 1e-5);
        ASSERT_NEAR(glm::length(vec3(v.tangent)), 1, 1e-5);
        ASSERT_EQ(std::abs(v.tangent.w), 1);
    }
    EXPECT_EQ(mesh.bounds, bounds);
    EXPECT_NE(mesh.version, 0u);
}

}  // namespace deformation_test

// Coarser shapes: fewer triangles, no farther off than they say, and drawn where a map cannot tell.
#include "engine/render/coarse_shapes.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "tests/gpu/render/scenes.h"
#include "tests/support/shapes.h"

namespace lanthorn {
namespace {

constexpr float kRadius = 0.5f;

std::size_t drawn_triangles(render::FrameRenderer& renderer, const FrameScene& scene) {
    GLuint query = 0;
    glGenQueries(1, &query);
    gpu::PassTimer timer(false, true);
    renderer.begin(scene, ivec2(16), timer);
    glBeginQuery(GL_PRIMITIVES_GENERATED, query);
    renderer.draw_light_maps(scene, timer);
    glEndQuery(GL_PRIMITIVES_GENERATED);
    GLuint count = 0;
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
    glDeleteQueries(1, &query);
    return count;
}

TEST(CoarseShapes, HaveFewerTrianglesAndKeepWithinTheirError) {
    const Mesh ball = support::sphere(vec3(0), kRadius, 5, false, 0);
    const std::vector<render::CoarseLevel> levels = render::coarser_levels(InstanceShape(ball), false);
    ASSERT_GE(levels.size(), 4u);
    std::size_t before = ball.indices.size();
    float error = 0;
    for (const render::CoarseLevel& level : levels) {
        EXPECT_LT(level.indices.size(), before * 3 / 4);
        EXPECT_GT(level.error, error);
        before = level.indices.size();
        error = level.error;
        float off = 0;
        for (std::size_t i = 0; i < level.indices.size(); i += 3) {
            vec3 middle(0);
            for (std::size_t k = i; k < i + 3; ++k) {
                middle += ball.vertices[level.indices[k]].position / 3.0f;
            }
            off = std::max(off, kRadius - glm::length(middle));
        }
        // The error is a mean over what a vertex stands for; the middle of a triangle is farthest off.
        EXPECT_LT(off, 3 * level.error * ball.bounds.diagonal()) << level.indices.size() / 3;
    }
    EXPECT_LT(before, ball.indices.size() / 20);
}

TEST(CoarseShapes, SmallShapesHaveNone) {
    const Mesh block = support::box(vec3(0), vec3(1), false, 0);
    EXPECT_TRUE(render::coarser_levels(InstanceShape(block), false).empty());
}

// Edges of normals alone hold nothing: a ball of facets, each with corners of its own.
TEST(CoarseShapes, FacetsAreOneSurface) {
    const Mesh ball = support::sphere(vec3(0), kRadius, 4, false, 0);
    Mesh facets;
    for (const std::uint32_t i : ball.indices) {
        facets.indices.push_back(static_cast<std::uint32_t>(facets.vertices.size()));
        facets.vertices.push_back(ball.vertices[i]);
    }
    const auto levels = render::coarser_levels(InstanceShape(facets), false);
    ASSERT_FALSE(levels.empty());
    EXPECT_LT(levels.back().indices.size(), facets.indices.size() / 10);
}

// A limb that is straight in its bind pose: along it nothing is lost by longer triangles, until it bends.
TEST(CoarseShapes, LimbsKeepTheirJoints) {
    constexpr float kThick = 0.05f;
    constexpr int kAround = 24, kAlong = 40;
    Mesh limb;
    for (int j = 0; j <= kAlong; ++j) {
        for (int i = 0; i < kAround; ++i) {
            const float a = 2 * kPi * static_cast<float>(i) / kAround;
            const float y = static_cast<float>(j) / kAlong;
            Vertex vertex;
            vertex.position = vec3(kThick * std::cos(a), y, kThick * std::sin(a));
            limb.vertices.push_back(vertex);
            SkinInfluences influences;
            influences.joints = {0, 1};
            const float lower = glm::clamp((y - 0.45f) / 0.1f, 0.0f, 1.0f);
            influences.weights = {1 - lower, lower};
            limb.skin.push_back(influences);
        }
    }
    for (std::uint32_t j = 0; j < kAlong; ++j) {
        for (std::uint32_t i = 0; i < kAround; ++i) {
            const std::uint32_t a = j * kAround + i, b = j * kAround + (i + 1) % kAround;
            limb.indices.insert(limb.indices.end(), {a, a + kAround, b, b, a + kAround, b + kAround});
        }
    }
    const mat4 bent = glm::translate(mat4(1), vec3(0, 0.5f, 0)) *
                      glm::rotate(mat4(1), glm::radians(80.0f), vec3(0, 0, 1)) *
                      glm::translate(mat4(1), vec3(0, -0.5f, 0));
    const auto posed = [&](std::uint32_t v) {
        const vec3 p = limb.vertices[v].position;
        return glm::mix(p, vec3(bent * vec4(p, 1)), limb.skin[v].weights[1]);
    };
    const vec3 along = vec3(bent * vec4(0, 1, 0, 0));
    const auto off_the_axis = [&](const vec3& p) {  // of the bent limb
        const vec3 upper(p.x, p.y - glm::clamp(p.y, 0.0f, 0.5f), p.z);
        const vec3 q = p - vec3(0, 0.5f, 0);
        return std::min(glm::length(upper),
                        glm::length(q - along * glm::clamp(glm::dot(q, along), 0.0f, 0.5f)));
    };
    const std::vector<render::CoarseLevel> levels = render::coarser_levels(InstanceShape(limb), false);
    ASSERT_GE(levels.size(), 3u);
    EXPECT_LT(levels[2].indices.size(), limb.indices.size() / 4);
    for (const render::CoarseLevel& level : levels) {
        if (level.error * glm::length(vec3(0.1f, 1, 0.1f)) > 0.5f * kThick) {
            continue;
        }
        for (std::size_t i = 0; i < level.indices.size(); i += 3) {
            vec3 middle(0);
            for (std::size_t k = i; k < i + 3; ++k) {
                middle += posed(level.indices[k]) / 3.0f;
            }
            EXPECT_LT(off_the_axis(middle), 1.5f * kThick) << level.indices.size() / 3;
        }
    }
}

// What moves has levels, by where it stands: all triangles near the light, few far from it, none where its
// whole box is lost in a texel.
TEST(CoarseShapes, AreChosenByTexels) {
    testing::context();
    render::GpuScene gpu_scene;
    testing::SceneBuilder b;
    const std::uint32_t white = b.add_lambert(vec3(0.7f));
    b.add_sphere(white, vec3(0), kRadius);
    FrameScene scene = b.build();
    gpu_scene.update(scene);
    const auto level_at = [&](float distance) {
        return gpu_scene.level(0, {vec3(distance + kRadius, 0, 0), 1.0f / 64, 0});
    };
    EXPECT_EQ(level_at(100), 0u) << "it has never moved";
    ++scene.frame;
    scene.changes = {};
    scene.changes.moved = {0};
    gpu_scene.update(scene);
    EXPECT_EQ(level_at(0.01f), 0u);
    EXPECT_GT(level_at(4), level_at(0.5f));
    EXPECT_LT(level_at(4), 20u);
    EXPECT_EQ(level_at(1000), render::GpuScene::kTooSmall);
    gpu_scene.use_levels(false);
    EXPECT_EQ(level_at(4), 0u);
}

// In the picture only what deforms, and no triangle of it may grow wider than two pixels: a flat shape has
// long ones early.
TEST(CoarseShapes, InThePictureAreNoWiderThanAPixelOrTwo) {
    testing::context();
    render::GpuScene gpu_scene;
    testing::SceneBuilder b;
    const std::uint32_t white = b.add_lambert(vec3(0.7f));
    b.add_sphere(white, vec3(0), kRadius);
    FrameScene scene = b.build();
    ++scene.frame;
    scene.changes = {};
    scene.changes.moved = {0};
    const auto levels_at = [&](float distance) {
        return gpu_scene.picture_level(0, {vec3(distance + kRadius, 0, 0), 1.0f / 64, 0});
    };
    gpu_scene.update(scene);
    ++scene.frame;
    gpu_scene.update(scene);
    EXPECT_EQ(levels_at(20), 0u) << "it is rigid";
    auto vertices = std::make_shared<std::vector<VertexFrame>>();
    for (const Vertex& v : scene.assets->meshes[0].vertices) {
        vertices->push_back({v.position, v.normal, v.tangent});
    }
    scene.deformed.push_back({1, vertices, nullptr, scene.assets->meshes[0].bounds});
    scene.instances[0].deformed = 0;
    scene.instances[0].version = 1;
    ++scene.frame;
    gpu_scene.update(scene);
    EXPECT_EQ(levels_at(0.5f), 0u);
    const std::uint32_t far = levels_at(20);
    EXPECT_GT(far, 0u);
    EXPECT_GT(levels_at(60), far);
    const render::TexelSize pixel{vec3(20 + kRadius, 0, 0), 1.0f / 64, 0};
    EXPECT_LT(far, gpu_scene.level(0, pixel)) << "maps are content with less";
    const auto levels = render::coarser_levels(InstanceShape(scene.assets->meshes[0]), false);
    EXPECT_LE(levels[far - 1].edge * scene.assets->meshes[0].bounds.diagonal(), 2 * 20.0f / 64);
    gpu_scene.use_levels(false);
    EXPECT_EQ(levels_at(20), 0u);
}

// A light's map draws a mover's coarser triangles, unless adaptive detail is off.
TEST(CoarseShapes, LightMapsDrawFewTrianglesOfMovers) {
    testing::context();
    std::size_t triangles[2];
    for (const bool adaptive : {false, true}) {
        testing::SceneBuilder b = testing::small_room(4, false);
        b.add_sphere(1, vec3(0), 0.2f);
        FrameScene scene = b.build();
        const auto last = static_cast<std::uint32_t>(scene.instances.size() - 1);
        render::FrameRenderer renderer;
        renderer.settings.shadow_resolution = 64;
        renderer.settings.adaptive_detail = adaptive;
        drawn_triangles(renderer, scene);
        ++scene.frame;
        scene.changes = {};
        scene.changes.assets = scene.changes.lights = scene.changes.camera = false;
        scene.changes.moved = {last};
        Instance& ball = scene.instances[last];
        ball.transform = glm::translate(mat4(1), vec3(0.3f, 0, 0)) * ball.transform;
        ball.bounds = transformed(scene.mesh(ball).bounds, ball.transform);
        triangles[adaptive] = drawn_triangles(renderer, scene);
    }
    EXPECT_GT(triangles[0], 0u);
    EXPECT_LT(triangles[1], triangles[0] / 4);
}

}  // namespace
}  // namespace lanthorn

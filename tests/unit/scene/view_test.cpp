#include "lanthorn/scene/view.h"

#include <gtest/gtest.h>

#include <limits>

#include "lanthorn/scene/scene_data.h"

namespace lanthorn {
namespace {

// Window coordinates in -1..1 and depth of a point seen by a view.
vec3 project(const CameraView& view, float aspect, const vec3& p) {
    const vec4 clip = projection_matrix(view.camera, aspect, 1) * (view.view * vec4(p, 1));
    return vec3(clip) / clip.w;
}

TEST(Projection, PerspectiveFiniteAndInfinite) {
    Camera camera;
    camera.y_fov = kPi / 2;
    camera.z_near = 0.5f;
    for (const float z_far : {0.0f, 10.0f}) {
        camera.z_far = z_far;
        const mat4 p = projection_matrix(camera, 2, 1);
        const vec4 near_corner = p * vec4(1, 0.5f, -0.5f, 1);
        EXPECT_NEAR(near_corner.x / near_corner.w, 1, 1e-6);
        EXPECT_NEAR(near_corner.y / near_corner.w, 1, 1e-6);
        EXPECT_NEAR(near_corner.z / near_corner.w, -1, 1e-6);
        const vec4 far_point = p * vec4(0, 0, z_far > 0 ? -z_far : -1e7f, 1);
        EXPECT_NEAR(far_point.z / far_point.w, 1, 1e-6);
    }
}

TEST(Projection, OrthographicShowsTheDeclaredAreaInAnyShape) {
    Camera camera;
    camera.orthographic = true;
    camera.x_mag = 2;
    camera.y_mag = 1;
    camera.z_near = 1;
    camera.z_far = 9;
    const mat4 exact = projection_matrix(camera, 2, 1);
    EXPECT_EQ(vec3(exact * vec4(2, 1, -1, 1)), vec3(1, 1, -1));
    EXPECT_EQ(vec3(exact * vec4(-2, -1, -9, 1)), vec3(-1, -1, 1));
    const mat4 wide = projection_matrix(camera, 4, 1), high = projection_matrix(camera, 1, 1);
    EXPECT_EQ(vec3(wide * vec4(2, 1, -1, 1)), vec3(0.5f, 1, -1));
    EXPECT_EQ(vec3(high * vec4(2, 1, -1, 1)), vec3(1, 0.5f, -1));
    camera.z_far = 0;
    const vec4 beyond = projection_matrix(camera, 2, 50) * vec4(0, 0, -1000, 1);
    EXPECT_LT(beyond.z, 1);
}

TEST(View, IsTheRigidInverseOfTheNode) {
    Transform t;
    t.translation = {1e6 + 3, 4, 5};
    t.rotation = glm::normalize(quat(0.3f, 0.1f, -0.5f, 0.7f));
    t.scale = {3, 0.1f, 7};
    const CameraView view = camera_view({}, t.matrix(), {1e6, 0, 0});
    EXPECT_EQ(view.position, vec3(3, 4, 5));
    const vec3 ahead = vec3(3, 4, 5) + t.rotation * vec3(0, 0, -2);
    EXPECT_NEAR(glm::distance(vec3(view.view * vec4(ahead, 1)), vec3(0, 0, -2)), 0, 1e-5);
    EXPECT_NEAR(glm::determinant(mat3(view.view)), 1, 1e-5);
    const mat3 r(view.view);
    EXPECT_NEAR(glm::length((r * glm::transpose(r))[0] - vec3(1, 0, 0)), 0, 1e-6);
}

TEST(View, DegenerateNodesStillGiveARotation) {
    for (const vec3 scale :
         {vec3(0), vec3(1, 1, 0), vec3(0, 0, 1), vec3(0, 1, 1), vec3(1e-30f), vec3(1e30f), vec3(-1)}) {
        Transform t;
        t.scale = scale;
        const CameraView view = camera_view({}, t.matrix(), dvec3(0));
        EXPECT_NEAR(glm::determinant(mat3(view.view)), 1, 1e-5) << scale.x << scale.y << scale.z;
    }
    dmat4 nan(std::numeric_limits<double>::quiet_NaN());
    nan[3] = dvec4(0, 0, 0, 1);
    EXPECT_EQ(camera_view({}, nan, dvec3(0)).view, mat4(1));
}

TEST(FrameAll, ShowsTheWholeBox) {
    for (const Aabb& box : {Aabb{vec3(-1, -2, -3), vec3(4, 5, 6)},
                            Aabb{vec3(100, 0, 0), vec3(100.001f, 5, 0)}, Aabb{vec3(-5e4f), vec3(5e4f)}}) {
        const CameraView view = frame_all(box);
        EXPECT_GT(view.position.z, box.upper.z);
        EXPECT_GT(view.position.y, box.centre().y);
        EXPECT_NEAR(glm::length(vec2(project(view, 1, box.centre()))), 0, 1e-4);
        for (int i = 0; i < 8; ++i) {
            const vec3 corner(i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y,
                              i & 4 ? box.upper.z : box.lower.z);
            const vec3 p = project(view, 1, corner);
            EXPECT_LE(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}), 1);
        }
    }
}

TEST(FrameAll, FillsThePicture) {
    for (const vec3& size : {vec3(1), vec3(4, 1, 1), vec3(0.5f, 3, 0.5f), vec3(2, 0.1f, 2)}) {
        const Aabb box{vec3(7), vec3(7) + size};
        const CameraView view = frame_all(box);
        float widest = 0;
        for (int i = 0; i < 8; ++i) {
            const vec3 p = project(view, 1,
                                   vec3(i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y,
                                        i & 4 ? box.upper.z : box.lower.z));
            widest = std::max({widest, std::abs(p.x), std::abs(p.y)});
        }
        EXPECT_GT(widest, 0.9f);
    }
}

// A chair of a metre: on a floor of four metres it fills the picture as without one.
TEST(FrameAll, LooksAtWhatStandsOnAFloor) {
    const Aabb chair{vec3(-0.25f, 0, -0.25f), vec3(0.25f, 1, 0.25f)};
    const auto scene_of = [](const std::vector<Aabb>& boxes) {
        FrameScene scene;
        for (const Aabb& box : boxes) {
            scene.instances.emplace_back().bounds = box;
            scene.bounds.add(box);
        }
        return scene;
    };
    const Aabb floor{vec3(-2, -0.05f, -2), vec3(2, 0, 2)};
    EXPECT_EQ(frame_all(scene_of({chair, floor})), frame_all(chair));
    const Aabb ceiling{vec3(-2, 2.5f, -2), vec3(2, 2.6f, 2)};
    const Aabb table{vec3(-1.9f, 0, -1.9f), vec3(1.9f, 0.8f, 1.9f)};
    for (const std::vector<Aabb>& boxes : {std::vector{chair, floor, ceiling}, {table, floor}, {floor}}) {
        EXPECT_EQ(frame_all(scene_of(boxes)), frame_all(scene_of(boxes).bounds));
    }
}

TEST(FrameAll, HandlesEmptyAndDegenerateBounds) {
    const float inf = std::numeric_limits<float>::infinity();
    for (const Aabb& box : {Aabb{}, Aabb{vec3(3), vec3(3)}, Aabb{vec3(-inf), vec3(inf)}}) {
        const CameraView view = frame_all(box);
        EXPECT_TRUE(std::isfinite(view.position.x + view.position.y + view.position.z));
        EXPECT_GT(view.camera.z_near, 0);
        EXPECT_NEAR(glm::determinant(mat3(view.view)), 1, 1e-5);
    }
}

}  // namespace
}  // namespace lanthorn

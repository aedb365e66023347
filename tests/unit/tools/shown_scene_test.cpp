// What a scene is given that has no light or no camera of its own.
#include "tools/lanthorn/scene/shown_scene.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "lanthorn/core/error.h"
#include "lanthorn/scene/extract.h"

namespace lanthorn::tools {
namespace {

// A square of 2 m that faces +Z, around `at`.
NodeData square(const dvec3& at) {
    NodeData node;
    node.local.translation = at;
    node.meshes = {0};
    return node;
}

// One square at the origin, seen by a camera 10 m in front of it, 100 km out.
SceneData bare() {
    const dvec3 far_out(1e5, 0, 0);
    SceneData s;
    s.source = "bare.glb";
    s.materials.resize(1);
    Mesh& mesh = s.meshes.emplace_back();
    for (const vec3& p : {vec3(-1, -1, 0), vec3(1, -1, 0), vec3(1, 1, 0), vec3(-1, 1, 0)}) {
        mesh.vertices.emplace_back().position = p;
        mesh.vertices.back().normal = vec3(0, 0, 1);
        mesh.bounds.add(p);
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    s.nodes = {square(far_out)};
    NodeData eye;
    eye.name = "eye";
    eye.camera = 0;
    eye.local.translation = far_out + dvec3(0, 0, 10);
    s.nodes.push_back(eye);
    s.cameras.resize(1);
    return s;
}

SceneView through(const std::string& camera) {
    SceneView view;
    view.camera = camera;
    return view;
}

TEST(DefaultLight, HangsOverTheCamerasShoulder) {
    SceneData s = bare();
    ASSERT_TRUE(add_default_light(s, ""));
    ASSERT_EQ(s.lights.size(), 1u);
    const dvec3 at = s.nodes.back().local.translation - dvec3(1e5, 0, 0);
    EXPECT_NEAR(glm::length(at - dvec3(-3.5, 3.5, 10)), 0, 1e-2) << at.x << ' ' << at.y << ' ' << at.z;
    const Light& light = s.lights[0];
    EXPECT_EQ(light.type, LightType::spot);
    const float radius = std::sqrt(2.0f), angle = std::asin(radius / static_cast<float>(glm::length(at)));
    EXPECT_NEAR(light.inner_cone, angle, 1e-3) << "all of it";
    EXPECT_GT(light.outer_cone, light.inner_cone);
    EXPECT_NEAR(glm::length(s.nodes.back().local.rotation * vec3(0, 0, -1) + vec3(glm::normalize(at))), 0,
                1e-3);
    EXPECT_NEAR(light.intensity, 1000 * glm::dot(at, at), 1e-3 * light.intensity);
    EXPECT_FALSE(add_default_light(s, "")) << "there is one now";
}

TEST(DefaultLight, StaysOnThisSideOfAWall) {
    SceneData s = bare();
    NodeData wall = square(dvec3(1e5 - 1, 1, 10));  // across the way up and to the left, half-way at 1 m
    wall.local.rotation = glm::angleAxis(glm::radians(90.0f), vec3(0, 1, 0));
    s.nodes.insert(s.nodes.begin(), wall);
    ASSERT_TRUE(add_default_light(s, "eye"));
    const dvec3 at = s.nodes.back().local.translation - dvec3(1e5, 0, 10);
    EXPECT_NEAR(at.x, -0.8, 1e-2);
    EXPECT_NEAR(at.y, 0.8, 1e-2);
}

TEST(DefaultLight, ShinesAllAroundInARoom) {
    SceneData s = bare();
    s.nodes.push_back(square(dvec3(1e5 + 4, 4, 12)));  // the bounds hold the camera now
    s.nodes.push_back(square(dvec3(1e5 - 6, -4, 12)));
    ASSERT_TRUE(add_default_light(s, "eye"));
    EXPECT_EQ(s.lights[0].type, LightType::point);
    const dvec3 at = s.nodes.back().local.translation - dvec3(1e5, 0, 0);
    EXPECT_NEAR(s.lights[0].intensity, 1000 * glm::dot(at, at), 1e-3 * s.lights[0].intensity);
}

TEST(DefaultLight, OnlyWhereItIsNeededAndCanBeSeen) {
    SceneData lit = bare();
    lit.lights.resize(1);
    lit.nodes[1].light = 0;
    EXPECT_FALSE(add_default_light(lit, ""));
    SceneData glowing = bare();
    glowing.materials[0].emissive = vec3(1);
    EXPECT_FALSE(add_default_light(glowing, ""));
    SceneData empty = bare();
    empty.nodes[0].meshes.clear();
    EXPECT_FALSE(add_default_light(empty, ""));
    SceneData unseen = bare();
    EXPECT_THROW(add_default_light(unseen, "roof"), InputError);
}

TEST(ShownScene, RefusesWhatCannotBeSeen) {
    EXPECT_THROW(ShownScene(bare(), {}), InputError) << "no light";
    SceneData s = bare();
    s.materials[0].emissive = vec3(1);
    EXPECT_NE(ShownScene(s, {}).camera(), ecs::kNullEntity);
    EXPECT_EQ(ShownScene(s, through("auto")).camera(), ecs::kNullEntity);
    EXPECT_THROW(ShownScene(s, through("1")), InputError);
    s.nodes[1].camera = kNone;
    EXPECT_EQ(ShownScene(s, {}).camera(), ecs::kNullEntity) << "one that sees everything";
    s.nodes[0].meshes.clear();
    EXPECT_THROW(ShownScene(s, {}), InputError) << "no geometry";
}

TEST(ListedScene, HasTheCameraBehindItsName) {
    const ListedScene plain = listed_scene("a/b.glb", through("front"));
    EXPECT_EQ(plain.file, "a/b.glb");
    EXPECT_EQ(plain.name, "b");
    EXPECT_EQ(plain.view.camera, "front");
    const ListedScene named = listed_scene("a/b@c.glb@dark", through("front"));
    EXPECT_EQ(named.file, "a/b@c.glb");
    EXPECT_EQ(named.name, "b@c-dark");
    EXPECT_EQ(named.view.camera, "dark");
    const std::string whole = "/tmp/lanthorn@" + std::to_string(::getpid()) + ".glb";
    std::ofstream(whole) << "there";
    EXPECT_EQ(listed_scene(whole, {}).file, whole) << "a file of that name is the scene";
    std::filesystem::remove(whole);
}

}  // namespace
}  // namespace lanthorn::tools

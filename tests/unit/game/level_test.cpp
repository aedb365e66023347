#include "game/level.h"

#include <gtest/gtest.h>

#include "lanthorn/core/error.h"

namespace lanthorn::game {
namespace {

// A scene of nodes alone, each with a mesh of a box 2 x 2 x 2 around its origin.
SceneData boxes() {
    SceneData scene;
    scene.source = "room.glb";
    scene.materials.resize(1);
    Mesh mesh;
    mesh.bounds.add(vec3(-1));
    mesh.bounds.add(vec3(1));
    scene.meshes.push_back(mesh);
    return scene;
}

std::uint32_t add(SceneData& scene, const std::string& name, const dvec3& at, const std::string& extras = "",
                  std::uint32_t parent = kNone) {
    NodeData node;
    node.name = name;
    node.local.translation = at;
    node.extras = extras;
    node.parent = parent;
    node.meshes = {0};
    scene.nodes.push_back(node);
    return static_cast<std::uint32_t>(scene.nodes.size() - 1);
}

constexpr const char* kBoxExtras = R"({"collider":"box"})";

TEST(Level, FindsWhatItNeeds) {
    SceneData scene = boxes();
    add(scene, "player_start", {1, 0, 2});
    add(scene, "wall", {5, 1, 0}, kBoxExtras);
    add(scene, "picture", {5, 1, 0});
    const std::uint32_t door = add(scene, "door", {0, 0, 3}, R"({"open_angle": -1.5})");
    add(scene, "leaf", {0, 1, 1}, kBoxExtras, door);
    add(scene, "lantern", {0, 0.5, 0});
    add(scene, "far_sensor", {9, 1, 0});

    const Level level = find_level(scene);
    EXPECT_EQ(level.start, dvec3(1, 0, 2));
    EXPECT_EQ(level.start_yaw, 0);
    ASSERT_EQ(level.walls.size(), 1u);
    EXPECT_EQ(level.walls[0].centre, dvec3(5, 1, 0));
    EXPECT_EQ(level.walls[0].half, dvec3(1, 1, 1));
    ASSERT_TRUE(level.door);
    EXPECT_EQ(level.door->hinge, dvec3(0, 0, 3));
    EXPECT_EQ(level.door->open_angle, -1.5);
    ASSERT_EQ(level.door->leaf.size(), 1u);
    EXPECT_EQ(level.door->leaf[0].centre, dvec3(0, 1, 1));  // relative to the hinge
    ASSERT_TRUE(level.lantern);
    EXPECT_EQ(level.lantern->light_node, kNone);
    EXPECT_EQ(level.far_sensor, dvec3(9, 1, 0));
}

TEST(Level, ColliderFollowsScaleAndTurn) {
    SceneData scene = boxes();
    add(scene, "player_start", {0, 0, 0});
    const std::uint32_t crate = add(scene, "crate", {3, 0, 0}, kBoxExtras);
    scene.nodes[crate].local.scale = {0.5f, 2, 0.25f};
    scene.nodes[crate].local.rotation = glm::angleAxis(0.4f, vec3(0, 1, 0));
    const Box box = find_level(scene).walls.at(0);
    EXPECT_NEAR(box.yaw, 0.4, 1e-6);
    EXPECT_NEAR(glm::distance(box.half, dvec3(0.5, 2, 0.25)), 0, 1e-6);

    // Tilted: the level box around it.
    scene.nodes[crate].local.scale = {1, 1, 1};
    scene.nodes[crate].local.rotation = glm::angleAxis(kPi / 4, vec3(1, 0, 0));
    const Box tilted = find_level(scene).walls.at(0);
    EXPECT_NEAR(glm::distance(tilted.half, dvec3(1, std::sqrt(2.0), std::sqrt(2.0))), 0, 1e-6);
}

TEST(Level, RefusesScenesThatAreNone) {
    const auto message = [](const SceneData& scene) -> std::string {
        try {
            find_level(scene);
        } catch (const InputError& e) {
            return e.what();
        }
        return "";
    };
    SceneData scene = boxes();
    EXPECT_NE(message(scene).find("player_start"), std::string::npos);
    add(scene, "player_start", {0, 0, 0});
    EXPECT_EQ(message(scene), "");

    SceneData sphere = scene;
    add(sphere, "ball", {0, 0, 0}, R"({"collider":"sphere"})");
    EXPECT_NE(message(sphere).find("'ball'"), std::string::npos);

    SceneData list = scene;
    add(list, "odd", {0, 0, 0}, "[1]");
    EXPECT_NE(message(list).find("expected an object"), std::string::npos);

    SceneData bare = scene;
    bare.nodes[add(bare, "bare", {0, 0, 0}, kBoxExtras)].meshes.clear();
    EXPECT_NE(message(bare).find("expected a mesh"), std::string::npos);
}

}  // namespace
}  // namespace lanthorn::game

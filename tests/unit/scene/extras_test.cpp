#include "lanthorn/scene/extras.h"

#include <gtest/gtest.h>

#include "engine/scene/declare_components.h"
#include "lanthorn/core/error.h"
#include "lanthorn/scene/light_sensor.h"
#include "lanthorn/scene/spawn.h"

namespace lanthorn {
namespace {

struct Door {
    float open_angle = 1.9f;
    ecs::Entity handle;
};

class ExtrasOfNodes : public testing::Test {
  protected:
    ExtrasOfNodes() {
        declare_scene_components(registry);
        registry.component<Door>("door", "a leaf that turns",
                                 ecs::field("open_angle", &Door::open_angle).unit("rad").range(0, 3.1),
                                 ecs::field("handle", &Door::handle));
    }
    void add(const std::string& name, const std::string& extras) {
        NodeData node;
        node.name = name;
        node.extras = extras;
        scene.nodes.push_back(node);
    }
    std::vector<std::string> apply(BadExtras bad = BadExtras::refuse) {
        entities = spawn(world, scene);
        return apply_extras(world, registry, entities, "level.glb", bad);
    }
    std::string refusal() {
        try {
            apply();
        } catch (const InputError& e) {
            return e.what();
        }
        return "";
    }

    ecs::Registry registry;
    ecs::World world;
    SceneData scene;
    std::vector<ecs::Entity> entities;
};

TEST_F(ExtrasOfNodes, BecomeComponents) {
    add("leaf", R"({"door": {"open_angle": 1.5, "handle": "knob"}, "author": "Ann"})");
    add("knob", "");
    add("", R"({"light_sensor": {"radius": 0.5}})");
    add("", R"({"light_sensor": {"filter": [1, -1.2, -1]}})");
    EXPECT_TRUE(apply().empty());
    EXPECT_EQ(world.get<Door>(entities[0]).open_angle, 1.5f);
    EXPECT_EQ(world.get<Door>(entities[0]).handle, entities[1]);
    EXPECT_FALSE(world.has<Door>(entities[1]));
    EXPECT_EQ(world.get<LightSensor>(entities[2]).radius, 0.5f);
    EXPECT_EQ(world.get<LightSensor>(entities[2]).filter, vec3(0.2126f, 0.7152f, 0.0722f));
    EXPECT_EQ(world.get<LightSensor>(entities[3]).filter, vec3(1, -1.2f, -1));
    EXPECT_EQ(world.get<LightSensor>(entities[3]).filter, vec3(1, -1.2f, -1));
    EXPECT_EQ(world.get<Extras>(entities[0]).json, scene.nodes[0].extras);
}

TEST_F(ExtrasOfNodes, OfOtherProgramsMeanNothing) {
    add("a", R"({"name": "x", "light": {"watts": 5}, "camera": 7, "extras": {}, "cycles": {"samples": 5}})");
    add("b", R"([1, 2])");
    add("c", R"("door")");
    EXPECT_TRUE(apply().empty());
    EXPECT_EQ(world.get<Name>(entities[0]).value, "a");
    EXPECT_FALSE(world.has<LightComponent>(entities[0]));
}

TEST_F(ExtrasOfNodes, BadOnesAreRefusedInOneLine) {
    add("knob", "{}");
    add("leaf", R"({"door": {"open_angle": 5}})");
    EXPECT_EQ(refusal(), "level.glb: node 'leaf': door.open_angle is 5, expected a number from 0 to 3.1 rad");
    EXPECT_FALSE(world.has<Door>(entities[1]));
    scene.nodes[1].extras = R"({"door": {"angel": 1}})";
    EXPECT_EQ(refusal(), "level.glb: node 'leaf': door.angel is not known, did you mean 'handle'?");
    scene.nodes[1].extras = R"({"doors": {}})";
    EXPECT_EQ(refusal(), "level.glb: node 'leaf': doors is no component, did you mean 'door'?");
    scene.nodes[1].name.clear();
    scene.nodes[1].extras = R"({"door": {"handle": "nob"}})";
    EXPECT_EQ(refusal(),
              "level.glb: node 1: door.handle is \"nob\", expected the name of an entity, or null");
}

TEST_F(ExtrasOfNodes, BadOnesAreSkippedOnWish) {
    add("bad", R"({"door": {"open_angle": 5}, "light_sensor": {"raduis": 1}})");
    const std::vector<std::string> lines = apply(BadExtras::skip);
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[0],
              "level.glb: node 'bad': door.open_angle is 5, expected a number from 0 to 3.1 rad: skipped");
    EXPECT_EQ(lines[1],
              "level.glb: node 'bad': light_sensor.raduis is not known, did you mean 'radius'?: ignored");
    EXPECT_FALSE(world.has<Door>(entities[0]));
    EXPECT_TRUE(world.has<LightSensor>(entities[0]));
}

}  // namespace
}  // namespace lanthorn

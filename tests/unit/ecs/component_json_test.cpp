#include "lanthorn/ecs/component_json.h"

#include <gtest/gtest.h>

#include "lanthorn/ecs/snapshot.h"
#include "lanthorn/ecs/world_hash.h"
#include "tests/unit/ecs/declared.h"

namespace lanthorn::ecs {
namespace {

using test::Door;
using test::Keys;
using test::line_of;

class ComponentJson : public testing::Test {
  protected:
    ComponentJson() { test::declare(registry); }

    // The only problem of these extras.
    std::string problem(std::string_view extras) {
        const ExtrasReading reading = read_extras(registry, extras, names);
        std::vector<JsonProblem> all = reading.skipped;
        all.insert(all.end(), reading.ignored.begin(), reading.ignored.end());
        return all.size() == 1 ? all[0].line() : std::to_string(all.size()) + " problems";
    }

    Registry registry;
    World world;
    EntityNames names{[](std::string_view name) {
                          return name == "bob" ? Entity{4, 1} : kNullEntity;
                      },
                      [](Entity e) {
                          return e == Entity{4, 1} ? "bob" : to_string(e);
                      }};
};

TEST_F(ComponentJson, WritesEveryFieldByItsName) {
    Door door;
    door.open_angle = 0.1f;
    door.keeper = {4, 1};
    door.tags = {"oak"};
    EXPECT_EQ(to_json(*registry.find("door"), &door, names),
              R"({"open_angle":0.1,"angle":0.0,"swing":"inward","open":false,"keeper":"bob","size":null,)"
              R"("tags":["oak"],"hinge":{"at":[0.0,0.0,0.0],"axis":[0.0,1.0,0.0]},"drawn":0})");
}

TEST_F(ComponentJson, ReadsWhatItWrote) {
    Door door;
    door.open_angle = 0.3f;
    door.swing = test::Swing::outward;
    door.size = dvec3(0.1, 2, 1e-9);
    door.hinge.at = dvec3(1e6, 0.1, -3);
    Door read;
    const ComponentType& type = *registry.find("door");
    from_json(type, &read, R"({"size": null, "tags": []})");
    from_json(type, &read, [&] {
        std::string text = to_json(type, &door);
        return text.erase(text.find(",\"drawn\""), 10);  // transient: written for people, not read
    }());
    EXPECT_EQ(to_json(type, &read), to_json(type, &door));

    Keys keys{{{1, 1}}, 0xffffffffffffffffull}, again;
    keys.opens.clear();
    from_json(*registry.find("keys"), &again, to_json(*registry.find("keys"), &keys));
    EXPECT_EQ(again.number, keys.number);
}

TEST_F(ComponentJson, ExtrasBecomeComponents) {
    const ExtrasReading reading = read_extras(
        registry, R"({"door": {"open_angle": 1.2, "keeper": "bob"}, "author": {"name": "x"}, "size": 3})",
        names);
    EXPECT_TRUE(reading.skipped.empty());
    EXPECT_TRUE(reading.ignored.empty());
    ASSERT_EQ(reading.types.size(), 1u);
    const Door& door = *static_cast<const Door*>(reading.values[0].get());
    EXPECT_EQ(door.open_angle, 1.2f);
    EXPECT_EQ(door.keeper, (Entity{4, 1}));
    EXPECT_EQ(door.swing, test::Swing::inward);
}

TEST_F(ComponentJson, BadExtrasAreNamed) {
    EXPECT_EQ(problem(R"({"door": {"open_angle": 5}})"),
              "door.open_angle is 5, expected a number from 0 to 3.1 rad");
    EXPECT_EQ(problem(R"({"door": {"open_angle": "wide"}})"),
              "door.open_angle is \"wide\", expected a number from 0 to 3.1 rad");
    EXPECT_EQ(problem(R"({"door": {"opn_angle": 1}})"),
              "door.opn_angle is not known, did you mean 'open_angle'?");
    EXPECT_EQ(problem(R"({"door": {"drawn": 1}})"), "door.drawn is not known, did you mean 'drawn'?");
    EXPECT_EQ(problem(R"({"dor": {}})"), "dor is no component, did you mean 'door'?");
    EXPECT_EQ(problem(R"({"door": 7})"), "door is 7, expected an object");
    EXPECT_EQ(problem(R"({"door": {"swing": "up"}})"),
              "door.swing is \"up\", expected one of 'inward', 'outward'");
    EXPECT_EQ(problem(R"({"door": {"open": 1}})"), "door.open is 1, expected true or false");
    EXPECT_EQ(problem(R"({"door": {"size": [1, 0, 1]}})"),
              "door.size is [1,0,1], expected three numbers more than 0 m, or null");
    EXPECT_EQ(problem(R"({"door": {"size": [1, 1]}})"),
              "door.size is [1,1], expected three numbers more than 0 m, or null");
    EXPECT_EQ(problem(R"({"door": {"tags": ["a", 2]}})"),
              "door.tags[1] is 2, expected an array, each of it a text");
    EXPECT_EQ(problem(R"({"door": {"keeper": "eve"}})"),
              "door.keeper is \"eve\", expected the name of an entity, or null");
    EXPECT_EQ(problem(R"({"door": {"hinge": {"axis": [0, 2, 0]}}})"),
              "door.hinge.axis is [0,2,0], expected three numbers from -1 to 1");
    EXPECT_EQ(problem(R"({"keys": {"number": -1}})"), "keys.number is -1, expected an integer");
    EXPECT_EQ(problem(R"({"keys": {"number": 0.5}})"), "keys.number is 0.5, expected an integer");
    EXPECT_EQ(problem("{"), "extras are not JSON, expected an object");
    EXPECT_EQ(problem("[1]"), "0 problems");
}

TEST_F(ComponentJson, FieldsByTheirPath) {
    const Entity e = world.create(Door{});
    const Tick before = world.mark();
    EXPECT_EQ(get_json(registry, world, e, "door.hinge.axis"), "[0.0,1.0,0.0]");
    EXPECT_FALSE(world.changed<Door>(e, before));
    set_json(registry, world, e, "door.open_angle", "0.25");
    set_json(registry, world, e, "door.hinge.axis", "[1, 0, 0]");
    EXPECT_TRUE(world.changed<Door>(e, before));
    EXPECT_EQ(world.get<Door>(e).open_angle, 0.25f);
    EXPECT_EQ(world.get<Door>(e).hinge.axis, vec3(1, 0, 0));
    EXPECT_EQ(line_of([&] { set_json(registry, world, e, "door.open_angle", "9"); }),
              "door.open_angle is 9, expected a number from 0 to 3.1 rad");
    EXPECT_EQ(line_of([&] { set_json(registry, world, e, "door.colour", "9"); }),
              "'door.colour': there is no field 'colour'");
    EXPECT_EQ(line_of([&] { get_json(registry, world, e, "keys"); }),
              to_string(e) + " has no component 'keys'");
    EXPECT_EQ(world.get<Door>(e).open_angle, 0.25f);
}

TEST_F(ComponentJson, ExtrasAreWrittenAsTheyWereButForWhatChanged) {
    const std::string extras = R"({ "author" : {"n": 1.50}, "door": {"open_angle": 1.20, "open": true} })";
    const ExtrasReading reading = read_extras(registry, extras);
    const Entity e = world.create(Door(*static_cast<const Door*>(reading.values[0].get())));
    EXPECT_EQ(write_extras(registry, world, e, extras), extras);
    world.get_mut<Door>(e).drawn = 5;  // transient
    EXPECT_EQ(write_extras(registry, world, e, extras), extras);
    world.get_mut<Door>(e).angle = 0.5f;  // runtime
    EXPECT_EQ(write_extras(registry, world, e, extras), extras);
    world.get_mut<Door>(e).swing = test::Swing::outward;
    EXPECT_EQ(write_extras(registry, world, e, extras),
              R"({"author":{"n":1.5},"door":{"open_angle":1.2,"open":true,"swing":"outward"}})");
    world.remove<Door>(e);
    EXPECT_EQ(write_extras(registry, world, e, extras), R"({"author":{"n":1.5}})");
    world.add(e, Keys{{}, 7});
    EXPECT_EQ(write_extras(registry, world, e, ""), R"({"keys":{"number":7}})");
    EXPECT_EQ(write_extras(registry, world, e, "[1]"), "[1]");
}

TEST_F(ComponentJson, WhatTheSimulationWroteStaysOutOfExtrasAlone) {
    struct Timer {
        double left = 3;
    };
    registry.component<Timer>("timer", "runs down", field("left", &Timer::left)).runtime();
    EXPECT_TRUE(registry.find("timer")->value->fields[0].runtime);
    const Entity e = world.create(Door{}, Timer{});
    const auto before = state_hashes(registry, world);
    world.get_mut<Door>(e).angle = 0.5f;
    EXPECT_NE(state_hashes(registry, world), before);
    EXPECT_EQ(write_extras(registry, world, e, ""), R"({"door":{}})");
    EXPECT_EQ(write_extras(registry, world, e, R"({"door":{"angle":0.25}})"), R"({"door":{"angle":0.25}})");
    const Snapshot saved = Snapshot::save(world, registry);
    world.get_mut<Door>(e).angle = 0;
    world.get_mut<Timer>(e).left = 0;
    Snapshot::from_bytes(saved.to_bytes(), registry, "test").restore(world);
    EXPECT_EQ(world.get<Door>(e).angle, 0.5f);
    EXPECT_EQ(world.get<Timer>(e).left, 3);
}

}  // namespace
}  // namespace lanthorn::ecs

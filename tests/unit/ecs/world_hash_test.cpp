#include "lanthorn/ecs/world_hash.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/unit/ecs/declared.h"

namespace lanthorn::ecs {
namespace {

using test::Clock;
using test::Door;
using test::Keys;

class WorldHash : public testing::Test {
  protected:
    WorldHash() {
        test::declare(registry);
        for (World* world : {&one, &other}) {
            world->insert_resource(Clock{1});
            for (int i = 0; i < 5; ++i) {
                Door door;
                door.angle = static_cast<float>(i);
                world->create(door);
            }
        }
    }
    std::vector<std::uint64_t> hashes(const World& world) const { return state_hashes(registry, world); }

    Registry registry;
    World one, other;
    Entity third{2, 1};
};

TEST_F(WorldHash, HasAPartAComponentAndResource) {
    EXPECT_EQ(state_parts(registry), (std::vector<std::string>{"entities", "door", "keys", "clock"}));
    EXPECT_EQ(hashes(one).size(), 4u);
}

struct Lamp {
    float watts = 0;
    int colour = 0;
};
struct OtherLamp {
    double watts = 0;
    int colour = 0;
};

std::uint64_t schema_of_lamp(const std::function<void(Registry&)>& declare) {
    Registry registry;
    declare(registry);
    const std::vector<std::uint64_t> schemas = state_schemas(registry);
    EXPECT_EQ(schemas.size(), state_parts(registry).size());
    return schemas.back();
}

TEST_F(WorldHash, ASchemaSaysWhichFieldsCount) {
    const auto lamp = [](const char* watts, bool transient, const char* words) {
        return schema_of_lamp([&](Registry& r) {
            auto colour = field("colour", &Lamp::colour).words("a");
            r.component<Lamp>("lamp", words, field(watts, &Lamp::watts).words("a"),
                              transient ? std::move(colour).transient() : std::move(colour));
        });
    };
    const std::uint64_t schema = lamp("watts", false, "shines");
    EXPECT_EQ(lamp("watts", false, "other words"), schema);
    EXPECT_NE(lamp("power", false, "shines"), schema);
    EXPECT_NE(lamp("watts", true, "shines"), schema);
    EXPECT_NE(schema_of_lamp([](Registry& r) {
                  r.component<OtherLamp>("lamp", "shines", field("watts", &OtherLamp::watts).words("a"),
                                         field("colour", &OtherLamp::colour).words("a"));
              }),
              schema);
}

TEST_F(WorldHash, DependsOnStateAndNotOnStorageOrder) {
    other.add(third, Keys{});  // to another table
    EXPECT_NE(hashes(one)[2], hashes(other)[2]);
    EXPECT_EQ(hashes(one)[1], hashes(other)[1]);
    other.remove<Keys>(third);  // and back, to another row
    EXPECT_EQ(hashes(one), hashes(other));
}

TEST_F(WorldHash, SeesEveryFieldThatIsState) {
    const std::vector<std::uint64_t> before = hashes(one);
    const auto alters = [&](auto alter) {
        const Door kept = one.get<Door>(third);
        alter(one.get_mut<Door>(third));
        const std::vector<std::uint64_t> now = hashes(one);
        one.get_mut<Door>(third) = kept;
        EXPECT_EQ(hashes(one), before);
        return now[1] != before[1];
    };
    EXPECT_TRUE(alters([](Door& d) { d.open_angle = std::nextafter(d.open_angle, 0.0f); }));
    EXPECT_TRUE(alters([](Door& d) { d.swing = test::Swing::outward; }));
    EXPECT_TRUE(alters([](Door& d) { d.open = true; }));
    EXPECT_TRUE(alters([](Door& d) { d.keeper = {1, 1}; }));
    EXPECT_TRUE(alters([](Door& d) { d.size = dvec3(0); }));
    EXPECT_TRUE(alters([](Door& d) { d.tags.emplace_back(); }));
    EXPECT_TRUE(alters([](Door& d) { d.hinge.axis.x = 1; }));
    EXPECT_FALSE(alters([](Door& d) { d.drawn = 3; })) << "transient";
    one.resource_mut<Clock>().step = 2;
    EXPECT_NE(hashes(one)[3], before[3]);
}

TEST_F(WorldHash, DifferencesAreNamedByField) {
    EXPECT_TRUE(state_differences(registry, one, other).empty());
    one.get_mut<Door>(third).angle = 0.5f;
    one.add(third, Keys{});
    other.resource_mut<Clock>().step = 4;
    EXPECT_EQ(state_differences(registry, one, other),
              (std::vector<std::string>{"door of entity 2v1: angle is 0.5, expected 2.0",
                                        "keys of entity 2v1: is there, expected none",
                                        "clock: step is 1, expected 4"}));
    EXPECT_EQ(state_differences(registry, one, other, 1).size(), 1u);
}

}  // namespace
}  // namespace lanthorn::ecs

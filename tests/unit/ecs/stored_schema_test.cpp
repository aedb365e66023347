// Snapshots of a program whose components were declared otherwise: values go by name.
#include <gtest/gtest.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <cstring>
#include <random>

#include "lanthorn/ecs/query.h"
#include "lanthorn/ecs/snapshot.h"
#include "tests/unit/ecs/declared.h"

namespace lanthorn::ecs {
namespace {

using test::line_of;

struct Torch {
    float heat = 1;
};
struct Score {
    int points = 0;
};

namespace before {

enum class Swing { inward, outward, both };
struct Hinge {
    vec3 axis{0, 1, 0};
    double wear = 0;
};
struct Door {
    float angle = 0;
    Swing swing = Swing::inward;
    std::string label;
    int uses = 0;
    Entity keeper;
    std::vector<Hinge> hinges;
    bool open = false;
    double speed = 0;
};

void declare(Registry& registry) {
    registry.structure("hinge", field("axis", &Hinge::axis), field("wear", &Hinge::wear));
    registry.component<Door>("door", "", field("angle", &Door::angle),
                             field("swing", &Door::swing).choices({"inward", "outward", "both"}),
                             field("label", &Door::label), field("uses", &Door::uses),
                             field("keeper", &Door::keeper), field("hinges", &Door::hinges),
                             field("open", &Door::open), field("speed", &Door::speed));
    registry.component<Torch>("torch", "", field("heat", &Torch::heat));
    registry.resource<Score>("score", "", field("points", &Score::points));
}

}  // namespace before

namespace now {

enum class Swing { outward, inward };
struct Hinge {
    float squeak = 0.25f;
    vec3 axis{0, 0, 1};
};
// Reordered; `label` and `speed` are gone, `colour` has come, `angle` and `uses` are of other types, `open`
// of another kind.
struct Door {
    std::vector<Hinge> hinges;
    vec3 colour{1, 0, 0};
    std::uint8_t uses = 0;
    std::vector<Entity> open;
    Entity keeper;
    double angle = 0;
    Swing swing = Swing::outward;
};
struct Bell {
    int tone = 440;
};
struct Weather {
    int rain = 3;
};

void declare(Registry& registry) {
    registry.component<Bell>("bell", "", field("tone", &Bell::tone));
    registry.structure("hinge", field("squeak", &Hinge::squeak), field("axis", &Hinge::axis));
    registry.component<Door>("door", "", field("hinges", &Door::hinges), field("colour", &Door::colour),
                             field("uses", &Door::uses).range(0, 200), field("open", &Door::open),
                             field("keeper", &Door::keeper), field("angle", &Door::angle),
                             field("swing", &Door::swing).choices({"outward", "inward"}));
    registry.resource<Weather>("weather", "", field("rain", &Weather::rain));
    registry.resource<Score>("score", "", field("points", &Score::points));
}

}  // namespace now

class SavedByAnotherBuild : public testing::Test {
  protected:
    SavedByAnotherBuild() {
        before::declare(then);
        now::declare(registry);
        before::Door door;
        door.angle = 0.1f;
        door.swing = before::Swing::inward;
        door.label = "north";
        door.uses = 7;
        door.hinges = {{{1, 0, 0}, 0.5}, {{0, 1, 0}, 0.75}};
        door.open = true;
        first = saved.create(door);
        door.keeper = first;
        door.uses = 1000;
        door.swing = before::Swing::both;
        second = saved.create(door, Torch{});
        saved.insert_resource(Score{12});
        // The same entities, as the level begins in this build.
        now::Door begun;
        begun.colour = {0, 0, 1};
        world.create(begun, now::Bell{220});
        world.insert_resource(now::Weather{9});
        world.insert_resource(Score{});
    }
    std::string bytes() const { return Snapshot::save(saved, then).to_bytes(); }

    Registry then, registry;
    World saved, world;
    Entity first, second;
};

TEST_F(SavedByAnotherBuild, IsReadByName) {
    const Snapshot snapshot = Snapshot::from_bytes(bytes(), registry, "a.save");
    snapshot.restore(world);
    const now::Door& door = world.get<now::Door>(first);
    EXPECT_FLOAT_EQ(static_cast<float>(door.angle), 0.1f);
    EXPECT_EQ(door.swing, now::Swing::inward);
    EXPECT_EQ(door.uses, 7);
    ASSERT_EQ(door.hinges.size(), 2u);
    EXPECT_EQ(door.hinges[0].axis, vec3(1, 0, 0));
    EXPECT_EQ(door.hinges[0].squeak, 0.25f);
    EXPECT_TRUE(door.open.empty());
    EXPECT_EQ(world.get<now::Door>(second).keeper, first);
    EXPECT_EQ(world.get<now::Door>(second).uses, 200) << "in the range of today";
    EXPECT_EQ(world.get<now::Door>(second).swing, now::Swing::outward) << "its default";
    EXPECT_EQ(world.resource<Score>().points, 12);
    EXPECT_EQ(snapshot.left_out(), (std::vector<std::string>{"door.hinges.wear", "door.label", "door.open",
                                                             "door.speed", "door.swing", "torch"}));
}

TEST_F(SavedByAnotherBuild, WhatIsNewIsAsTheLevelHasIt) {
    Snapshot::from_bytes(bytes(), registry, "a.save").restore(world);
    EXPECT_EQ(world.get<now::Door>(first).colour, vec3(0, 0, 1));
    EXPECT_EQ(world.get<now::Bell>(first).tone, 220);
    EXPECT_EQ(world.get<now::Door>(second).colour, vec3(1, 0, 0)) << "it did not live: the default";
    EXPECT_FALSE(world.has<now::Bell>(second));
    EXPECT_EQ(world.resource<now::Weather>().rain, 9);
    EXPECT_TRUE(world.alive(second));
    EXPECT_EQ(world.size(), 2u);
}

TEST_F(SavedByAnotherBuild, AndBackAgain) {
    Snapshot::from_bytes(bytes(), registry, "a.save").restore(world);
    const Snapshot back = Snapshot::from_bytes(Snapshot::save(world, registry).to_bytes(), then, "b.save");
    back.restore(saved);
    EXPECT_EQ(saved.get<before::Door>(first).angle, 0.1f);
    EXPECT_EQ(saved.get<before::Door>(first).swing, before::Swing::inward);
    EXPECT_EQ(saved.get<before::Door>(first).label, "north") << "as it is on who lives";
    EXPECT_EQ(back.left_out(), (std::vector<std::string>{"bell", "door.colour", "door.hinges.squeak",
                                                         "door.open", "weather"}));
}

TEST_F(SavedByAnotherBuild, TheSameBuildLeavesNothingOut) {
    EXPECT_TRUE(Snapshot::from_bytes(bytes(), then, "a.save").left_out().empty());
}

// The checksum finds damage; a schema that is not the content's is found by taking the content apart.
TEST_F(SavedByAnotherBuild, NoDamageGoesUnseen) {
    const std::string whole = bytes();
    std::mt19937 random(3);
    for (int i = 0; i < 2000; ++i) {
        std::string damaged = whole;
        damaged[12 + random() % (whole.size() - 12)] ^= static_cast<char>(1 + random() % 255);
        const std::string line = line_of([&] { Snapshot::from_bytes(damaged, registry, "a.save"); });
        // The schema's hash alone may differ: it says only that values are to be found by name.
        if (damaged.substr(24) != whole.substr(24)) {
            EXPECT_EQ(line.substr(0, 10), "a.save: is") << i;
        }
    }
}

// Damage that the checksum does not show: it is refused in one line, or read as something else.
TEST_F(SavedByAnotherBuild, ForgedBytesAreReadOrRefused) {
    const std::string whole = bytes();
    std::mt19937 random(4);
    int refused = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string forged = whole;
        for (int k = 0; k < 1 + i % 3; ++k) {
            forged[32 + random() % (whole.size() - 32)] = static_cast<char>(random() % 256);
        }
        const std::uint64_t content = XXH3_64bits(forged.data() + 32, forged.size() - 32);
        std::memcpy(&forged[24], &content, sizeof content);
        const std::string line = line_of([&] { Snapshot::from_bytes(forged, registry, "a.save"); });
        refused += line.empty() ? 0 : 1;
        EXPECT_TRUE(line.empty() || line.starts_with("a.save: is a damaged snapshot")) << line;
    }
    EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace lanthorn::ecs

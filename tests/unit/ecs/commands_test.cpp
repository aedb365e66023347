#include "lanthorn/ecs/commands.h"

#include <gtest/gtest.h>

#include "lanthorn/ecs/query.h"
#include "tests/unit/ecs/components.h"
#include "tests/unit/ecs/expect_error.h"

namespace lanthorn::ecs {
namespace {

using namespace ecs_test;

TEST(Commands, DoThingsLaterInOrder) {
    World world;
    const Entity old = world.create(Position{});
    Commands commands(world);
    Entity made;
    world.query<Read<Position>>().each([&](Entity e, const Position&) {
        made = commands.create(Position{1, 0, 0}, Label{"made while iterating"});
        commands.add(made, Mass{3});
        commands.insert(made, Mass{4});
        commands.remove<Position>(made);
        commands.destroy(e);
    });
    EXPECT_TRUE(world.alive(old));
    EXPECT_FALSE(world.alive(made));
    EXPECT_FALSE(commands.empty());
    commands.apply();
    EXPECT_TRUE(commands.empty());
    EXPECT_FALSE(world.alive(old));
    ASSERT_TRUE(world.alive(made));
    EXPECT_EQ(world.get<Mass>(made).kg, 4);
    EXPECT_EQ(world.get<Label>(made).text, "made while iterating");
    EXPECT_FALSE(world.has<Position>(made));
}

TEST(Commands, HandlesOfNewEntitiesCanBeStored) {
    struct Link {
        Entity to;
    };
    World world;
    Commands commands(world);
    const Entity a = commands.create();
    const Entity b = commands.create(Link{a});
    commands.add(a, Link{b});
    commands.run([](World& w) { w.insert_resource(7); });
    commands.apply();
    EXPECT_EQ(world.get<Link>(a).to, b);
    EXPECT_EQ(world.get<Link>(b).to, a);
    EXPECT_EQ(world.resource<int>(), 7);
}

TEST(Commands, ThrowOnMisuseAndDropTheRest) {
    Counted::living = 0;
    World world;
    const Entity e = world.create();
    Commands commands(world);
    commands.destroy(e);
    commands.destroy_if_alive(e);
    commands.destroy(e);
    const Entity never = commands.create(Counted(1));
    EXPECT_ECS_ERROR(commands.apply(), "entity 0v1 is not alive");
    EXPECT_TRUE(commands.empty());
    EXPECT_FALSE(world.alive(never));
    EXPECT_EQ(Counted::living, 0);
    world.create();
    world.create();
    EXPECT_EQ(world.size(), 2u);
}

TEST(Commands, DiscardedEntitiesNeverLive) {
    Counted::living = 0;
    World world;
    {
        Commands commands(world);
        commands.create(Counted(1), Wide{});
        commands.create(Owner{std::make_unique<int>(1)});
    }
    EXPECT_EQ(Counted::living, 0);
    EXPECT_EQ(world.size(), 0u);
    EXPECT_LT(world.create().index, 2u);  // their numbers are free again
}

TEST(Commands, CannotBeAppliedWhileIterating) {
    World world;
    world.create(Position{});
    Commands commands(world);
    commands.create();
    EXPECT_ECS_ERROR(world.query<Read<Position>>().each([&](const Position&) { commands.apply(); }),
                     "cannot apply commands");
    commands.apply();
    EXPECT_EQ(world.size(), 2u);
}

TEST(Commands, CarryManyAndLargePayloads) {
    struct Large {
        std::array<char, 20000> bytes{};
    };
    World world;
    Commands commands(world);
    for (int round = 0; round < 2; ++round) {
        for (int i = 0; i < 1000; ++i) {
            commands.create(Wide{}, Label{std::to_string(i)});
            if (i % 100 == 0) {
                commands.create(Large{});
            }
        }
        commands.apply();
    }
    EXPECT_EQ(world.size(), 2020u);
    EXPECT_EQ((world.query<Read<Wide>>().count()), 2000u);
}

}  // namespace
}  // namespace lanthorn::ecs

#include "lanthorn/ecs/hooks.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "lanthorn/ecs/schedule.h"
#include "tests/unit/ecs/components.h"
#include "tests/unit/ecs/expect_error.h"

namespace ecs_test {

// Writes down what happens to it.
struct Watched {
    int number = 0;
    static inline std::vector<std::string> log;
};
struct Held {
    const int number;
};

}  // namespace ecs_test

template <>
struct lanthorn::ecs::Hooks<ecs_test::Watched> {
    static void check(const World&, Entity, const ecs_test::Watched& value) {
        if (value.number < 0) {
            throw Error("watched: number is negative");
        }
    }
    static void on_add(World& world, Entity e) { note(world, e, "+"); }
    static void on_remove(World& world, Entity e) { note(world, e, "-"); }

  private:
    static void note(World& world, Entity e, const std::string& sign) {
        ecs_test::Watched::log.push_back(sign + std::to_string(world.get<ecs_test::Watched>(e).number));
    }
};

namespace lanthorn::ecs {
namespace {

using namespace ecs_test;

using Log = std::vector<std::string>;

Log taken() {
    return std::exchange(Watched::log, {});
}

class HooksTest : public testing::Test {
  protected:
    HooksTest() { taken(); }
    World world;
};

TEST_F(HooksTest, ATypesOwnHooksSeeEveryWayInAndOut) {
    const Entity a = world.create(Watched{1}, Position{});
    EXPECT_EQ(taken(), Log{"+1"});
    const Entity b = world.create(Label{"b"});
    EXPECT_EQ(world.add(b, Watched{2}).number, 2);
    EXPECT_EQ(taken(), Log{"+2"});
    EXPECT_EQ(world.insert(b, Watched{3}).number, 3);
    EXPECT_EQ(taken(), (Log{"-2", "+3"}));
    const Entity c = world.create();
    world.insert(c, Watched{4});
    EXPECT_EQ(taken(), Log{"+4"});
    world.remove<Watched>(b);
    EXPECT_EQ(taken(), Log{"-3"});
    world.remove<Position>(a);
    world.add(a, Mass{});
    EXPECT_EQ(taken(), Log{});
    world.destroy(a);
    EXPECT_EQ(taken(), Log{"-1"});
    world.destroy(b);
    EXPECT_EQ(taken(), Log{});
    world.create_many(2, Watched{5});
    world.clear();
    EXPECT_EQ(taken(), (Log{"+5", "+5", "-4", "-5", "-5"}));
    EXPECT_EQ(world.size(), 0u);
}

TEST_F(HooksTest, CommandsCallThemWhenApplied) {
    Schedule schedule;
    Entity e;
    schedule.add("make", [&](Commands& commands) {
        e = commands.create(Watched{1});
        commands.insert(e, Watched{2});
        const Entity other = commands.create();
        commands.add(other, Watched{3});
        commands.remove<Watched>(other);
        commands.destroy(e);
        EXPECT_EQ(Watched::log, Log{});
    });
    schedule.run(world);
    EXPECT_EQ(taken(), (Log{"+1", "-1", "+2", "+3", "-3", "-2"}));
}

TEST_F(HooksTest, WritingInPlaceIsNoChangeOfHands) {
    const Entity e = world.create(Watched{1});
    taken();
    world.get_mut<Watched>(e).number = 2;
    world.query<Write<Watched>>().each([](Watched& w) { w.number = 3; });
    EXPECT_EQ(taken(), Log{});
}

TEST_F(HooksTest, ARefusedValueChangesNothing) {
    const Entity e = world.create(Watched{1});
    const Entity bare = world.create(Position{});
    const Tick since = world.mark();
    taken();
    EXPECT_ECS_ERROR(world.insert(e, Watched{-1}), "watched: number is negative");
    EXPECT_ECS_ERROR(world.add(bare, Watched{-1}), "watched: number is negative");
    EXPECT_ECS_ERROR(world.create(Watched{-1}), "watched: number is negative");
    Commands commands(world);
    const Entity never = commands.create(Watched{-1});
    EXPECT_ECS_ERROR(commands.apply(), "watched: number is negative");
    EXPECT_FALSE(world.alive(never));
    EXPECT_EQ(taken(), Log{});
    EXPECT_EQ(world.get<Watched>(e).number, 1);
    EXPECT_FALSE(world.changed<Watched>(e, since));
    EXPECT_FALSE(world.has<Watched>(bare));
    EXPECT_EQ(world.size(), 2u);
}

TEST_F(HooksTest, ReplacingCountsAsAChange) {
    const Entity e = world.create(Watched{1});
    const Tick since = world.mark();
    world.insert(e, Watched{2});
    EXPECT_TRUE(world.changed<Watched>(e, since));
    EXPECT_FALSE(world.added<Watched>(e, since));
}

TEST_F(HooksTest, AWorldsHooksHoldUntilUnhooked) {
    Log log;
    const Entity before = world.create(Label{"before"});
    const HookId add =
        world.on_add<Label>([&](World& w, Entity e) { log.push_back("+" + w.get<Label>(e).text); });
    const HookId remove =
        world.on_remove<Label>([&](World& w, Entity e) { log.push_back("-" + w.get<Label>(e).text); });
    world.create(Label{"after"}, Mass{});
    world.insert(before, Label{"anew"});
    EXPECT_EQ(log, (Log{"+after", "-before", "+anew"}));
    log.clear();
    world.unhook(add);
    world.unhook(add);
    world.create(Label{"unseen"});
    world.destroy(before);
    EXPECT_EQ(log, Log{"-anew"});
    world.unhook(remove);
    world.clear();
    EXPECT_EQ(log, Log{"-anew"});
    World other;
    other.create(Label{"elsewhere"});
    EXPECT_EQ(log, Log{"-anew"});
}

TEST_F(HooksTest, AnAddHookMayDoAnythingToItsEntity) {
    // Both tables are moved under the feet of the call.
    world.on_add<Position>([](World& w, Entity e) {
        w.add(e, Velocity{1, 2, 3});
        for (int i = 0; i < 100; ++i) {
            w.create(Mass{});
        }
    });
    const Entity e = world.create(Label{"e"});
    EXPECT_EQ(world.add(e, Position{4, 5, 6}).y, 5);
    EXPECT_EQ(world.get<Velocity>(e).z, 3);
    EXPECT_TRUE(world.alive(world.create(Position{}, Label{"x"})));

    world.on_add<Frozen>([](World& w, Entity frozen) { w.destroy(frozen); });
    EXPECT_FALSE(world.alive(world.create(Frozen{}, Label{"gone"})));
    EXPECT_ECS_ERROR(world.add(e, Frozen{}), "a hook took the component ecs_test::Frozen from entity 0v1");
    EXPECT_FALSE(world.alive(e));
}

TEST_F(HooksTest, ARemoveHookMayChangeOthersButNotItsEntity) {
    const Entity other = world.create(Mass{});
    world.on_remove<Position>([&](World& w, Entity) { w.destroy(other); });
    world.destroy(world.create(Position{}));
    EXPECT_FALSE(world.alive(other));

    world.on_remove<Velocity>([](World& w, Entity e) { w.destroy(e); });
    const Entity e = world.create(Velocity{}, Label{"kept"});
    EXPECT_ECS_ERROR(world.destroy(e), "a hook removes or destroys entity 1v2");
    EXPECT_ECS_ERROR(world.remove<Velocity>(e), "a hook removes or destroys entity 1v2");
    EXPECT_EQ(world.get<Label>(e).text, "kept");
    EXPECT_FALSE(world.leaving(e));

    world.on_remove<Mass>([](World& w, Entity heavy) { w.add(heavy, Frozen{}); });
    const Entity heavy = world.create(Mass{});
    EXPECT_ECS_ERROR(world.destroy(heavy), "changed which components entity");
    EXPECT_TRUE(world.alive(heavy));
}

TEST_F(HooksTest, ExceptionsOfHooksComeOut) {
    world.on_add<Position>([](World&, Entity) { throw std::runtime_error("add"); });
    world.on_remove<Mass>([](World&, Entity) { throw std::runtime_error("remove"); });
    const Entity e = world.create(Mass{});
    EXPECT_THROW(world.add(e, Position{}), std::runtime_error);
    EXPECT_TRUE(world.has<Position>(e));
    EXPECT_THROW(world.remove<Mass>(e), std::runtime_error);
    EXPECT_THROW(world.destroy(e), std::runtime_error);
    EXPECT_TRUE(world.has<Mass>(e));
}

TEST_F(HooksTest, ReplacingWaitsForTheEndOfAQuery) {
    const Entity e = world.create(Watched{1}, Position{});
    world.query<Read<Position>>().each(
        [&](const Position&) { EXPECT_ECS_ERROR(world.insert(e, Watched{2}), "while a query iterates"); });
    EXPECT_EQ(world.get<Watched>(e).number, 1);
}

TEST_F(HooksTest, ComponentsThatCannotBeAssignedAreReplacedWhole) {
    Log log;
    world.on_add<Held>([&](World& w, Entity e) { log.push_back(std::to_string(w.get<Held>(e).number)); });
    const Entity e = world.create(Held{1});
    world.insert(e, Held{2});
    EXPECT_EQ(log, (Log{"1", "2"}));
}

TEST_F(HooksTest, ClearReachesWhatHooksMakeMeanwhile) {
    int made = 0;
    world.on_remove<Position>([&](World& w, Entity) {
        if (++made < 5) {
            w.create(Position{});
        }
    });
    world.create(Position{});
    world.create(Mass{});
    world.clear();
    EXPECT_EQ(made, 5);
    EXPECT_EQ(world.size(), 0u);
}

}  // namespace
}  // namespace lanthorn::ecs

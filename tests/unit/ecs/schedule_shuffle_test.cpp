// Legal orders other than the usual one: they prove, or refute, what systems declare.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "lanthorn/ecs/query.h"
#include "lanthorn/ecs/schedule.h"
#include "lanthorn/ecs/world.h"

namespace lanthorn::ecs {
namespace {

constexpr std::uint64_t kSeeds = 50;

struct Speed {
    int value = 1;
};
struct Place {
    int value = 0;
};
struct Light {
    int value = 0;
};

// "speed" writes what "move" reads; "shine" writes what neither knows of.
void add_honest_systems(Schedule& schedule) {
    schedule.add("speed", [](Query<Write<Speed>> things) { things.each([](Speed& s) { s.value = 3 * s.value + 1; }); });
    schedule.add("move", [](Query<Write<Place>, Read<Speed>> things) {
        things.each([](Place& p, const Speed& s) { p.value += s.value; });
    });
    schedule.add("shine", [](Query<Write<Light>> things) { things.each([](Light& l) { l.value += 7; }); });
    schedule.add("age", [](Query<Read<Light>, Write<Speed>> things) {
                things.each([](const Light& l, Speed& s) { s.value += l.value; });
            })
        .after("move");
}

struct Outcome {
    int place, speed, light;
    auto operator<=>(const Outcome&) const = default;
};

Outcome run(Schedule& schedule, std::uint64_t seed) {
    World world;
    const Entity e = world.create(Speed{}, Place{}, Light{});
    schedule.set_threads(1);
    schedule.shuffle(seed);
    for (int i = 0; i < 5; ++i) {
        schedule.run(world);
    }
    return {world.get<Place>(e).value, world.get<Speed>(e).value, world.get<Light>(e).value};
}

TEST(Shuffle, KeepsEveryOrderThatWasAskedForOrFollows) {
    Schedule schedule;
    add_honest_systems(schedule);
    std::set<std::vector<std::string>> orders;
    for (std::uint64_t seed = 0; seed <= kSeeds; ++seed) {
        schedule.shuffle(seed);
        const std::vector<std::string> order = schedule.order();
        const auto at = [&](const char* name) { return std::ranges::find(order, name) - order.begin(); };
        EXPECT_LT(at("speed"), at("move"));
        EXPECT_LT(at("move"), at("age"));
        EXPECT_LT(at("shine"), at("age"));
        orders.insert(order);
    }
    EXPECT_EQ(orders.size(), 3u);  // "shine" before, between or after the other two
}

TEST(Shuffle, TheSameSeedIsTheSameOrder) {
    Schedule schedule;
    add_honest_systems(schedule);
    schedule.shuffle(7);
    const auto order = schedule.order();
    schedule.shuffle(8);
    schedule.order();
    schedule.shuffle(7);
    EXPECT_EQ(schedule.order(), order);
}

TEST(Shuffle, SystemsThatDeclareWhatTheyTouchHaveOneResult) {
    Schedule schedule;
    add_honest_systems(schedule);
    const Outcome usual = run(schedule, 0);
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        EXPECT_EQ(run(schedule, seed), usual) << seed;
    }
}

TEST(Shuffle, CatchesAReadThatIsNotDeclared) {
    Schedule schedule;
    add_honest_systems(schedule);
    // Looks at Light by way of the world that it keeps: nothing tells the schedule.
    const World* kept = nullptr;
    schedule.add("peek", [&kept](Query<Write<Place>> things) {
                things.each([&](Entity e, Place& p) { p.value += kept == nullptr ? 0 : kept->get<Light>(e).value; });
            })
        .after("move");
    const auto outcome = [&](std::uint64_t seed) {
        World world;
        kept = &world;
        const Entity e = world.create(Speed{}, Place{}, Light{});
        schedule.set_threads(1);
        schedule.shuffle(seed);
        schedule.run(world);
        return world.get<Place>(e).value;
    };
    const int usual = outcome(0);
    bool caught = false;
    for (std::uint64_t seed = 1; seed <= kSeeds && !caught; ++seed) {
        caught = outcome(seed) != usual;
    }
    EXPECT_TRUE(caught);
}

TEST(LeaveOut, SkipsThatSystemUntilItIsTakenBack) {
    Schedule schedule;
    add_honest_systems(schedule);
    World world;
    const Entity e = world.create(Speed{}, Place{}, Light{});
    schedule.leave_out("shine");
    schedule.run(world);
    EXPECT_EQ(world.get<Light>(e).value, 0);
    EXPECT_EQ(world.get<Place>(e).value, 4);
    schedule.leave_out("");
    schedule.run(world);
    EXPECT_EQ(world.get<Light>(e).value, 7);
}

}  // namespace
}  // namespace lanthorn::ecs

// Legal orders other than the usual one: they prove, or refute, what systems declare.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engine/ecs/schedule_trial.h"
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
    schedule.add("speed", [](Query<Write<Speed>> things) {
        things.each([](Speed& s) { s.value = 3 * s.value + 1; });
    });
    schedule.add("move", [](Query<Write<Place>, Read<Speed>> things) {
        things.each([](Place& p, const Speed& s) { p.value += s.value; });
    });
    schedule.add("shine", [](Query<Write<Light>> things) { things.each([](Light& l) { l.value += 7; }); });
    schedule
        .add("age",
             [](Query<Read<Light>, Write<Speed>> things) {
                 things.each([](const Light& l, Speed& s) { s.value += l.value; });
             })
        .after("move");
}

struct Outcome {
    int place, speed, light;
    auto operator<=>(const Outcome&) const = default;
};

// Of a schedule that `fill` makes, in the order of a seed.
template <class Fill>
Outcome run(const Fill& fill, std::uint64_t seed) {
    shuffle_schedules(seed);
    World world;
    Schedule schedule;
    fill(schedule, world);
    schedule.set_threads(1);
    const Entity e = world.create(Speed{}, Place{}, Light{});
    for (int i = 0; i < 5; ++i) {
        schedule.run(world);
    }
    return {world.get<Place>(e).value, world.get<Speed>(e).value, world.get<Light>(e).value};
}

class Trial : public testing::Test {
  protected:
    ~Trial() override {
        shuffle_schedules(0);
        leave_out_system("");
    }
};

TEST_F(Trial, KeepsEveryOrderThatWasAskedForOrFollows) {
    std::set<std::vector<std::string>> orders;
    for (std::uint64_t seed = 0; seed <= kSeeds; ++seed) {
        shuffle_schedules(seed);
        Schedule schedule;
        add_honest_systems(schedule);
        const std::vector<std::string> order = schedule.order();
        const auto at = [&](const char* name) { return std::ranges::find(order, name) - order.begin(); };
        EXPECT_LT(at("speed"), at("move"));
        EXPECT_LT(at("move"), at("age"));
        EXPECT_LT(at("shine"), at("age"));
        orders.insert(order);
        Schedule again;
        add_honest_systems(again);
        EXPECT_EQ(again.order(), order) << seed;
    }
    EXPECT_EQ(orders.size(), 3u);  // "shine" before, between or after the other two
}

TEST_F(Trial, SystemsThatDeclareWhatTheyTouchHaveOneResult) {
    const auto honest = [](Schedule& schedule, World&) { add_honest_systems(schedule); };
    const Outcome usual = run(honest, 0);
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        EXPECT_EQ(run(honest, seed), usual) << seed;
    }
}

TEST_F(Trial, CatchesAReadThatIsNotDeclared) {
    // Looks at Light by way of the world that it keeps: nothing tells the schedule.
    const auto dishonest = [](Schedule& schedule, World& world) {
        add_honest_systems(schedule);
        schedule
            .add("peek",
                 [&world](Query<Write<Place>> things) {
                     things.each([&](Entity e, Place& p) { p.value += world.get<Light>(e).value; });
                 })
            .after("move");
    };
    const Outcome usual = run(dishonest, 0);
    bool caught = false;
    for (std::uint64_t seed = 1; seed <= kSeeds && !caught; ++seed) {
        caught = run(dishonest, seed) != usual;
    }
    EXPECT_TRUE(caught);
}

TEST_F(Trial, ASystemThatIsLeftOutDoesNotRun) {
    Schedule schedule;
    add_honest_systems(schedule);
    World world;
    const Entity e = world.create(Speed{}, Place{}, Light{});
    leave_out_system("shine");
    schedule.run(world);
    EXPECT_EQ(world.get<Light>(e).value, 0);
    EXPECT_EQ(world.get<Place>(e).value, 4);
    leave_out_system("");
    schedule.run(world);
    EXPECT_EQ(world.get<Light>(e).value, 7);
}

}  // namespace
}  // namespace lanthorn::ecs

#include "lanthorn/ecs/schedule.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <atomic>

#include "tests/unit/ecs/components.h"
#include "tests/unit/ecs/expect_error.h"

namespace lanthorn::ecs {
namespace {

using namespace ecs_test;

struct Hit {
    int damage;
};

void move_all(Query<Write<Position>, Read<Velocity>> moving) {
    moving.each([](Position& p, const Velocity& v) { p.x += v.x; });
}

std::size_t place(Schedule& schedule, std::string_view name) {
    const auto order = schedule.order();
    return static_cast<std::size_t>(std::find(order.begin(), order.end(), name) - order.begin());
}

TEST(Schedule, RunsSystemsOverTheirQueries) {
    World world;
    const Entity e = world.create(Position{}, Velocity{1, 0, 0});
    Schedule schedule;
    schedule.add("move", move_all);
    schedule.add("also a lambda",
                 [](const Query<Read<Position>>& q, SystemTicks) { EXPECT_EQ(q.count(), 1u); });
    schedule.run(world);
    schedule.run(world);
    EXPECT_EQ(world.get<Position>(e).x, 2);
}

TEST(Schedule, WritersRunBeforeReaders) {
    Schedule schedule;
    schedule.add("draw", [](Query<Read<Position>>) {});
    schedule.add("move", move_all);
    schedule.add("steer", [](Query<Write<Velocity>>) {});
    EXPECT_EQ(schedule.order(), (std::vector<std::string>{"steer", "move", "draw"}));
}

TEST(Schedule, ExplicitOrderBeatsTheDerivedOne) {
    Schedule schedule;
    schedule.add("look back", [](Query<Read<Position>>) {}).before("between");
    schedule.add("between", [] {}).before("move");
    schedule.add("move", move_all);
    EXPECT_EQ(schedule.order(), (std::vector<std::string>{"look back", "between", "move"}));
}

TEST(Schedule, OrdersByResourcesEventsAndGroups) {
    Schedule schedule;
    schedule.add("sound", [](EventReader<Hit>) {}).in("output");
    schedule.add("fight", [](EventWriter<Hit>, Res<Mass>) {});
    schedule.add("weigh", [](ResMut<Mass>) {}).skip_if_empty(false);
    schedule.add("flush", [] {}).after("output");
    EXPECT_LT(place(schedule, "weigh"), place(schedule, "fight"));
    EXPECT_LT(place(schedule, "fight"), place(schedule, "sound"));
    EXPECT_LT(place(schedule, "sound"), place(schedule, "flush"));
}

TEST(Schedule, AGroupMayBeEmpty) {
    Schedule schedule;
    schedule.add_group("gameplay");
    schedule.add_sync_point("begin").before("gameplay");
    schedule.add_sync_point("end").after("gameplay");
    EXPECT_EQ(schedule.order(), (std::vector<std::string>{"begin", "end"}));
    schedule.add("last", [] {}).after("end");
    schedule.add("play", [] {}).in("gameplay");
    EXPECT_EQ(schedule.order(), (std::vector<std::string>{"begin", "play", "end", "last"}));
}

TEST(Schedule, RefusesCyclesByName) {
    Schedule schedule("game");
    schedule.add("a", [] {}).after("c");
    schedule.add("b", [] {}).after("a");
    schedule.add("c", [] {}).after("b");
    schedule.add("bystander", [] {}).after("c");
    EXPECT_ECS_ERROR(schedule.build(), "game: cycle: ");
    EXPECT_ECS_ERROR(schedule.build(), "-> 'b' (after)");
    EXPECT_ECS_ERROR(schedule.build(), "-> 'a' (after)");

    Schedule itself;
    itself.add("a", [] {}).after("a");
    EXPECT_ECS_ERROR(itself.build(), "cycle: 'a' -> 'a'");
}

TEST(Schedule, RefusesDerivedCyclesWithTheirReason) {
    Schedule schedule;
    schedule.add("a", [](Query<Write<Position>, Read<Velocity>>) {});
    schedule.add("b", [](Query<Write<Velocity>, Read<Mass>>) {});
    schedule.add("c", [](Query<Write<Mass>, Read<Position>>) {});
    EXPECT_ECS_ERROR(schedule.build(), "(writes component ecs_test::Position)");
}

TEST(Schedule, RefusesWritersWithoutOrder) {
    Schedule schedule("game");
    schedule.add("walk", move_all);
    schedule.add("fly", [](Query<Write<Position>>) {});
    EXPECT_ECS_ERROR(schedule.build(),
                     "game: systems 'walk' and 'fly' both write component ecs_test::Position");

    Schedule mutual;
    mutual.add("a", [](Query<Write<Position>, Read<Velocity>>) {});
    mutual.add("b", [](Query<Write<Velocity>, Read<Position>>) {});
    EXPECT_ECS_ERROR(mutual.build(), "'a' writes component ecs_test::Position that 'b' reads");

    Schedule resources;
    resources.add("a", [](ResMut<Mass>) {});
    resources.add("b", [](ResMut<Mass>) {});
    EXPECT_ECS_ERROR(resources.build(), "both write resource ecs_test::Mass");

    Schedule events;
    events.add("a", [](EventWriter<Hit>) {});
    events.add("b", [](EventWriter<Hit>) {});
    EXPECT_ECS_ERROR(events.build(), "both write events");

    Schedule hidden;
    hidden.add("a", [] {}).writes<Position>();
    hidden.add("b", [] {}).writes<Position>();
    EXPECT_ECS_ERROR(hidden.build(), "both write component ecs_test::Position");
}

TEST(Schedule, AcceptsWritersThatAreOrderedOrDisjoint) {
    Schedule ordered;
    ordered.add("walk", move_all).before("between");
    ordered.add("between", [] {});
    ordered.add("fly", [](Query<Write<Position>>) {}).after("between");
    ordered.build();

    Schedule disjoint;
    disjoint.add("thaw", [](Query<Write<Position>, With<Frozen>>) {});
    disjoint.add("walk", [](Query<Write<Position>, Without<Frozen>>) {});
    disjoint.build();

    Schedule optional;  // Optional<Frozen> does not make disjoint
    optional.add("thaw", [](Query<Write<Position>, Optional<Read<Frozen>>>) {});
    optional.add("walk", [](Query<Write<Position>, Without<Frozen>>) {});
    EXPECT_ECS_ERROR(optional.build(), "both write");
}

TEST(Schedule, RefusesUnknownAndDoubleNames) {
    Schedule schedule;
    schedule.add("a", [] {}).after("nobody");
    EXPECT_ECS_ERROR(schedule.build(), "system 'a' is to run before or after 'nobody'");
    EXPECT_ECS_ERROR(schedule.add("a", [] {}), "there already is a system 'a'");
}

TEST(Schedule, SkipsSystemsWhoseQueryIsEmpty) {
    World world;
    int lone = 0, with_more = 0, always = 0, told = 0;
    Schedule schedule;
    schedule.add("lone", [&](Query<Read<Position>>) { ++lone; });
    schedule.add("with more", [&](Query<Read<Position>>, SystemTicks) { ++with_more; });
    schedule.add("always", [&](Query<Read<Position>>) { ++always; }).skip_if_empty(false);
    schedule.add("told", [&](Query<Read<Position>>, Query<Read<Mass>>) { ++told; }).skip_if_empty();
    schedule.run(world);
    EXPECT_EQ((std::array{lone, with_more, always, told}), (std::array{0, 1, 1, 0}));
    EXPECT_FALSE(schedule.report()[place(schedule, "lone")].ran);
    world.create(Position{});
    schedule.run(world);
    EXPECT_EQ((std::array{lone, with_more, always, told}), (std::array{1, 2, 2, 0}));
    EXPECT_TRUE(schedule.report()[place(schedule, "lone")].ran);
    world.create(Mass{});
    schedule.run(world);
    EXPECT_EQ(told, 1);
}

TEST(Schedule, SystemsSeeChangesSinceTheirLastRun) {
    World world;
    const Entity e = world.create(Position{}, Velocity{});
    world.create(Position{});
    std::vector<std::size_t> seen;
    bool do_write = false;
    Schedule schedule;
    schedule.add("early", [&](Query<Changed<Position>> q) { seen.push_back(q.count()); })
        .before("write")
        .skip_if_empty(false);
    schedule.add("write", [&](Query<Mut<Position>, With<Velocity>> q) {
        if (do_write) {
            q.each([](MutRef<Position> p) { p.write().x += 1; });
        }
    });
    const auto run = [&] {
        seen.clear();
        schedule.run(world);
        return seen.front();
    };
    EXPECT_EQ(run(), 2u);
    EXPECT_EQ(run(), 0u);
    do_write = true;
    EXPECT_EQ(run(), 0u);  // written after it ran
    do_write = false;
    EXPECT_EQ(run(), 1u);  // seen now, once
    EXPECT_EQ(run(), 0u);
    world.get_mut<Position>(e).x = 5;  // between runs
    EXPECT_EQ(run(), 1u);
    EXPECT_EQ(run(), 0u);
}

TEST(Schedule, ResourcesTellIfTheyChanged) {
    World world;
    world.insert_resource(Mass{1});
    std::vector<bool> changed;
    bool do_write = false;
    Schedule schedule;
    schedule.add("write", [&](ResMut<Mass> mass) {
        if (do_write) {
            mass->kg += 1;
        }
    });
    schedule.add("read", [&](Res<Mass> mass) { changed.push_back(mass.changed()); });
    schedule.run(world);
    schedule.run(world);
    do_write = true;
    schedule.run(world);
    do_write = false;
    schedule.run(world);
    EXPECT_EQ(changed, (std::vector{true, false, true, false}));
    EXPECT_EQ(world.resource<Mass>().kg, 2);
}

TEST(Schedule, MissingResourceNamesTheSystem) {
    World world;
    Schedule schedule;
    schedule.add("weigh", [](Res<Mass>) {});
    EXPECT_ECS_ERROR(schedule.run(world), "system 'weigh' needs a resource of type ecs_test::Mass");
}

TEST(Schedule, EventsReachReadersOnce) {
    World world;
    int sum = 0;
    std::size_t count = 0;
    Schedule schedule;
    schedule.add("write", [n = 0](EventWriter<Hit> hits) mutable { hits.send({++n}); });
    schedule.add("read", [&](EventReader<Hit> hits) {
        hits.each([&](const Hit& hit) {
            sum += hit.damage;
            ++count;
        });
    });
    schedule.add("read before", [&](EventReader<Hit> hits) { hits.each([&](const Hit&) { ++count; }); })
        .before("write");
    for (int i = 0; i < 4; ++i) {
        schedule.run(world);
    }
    EXPECT_EQ(sum, 1 + 2 + 3 + 4);
    EXPECT_EQ(count, 4u + 3u);
}

TEST(Schedule, CommandsAreAppliedAtSyncPointsAndTheEnd) {
    World world;
    std::size_t before = 9, after = 9;
    Schedule schedule;
    schedule.add("make", [](Commands& commands) { commands.create(Position{}); });
    schedule.add("not yet", [&](Query<Read<Position>> q) { before = q.count(); })
        .after("make")
        .before("sync")
        .skip_if_empty(false);
    schedule.add_sync_point("sync");
    schedule.add("now", [&](Query<Read<Position>> q, Commands& commands) {
        after = q.count();
        q.each([&](Entity e, const Position&) { commands.destroy(e); });
    });
    schedule.run(world);
    EXPECT_EQ(before, 0u);
    EXPECT_EQ(after, 1u);
    EXPECT_EQ(world.size(), 0u);
}

TEST(Schedule, SystemsWithTheWorldRunAloneInTheOrderOfAdding) {
    World world;
    world.create(Position{});
    std::vector<std::string> log;
    Schedule schedule;
    schedule.add("a", [&](Query<Write<Position>>) { log.push_back("a"); });
    schedule.add("alone", [&](World& w) {
        log.push_back("alone");
        w.create(Mass{});
    });
    schedule.add("b", [&](Query<Read<Mass>> q) { log.push_back("b" + std::to_string(q.count())); });
    schedule.add("early", [&](World&) { log.push_back("early"); }).before("a");
    schedule.run(world);
    EXPECT_EQ(log, (std::vector<std::string>{"early", "a", "alone", "b1"}));
}

TEST(Schedule, ErrorsOfDeferredCommandsNameTheSystem) {
    World world;
    const Entity e = world.create(Position{});
    Schedule schedule;
    schedule.add("kill", [e](Commands& c) { c.destroy(e); });
    schedule.add("kill again", [e](Commands& c) { c.destroy(e); }).after("kill");
    EXPECT_ECS_ERROR(schedule.run(world),
                     "commands of system 'kill again': destroy: entity 0v1 is not alive");
}

TEST(Schedule, ExceptionsComeOutAndTheScheduleStaysUsable) {
    for (const int threads : {1, 4}) {
        World world;
        bool fail = true;
        Schedule schedule;
        schedule.set_threads(threads);
        schedule.add("make", [](Commands& c) { c.create(Counted(1)); });
        schedule
            .add("fail",
                 [&] {
                     if (fail) {
                         throw std::runtime_error("from a system");
                     }
                 })
            .after("make");
        schedule.add("other", [] {});
        EXPECT_THROW(schedule.run(world), std::runtime_error);
        EXPECT_EQ(world.size(), 0u);
        EXPECT_FALSE(world.locked());
        fail = false;
        schedule.run(world);
        EXPECT_EQ(world.size(), 1u);
    }
}

TEST(Schedule, StructureIsLockedWhileSystemsRun) {
    World world;
    Schedule schedule;
    schedule.add("cheat", [&world] { world.create(); });
    EXPECT_ECS_ERROR(schedule.run(world), "while a query iterates or systems run");
}

TEST(Schedule, MayOutliveAndChangeItsWorld) {
    Schedule schedule;
    std::size_t found = 0;
    schedule.add("find", [&](Query<Changed<Position>> q, Commands& c) {
        found = q.count();
        c.create(Position{});
    });
    for (int i = 0; i < 3; ++i) {
        World world;
        world.create(Position{});
        schedule.run(world);
        EXPECT_EQ(found, 1u);
        schedule.run(world);
        EXPECT_EQ(found, 1u);
        EXPECT_EQ(world.size(), 3u);
    }
}

TEST(Schedule, PrintsItselfAsDot) {
    Schedule schedule("say \"hi\"");
    schedule.add("draw", [](Query<Read<Position>>) {}).after("tick");
    schedule.add("move", move_all);
    schedule.add("tick", [](Commands&) {});
    const std::string dot = schedule.to_dot();
    EXPECT_EQ(dot.find("digraph \"say \\\"hi\\\"\" {"), 0u);
    EXPECT_NE(
        dot.find(
            "[label=\"1 move\\nreads component ecs_test::Velocity\\nwrites component ecs_test::Position\"]"),
        std::string::npos)
        << dot;
    EXPECT_NE(dot.find("n1 -> n0 [label=\"writes component ecs_test::Position\", style=dashed]"),
              std::string::npos)
        << dot;
    EXPECT_NE(dot.find("n2 -> n0 [label=\"after\"]"), std::string::npos) << dot;
}

// Many systems that create, destroy and write; every number in the world must be equal for any thread count.
std::vector<std::uint64_t> simulate(int threads) {
    struct Age {
        std::uint32_t steps = 0;
    };
    // More threads than cores, too.
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(std::max(threads, 2)));
    World world;
    world.create_many(3000, Position{1, 2, 3}, Velocity{1, 0, 0});
    Schedule schedule;
    schedule.set_threads(threads);
    for (int i = 0; i < 12; ++i) {
        // More than a page at times, so that the pools run dry.
        schedule.add("spawn " + std::to_string(i), [i, step = 0](Commands& commands) mutable {
            const int count = ++step % 4 == 0 ? 2500 : 30 + i;
            for (int k = 0; k < count; ++k) {
                const Entity e = commands.create(Position{static_cast<float>(i), static_cast<float>(k), 0});
                if (k % 3 == 0) {
                    commands.add(e, Age{});
                }
            }
        });
    }
    schedule.add("move", [](Query<Write<Position>, Read<Velocity>> q) {
        q.parallel_each([](Position& p, const Velocity& v) { p.x += v.x; });
    });
    schedule.add("age", [](Query<Write<Age>> q, Commands& commands) {
        q.each([&](Entity e, Age& age) {
            if (++age.steps == 3) {
                commands.remove<Age>(e);
            }
            if (age.steps == 2 && e.index % 2) {
                commands.destroy(e);
            }
        });
    });
    schedule
        .add("cull",
             [](Query<Read<Position>, Without<Velocity, Age>> q, Commands& commands) {
                 q.each([&](Entity e, const Position& p) {
                     if (e.index % 3) {
                         commands.destroy_if_alive(e);
                     }
                     if (p.y > 1000) {
                         commands.destroy_if_alive(e);
                     }
                 });
             })
        .after("age");
    for (int step = 0; step < 12; ++step) {
        schedule.run(world);
    }
    std::vector<std::uint64_t> numbers;
    world.query<Read<Position>, Optional<Read<Age>>>().each([&](Entity e, const Position& p, const Age* age) {
        numbers.push_back(e.bits());
        numbers.push_back(static_cast<std::uint64_t>(p.x * 1e6f) + static_cast<std::uint64_t>(p.y));
        numbers.push_back(age ? age->steps + 1 : 0);
    });
    return numbers;
}

TEST(Schedule, ResultIsTheSameForAnyNumberOfThreads) {
    const std::vector<std::uint64_t> one = simulate(1);
    EXPECT_GT(one.size(), 9000u);
    for (const int threads : {2, 3, 8}) {
        EXPECT_TRUE(simulate(threads) == one) << threads << " threads";
    }
    EXPECT_TRUE(simulate(0) == one);
}

TEST(Schedule, NumbersDoNotGrowWhileTheirEntitiesComeAndGo) {
    World world;
    Schedule schedule;
    schedule.add("spawn", [](Commands& c) {
        for (int i = 0; i < 5000; ++i) {
            c.create(Position{});
        }
    });
    schedule.add("cull", [](Query<Read<Position>> q, Commands& c) {
        q.each([&](Entity e, const Position&) { c.destroy(e); });
    });
    std::uint32_t highest = 0;
    for (int i = 0; i < 100; ++i) {
        schedule.run(world);
        world.query<Read<Position>>().each(
            [&](Entity e, const Position&) { highest = std::max(highest, e.index); });
    }
    EXPECT_LT(highest, 40000u);
}

}  // namespace
}  // namespace lanthorn::ecs

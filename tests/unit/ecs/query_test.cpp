#include "lanthorn/ecs/query.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "tests/unit/ecs/components.h"
#include "tests/unit/ecs/expect_error.h"

namespace lanthorn::ecs {
namespace {

using namespace ecs_test;

TEST(Query, VisitsWhatHasAllComponents) {
    World world;
    for (int i = 0; i < 10000; ++i) {
        const auto x = static_cast<float>(i);
        switch (i % 3) {
            case 0:
                world.create(Position{x, 0, 0});
                break;
            case 1:
                world.create(Position{x, 0, 0}, Velocity{1, 0, 0});
                break;
            case 2:
                world.create(Position{x, 0, 0}, Velocity{1, 0, 0}, Frozen{});
                break;
        }
    }
    EXPECT_EQ((world.query<Read<Position>>().count()), 10000u);
    EXPECT_EQ((world.query<Read<Position>, Read<Velocity>>().count()), 6666u);
    EXPECT_EQ((world.query<Read<Position>, Without<Velocity>>().count()), 3334u);
    EXPECT_EQ((world.query<With<Velocity>, Without<Frozen>>().count()), 3333u);
    EXPECT_EQ((world.query<With<Velocity, Frozen>>().count()), 3333u);
    EXPECT_TRUE((world.query<Read<Mass>>().empty()));

    double before = 0, after = 0;
    world.query<Read<Position>>().each([&](const Position& p) { before += p.x; });
    world.query<Write<Position>, Read<Velocity>, Without<Frozen>>().each(
        [](Position& p, const Velocity& v) { p.x += v.x; });
    std::size_t visited = 0;
    world.query<Read<Position>>().each([&](Entity e, const Position& p) {
        after += p.x;
        visited += world.alive(e);
    });
    EXPECT_EQ(after, before + 3333);
    EXPECT_EQ(visited, 10000u);
}

TEST(Query, OptionalIsNullWhereMissing) {
    World world;
    const Entity a = world.create(Position{}, Mass{5});
    const Entity b = world.create(Position{});
    std::size_t with = 0, without = 0;
    world.query<Read<Position>, Optional<Read<Mass>>>().each(
        [&](Entity e, const Position&, const Mass* mass) {
            if (mass) {
                EXPECT_EQ(e, a);
                EXPECT_EQ(mass->kg, 5);
                ++with;
            } else {
                EXPECT_EQ(e, b);
                ++without;
            }
        });
    EXPECT_EQ(with, 1u);
    EXPECT_EQ(without, 1u);
    const Tick mark = world.mark();
    world.query<Optional<Write<Mass>>>().each([](Mass* mass) {
        if (mass) {
            mass->kg = 6;
        }
    });
    EXPECT_TRUE(world.changed<Mass>(a, mark));
    EXPECT_EQ(world.get<Mass>(a).kg, 6);
}

TEST(Query, ChunksAreSpansThatCoverEverything) {
    World world;
    std::set<Entity> expected;
    for (int i = 0; i < 5000; ++i) {
        expected.insert(world.create(Position{static_cast<float>(i), 0, 0}, Velocity{}));
    }
    std::set<Entity> seen;
    std::size_t calls = 0;
    world.query<Write<Position>, Read<Velocity>, Optional<Read<Mass>>>().each_chunk(
        [&](std::span<const Entity> entities, std::span<Position> p, std::span<const Velocity> v,
            std::span<const Mass> m) {
            EXPECT_EQ(entities.size(), p.size());
            EXPECT_EQ(p.size(), v.size());
            EXPECT_TRUE(m.empty());
            seen.insert(entities.begin(), entities.end());
            ++calls;
        });
    EXPECT_EQ(seen, expected);
    EXPECT_GT(calls, 1u);
    std::size_t rows = 0;
    world.query<Read<Position>>().each_chunk([&](std::span<const Position> p) { rows += p.size(); });
    EXPECT_EQ(rows, 5000u);
}

TEST(Query, ParallelEachVisitsEachRowOnce) {
    World world;
    world.create_many(100000, Position{});
    world.create_many(50000, Position{}, Frozen{});
    world.query<Write<Position>>().parallel_each([](Position& p) { p.x += 1; });
    std::size_t wrong = 0;
    world.query<Read<Position>>().each([&](const Position& p) { wrong += p.x != 1; });
    EXPECT_EQ(wrong, 0u);
}

TEST(Query, ChangedSeesWritesSinceTheTick) {
    World world;
    std::vector<Entity> all;
    for (int i = 0; i < 4000; ++i) {
        all.push_back(world.create(Position{}, Velocity{}));
    }
    Tick mark = world.mark();
    const auto changed = [&] { return world.query<With<Position>, Changed<Position>>(mark).entities(); };
    EXPECT_TRUE(changed().empty());
    world.get_mut<Position>(all[17]).x = 1;
    world.get_mut<Position>(all[3999]).x = 1;
    world.get_mut<Velocity>(all[5]).x = 1;
    EXPECT_EQ(changed(), (std::vector{all[17], all[3999]}));
    EXPECT_EQ((world.query<Changed<Position, Velocity>>(mark).count()), 3u);
    EXPECT_EQ((world.query<Changed<Position>, Changed<Velocity>>(mark).count()), 0u);

    // Reading changes nothing; Write changes all it visits; Mut only what is written.
    mark = world.mark();
    world.query<Read<Position>>().each([](const Position&) {});
    world.query<Mut<Position>>().each([](const MutRef<Position>& p) {
        if (p->x == 1) {
            p.write().y = 2;
        }
    });
    EXPECT_EQ(changed(), (std::vector{all[17], all[3999]}));
    mark = world.mark();
    world.query<Mut<Position>>().each([](const MutRef<Position>& p) { p.set_if_different({1, 2, 0}); });
    EXPECT_EQ(changed().size(), 3998u);
    mark = world.mark();
    world.query<Write<Position>>().each([](Position&) {});
    EXPECT_EQ(changed().size(), 4000u);
}

TEST(Query, WriteBehindAFilterMarksOnlyWhatPasses) {
    World world;
    std::vector<Entity> all;
    for (int i = 0; i < 100; ++i) {
        all.push_back(world.create(Position{}, Velocity{}));
    }
    const Tick first = world.mark();
    world.get_mut<Velocity>(all[3]).x = 1;
    const Tick second = world.mark();
    world.query<Write<Position>, Changed<Velocity>>(first).each([](Position& p) { p.x = 1; });
    EXPECT_EQ((world.query<Changed<Position>>(second).entities()), (std::vector{all[3]}));
}

TEST(Query, TicksFollowRowsThroughTables) {
    World world;
    std::vector<Entity> all;
    for (int i = 0; i < 3000; ++i) {
        all.push_back(world.create(Position{}));
    }
    const Tick mark = world.mark();
    world.add(all[1], Velocity{});  // moves a row, fills its hole
    EXPECT_EQ((world.query<Changed<Position>>(mark).count()), 0u);
    EXPECT_EQ((world.query<Added<Velocity>>(mark).entities()), (std::vector{all[1]}));
    // A bulk write, then old rows arrive: they stay old.
    world.query<Write<Position>, With<Velocity>>().each([](Position&) {});
    const Tick later = world.mark();
    world.query<Write<Position>, With<Velocity>>().each([](Position&) {});
    world.add(all[2], Velocity{});
    EXPECT_EQ((world.query<Changed<Position>>(later).entities()), (std::vector{all[1]}));
    EXPECT_FALSE(world.changed<Position>(all[2], mark));
    EXPECT_EQ((world.query<Added<Velocity>>(later).entities()), (std::vector{all[2]}));
    EXPECT_EQ((world.query<Added<Position>>(mark).count()), 0u);
}

TEST(Query, TicksSurviveARebase) {
    World world;
    const Entity old = world.create(Position{});
    for (int i = 0; i < 100; ++i) {
        world.mark();
    }
    const Tick mark = world.mark();
    const Entity fresh = world.create(Position{});
    world.rebase_ticks(mark - 10);
    EXPECT_EQ((world.query<Changed<Position>>(mark).entities()), (std::vector{fresh}));
    EXPECT_EQ((world.query<Changed<Position>>(mark - 5).count()), 1u);
    // Who last looked before the base sees everything: nothing is missed.
    EXPECT_EQ((world.query<Changed<Position>>(1).count()), 2u);
    world.get_mut<Position>(old).x = 1;
    EXPECT_EQ((world.query<Changed<Position>>(mark).count()), 2u);
}

TEST(Query, RandomAccess) {
    World world;
    const Entity a = world.create(Position{1, 2, 3}, Velocity{4, 5, 6});
    const Entity b = world.create(Position{});
    const auto query = world.query<Write<Position>, Read<Velocity>>();
    auto [p, v] = query.get(a);
    p.x = v.x;
    EXPECT_EQ(world.get<Position>(a).x, 4);
    EXPECT_TRUE(query.contains(a));
    EXPECT_FALSE(query.contains(b));
    EXPECT_ECS_ERROR(query.get(b),
                     "entity 1v1 does not match <Write<ecs_test::Position>, Read<ecs_test::Velocity>>");
    world.destroy(b);
    EXPECT_ECS_ERROR(query.get(b), "entity 1v1 is not alive");
}

TEST(Query, SingleWantsExactlyOne) {
    World world;
    EXPECT_ECS_ERROR((world.query<Read<Mass>>().single()), "expected exactly one entity, found 0");
    world.create(Mass{3});
    EXPECT_EQ(std::get<0>(world.query<Read<Mass>>().single()).kg, 3);
    world.create(Mass{4});
    EXPECT_ECS_ERROR((world.query<Read<Mass>>().single()),
                     "<Read<ecs_test::Mass>>: expected exactly one entity, found 2");
}

TEST(Query, StructureIsLockedWhileIterating) {
    World world;
    const Entity e = world.create(Position{});
    const auto inside = [&](auto&& action) {
        world.query<Read<Position>>().each([&](const Position&) { action(); });
    };
    EXPECT_ECS_ERROR(inside([&] { world.create(); }), "cannot create an entity while a query iterates");
    EXPECT_ECS_ERROR(inside([&] { world.destroy(e); }), "cannot destroy an entity");
    EXPECT_ECS_ERROR(inside([&] { world.add(e, Mass{}); }), "cannot add a component");
    EXPECT_ECS_ERROR(inside([&] { world.remove<Position>(e); }), "cannot remove a component");
    EXPECT_ECS_ERROR(inside([&] { world.insert_resource(1); }), "cannot insert a resource");
    world.create();  // the lock ended with the exception
    EXPECT_EQ(world.size(), 2u);
}

}  // namespace
}  // namespace lanthorn::ecs

#include "lanthorn/ecs/kept_query.h"

#include <gtest/gtest.h>

#include <utility>

#include "tests/unit/ecs/components.h"

namespace lanthorn::ecs {
namespace {

using namespace ecs_test;

template <class... Terms>
concept AskedOfAConstWorld = requires(const World& world) {
    world.query<Terms...>();
};
template <class... Terms>
concept KeptForAConstWorld = requires(KeptQuery<Terms...> kept, const World& world) {
    kept.in(world);
};

static_assert(AskedOfAConstWorld<Read<Position>, With<Mass>, Without<Frozen>, Optional<Read<Velocity>>>);
static_assert(AskedOfAConstWorld<Changed<Position>, Added<Mass>>);
static_assert(!AskedOfAConstWorld<Write<Position>>);
static_assert(!AskedOfAConstWorld<Mut<Position>>);
static_assert(!AskedOfAConstWorld<Read<Position>, Optional<Write<Velocity>>>);
static_assert(KeptForAConstWorld<Read<Position>>);
static_assert(!KeptForAConstWorld<Mut<Position>>);

TEST(ConstWorld, AnswersQueriesThatOnlyRead) {
    World world;
    const Entity e = world.create(Position{1, 2, 3}, Velocity{});
    world.create(Position{4, 5, 6}, Frozen{});
    const World& looked_at = world;
    float sum = 0;
    looked_at.query<Read<Position>>().each([&](const Position& p) { sum += p.x; });
    EXPECT_EQ(sum, 5);
    EXPECT_EQ((looked_at.query<With<Position>, Without<Frozen>>().single_entity()), e);
    const Tick since = world.mark();
    EXPECT_TRUE(looked_at.query<Changed<Position>>(since).empty());
    world.get_mut<Position>(e).x = 2;
    EXPECT_EQ(looked_at.query<Changed<Position>>(since).count(), 1u);
    looked_at.query<Read<Position>>().each([&](const Position&) { EXPECT_TRUE(world.locked()); });
}

TEST(KeptQuery, FindsTablesMadeAfterItsFirstUse) {
    World world;
    KeptQuery<Write<Position>> kept;
    EXPECT_EQ(kept.in(world).count(), 0u);
    world.create(Position{});
    EXPECT_EQ(kept.in(world).count(), 1u);
    world.create(Position{}, Velocity{});
    kept.in(world).each([](Position& p) { p.x += 1; });
    EXPECT_EQ(kept.in(world).count(), 2u);
    world.query<Read<Position>>().each([](const Position& p) { EXPECT_EQ(p.x, 1); });
}

TEST(KeptQuery, ComparesWithTheTickThatItIsGiven) {
    World world;
    const Entity e = world.create(Position{});
    world.create(Position{});
    KeptQuery<Changed<Position>> kept;
    EXPECT_EQ(kept.in(world).count(), 2u);
    const Tick since = world.mark();
    EXPECT_EQ(kept.in(world, since).count(), 0u);
    world.get_mut<Position>(e).x = 1;
    EXPECT_EQ(kept.in(std::as_const(world), since).single_entity(), e);
}

TEST(KeptQuery, DatesItsWritesWithThePresent) {
    World world;
    world.create(Position{});
    KeptQuery<Write<Position>> kept;
    kept.in(world);
    const Tick since = world.mark();
    kept.in(world).each([](Position& p) { p.x += 1; });
    EXPECT_EQ(world.query<Changed<Position>>(since).count(), 1u);
}

TEST(KeptQuery, ForgetsOneWorldForAnother) {
    KeptQuery<Read<Position>> kept;
    for (std::size_t n = 1; n < 4; ++n) {
        World world;
        world.create(Mass{});
        world.create_many(n, Position{});
        EXPECT_EQ(kept.in(world).count(), n);
    }
}

}  // namespace
}  // namespace lanthorn::ecs

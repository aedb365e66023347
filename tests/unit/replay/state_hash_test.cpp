#include "lanthorn/replay/state_hash.h"

#include <gtest/gtest.h>

#include <vector>

namespace lanthorn::replay {
namespace {

struct Door {
    char kind = 0;  // padding follows
    double angle = 0;
};
struct Marker {};

WorldHasher door_hasher() {
    WorldHasher hasher;
    hasher.component<Door>("door", [](StateHash& h, const Door& d) { h.add_all(d.kind, d.angle); });
    return hasher;
}

TEST(StateHash, IsXxh3OfTheBytes) {
    // XXH3_64bits of no bytes with seed 0, from xxHash's own test vectors.
    EXPECT_EQ(hash_bytes({}), 0x2d06800538d394c2ull);
}

TEST(StateHash, TellsValuesAndTheirOrderApart) {
    StateHash ab, ba, negative_zero, zero;
    ab.add_all(1.0f, 2.0f);
    ba.add_all(2.0f, 1.0f);
    EXPECT_NE(ab.value(), ba.value());
    negative_zero.add(-0.0);
    zero.add(0.0);
    EXPECT_NE(negative_zero.value(), zero.value());
}

TEST(WorldHasher, DependsOnStateAndNotOnStorageOrder) {
    const WorldHasher hasher = door_hasher();
    ecs::World one, other;
    const ecs::Entity a = one.create(Door{1, 0.5});
    one.create(Door{2, 0.25});
    // The same entities and values, but the rows have moved through another table and back.
    const ecs::Entity x = other.create(Door{1, 0.5});
    other.create(Door{2, 0.25});
    other.add(x, Marker{});
    other.remove<Marker>(x);
    EXPECT_EQ(hasher.hash(one), hasher.hash(other));

    one.get_mut<Door>(a).angle = std::nextafter(0.5, 1.0);
    EXPECT_NE(hasher.hash(one), hasher.hash(other));
}

TEST(WorldHasher, IgnoresPadding) {
    const WorldHasher hasher = door_hasher();
    ecs::World one, other;
    alignas(Door) unsigned char dirty[sizeof(Door)];
    std::fill(std::begin(dirty), std::end(dirty), static_cast<unsigned char>(0xaa));
    auto* door = new (dirty) Door{1, 0.5};
    one.create(*door);
    other.create(Door{1, 0.5});
    EXPECT_EQ(hasher.hash(one), hasher.hash(other));
}

TEST(WorldHasher, TellsEntitiesApart) {
    const WorldHasher hasher = door_hasher();
    ecs::World one, other;
    one.create(Door{1, 0.5});
    other.create();
    other.create(Door{1, 0.5});
    EXPECT_NE(hasher.hash(one), hasher.hash(other));
}

}  // namespace
}  // namespace lanthorn::replay

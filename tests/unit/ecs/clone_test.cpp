#include "lanthorn/ecs/clone.h"

#include <gtest/gtest.h>

#include "tests/unit/ecs/declared.h"

namespace lanthorn::ecs {
namespace {

using test::Door;
using test::Keys;

TEST(Clone, ReferencesAmongTheOriginalsAreAmongTheCopies) {
    Registry registry;
    test::declare(registry);
    World world;
    const Entity keeper = world.create();
    Door door;
    door.keeper = keeper;
    door.tags = {"oak"};
    const Entity hall = world.create(door);
    const Entity ring = world.create(Keys{{hall, keeper, kNullEntity}, 3});
    const std::vector<Entity> originals = {hall, ring};
    const std::vector<Entity> copies = clone(world, registry, originals);
    ASSERT_EQ(copies.size(), 2u);
    EXPECT_EQ(world.get<Door>(copies[0]).keeper, keeper);
    EXPECT_EQ(world.get<Door>(copies[0]).tags, std::vector<std::string>{"oak"});
    EXPECT_EQ(world.get<Keys>(copies[1]).opens, (std::vector<Entity>{copies[0], keeper, kNullEntity}));
    EXPECT_EQ(world.get<Keys>(ring).opens[0], hall);

    World level;
    const std::vector<Entity> there = clone_from(level, world, registry, originals);
    EXPECT_EQ(level.get<Keys>(there[1]).opens, (std::vector<Entity>{there[0], kNullEntity, kNullEntity}));
    EXPECT_EQ(level.get<Door>(there[0]).keeper, kNullEntity);
    EXPECT_THROW(clone_from(level, world, registry, std::vector<Entity>{Entity{99, 1}}), Error);
}

}  // namespace
}  // namespace lanthorn::ecs

#include "lanthorn/ecs/snapshot.h"

#include <gtest/gtest.h>

#include <cstring>

#include "lanthorn/ecs/query.h"
#include "lanthorn/ecs/world_hash.h"
#include "tests/unit/ecs/declared.h"

namespace lanthorn::ecs {
namespace {

using test::Clock;
using test::Door;
using test::Keys;
using test::line_of;

// Not to be looked into.
class Handle {
  public:
    explicit Handle(std::shared_ptr<int> value) : value_(std::move(value)) {}
    bool operator==(const Handle&) const = default;
    int use() const { return *value_; }

  private:
    std::shared_ptr<int> value_;
};
struct Secret {};

class SnapshotOfAWorld : public testing::Test {
  protected:
    SnapshotOfAWorld() {
        test::declare(registry);
        registry.opaque_component<Handle>("handle", "");
        world.insert_resource(Clock{7});
        for (int i = 0; i < 3000; ++i) {
            Door door;
            door.angle = static_cast<float>(i);
            door.tags = {"door " + std::to_string(i) + ", long enough for the heap"};
            doors.push_back(world.create(door));
        }
        for (int i = 0; i < 100; ++i) {
            world.add(doors[static_cast<std::size_t>(i)], Keys{{doors[0]}, static_cast<std::uint64_t>(i)});
        }
        handled = world.create(Handle(std::make_shared<int>(5)), Keys{});
        world.destroy(doors[10]);
        world.destroy(doors[20]);
    }
    void disturb() {
        world.get_mut<Door>(doors[1]).angle = -1;
        world.destroy(doors[2]);
        world.create(Door{});
        world.create(Keys{});
        world.create();
        world.remove<Keys>(doors[5]);
        world.add(doors[2000], Keys{{}, 9});
        world.resource_mut<Clock>().step = 99;
        world.destroy(handled);
    }
    std::vector<std::uint64_t> hashes() const { return state_hashes(registry, world); }
    // Entities in the order of a query's visit, and what the next ones will be.
    std::vector<Entity> order() {
        std::vector<Entity> all = world.query<Read<Door>>().entities();
        const std::vector<Entity> keys = world.query<Read<Keys>>().entities();
        all.insert(all.end(), keys.begin(), keys.end());
        for (int i = 0; i < 4; ++i) {
            all.push_back(world.create());
        }
        for (int i = 0; i < 4; ++i) {
            world.destroy(all[all.size() - 1 - static_cast<std::size_t>(i)]);
        }
        return all;
    }

    Registry registry;
    World world;
    std::vector<Entity> doors;
    Entity handled;
};

TEST_F(SnapshotOfAWorld, RestoresBitForBit) {
    const std::vector<std::uint64_t> before = hashes();
    const Snapshot snapshot = Snapshot::save(world, registry);
    EXPECT_EQ(snapshot.size(), world.size());
    const std::size_t size = world.size();
    const Snapshot first = Snapshot::save(world, registry);
    first.restore(world);
    const std::vector<Entity> entities = order();
    snapshot.restore(world);
    disturb();
    EXPECT_NE(hashes(), before);
    snapshot.restore(world);
    EXPECT_EQ(hashes(), before);
    EXPECT_EQ(world.size(), size);
    EXPECT_EQ(order(), entities);
    EXPECT_TRUE(world.alive(doors[2]));
    EXPECT_FALSE(world.alive(doors[10]));
    EXPECT_EQ(world.get<Handle>(handled).use(), 5);
    EXPECT_EQ(world.resource<Clock>().step, 7u);
    EXPECT_EQ(world.get<Door>(doors[2]).tags[0], "door 2, long enough for the heap");
}

TEST_F(SnapshotOfAWorld, WhatDiffersCountsAsChangedAndNothingElse) {
    const Snapshot snapshot = Snapshot::save(world, registry);
    world.mark();
    disturb();
    const Tick before = world.mark();
    const Entity extra = world.create(Keys{});
    snapshot.restore(world);
    EXPECT_EQ((world.query<With<Door>, Changed<Door>>(before).entities()),
              (std::vector<Entity>{doors[1], doors[2]}));
    EXPECT_TRUE(world.added<Door>(doors[2], before));
    EXPECT_FALSE(world.added<Door>(doors[1], before));
    EXPECT_TRUE(world.added<Keys>(doors[5], before));
    EXPECT_FALSE(world.changed<Keys>(doors[6], before));
    EXPECT_TRUE(world.changed<Handle>(handled, before));
    EXPECT_TRUE(world.resource_changed<Clock>(before));
    EXPECT_FALSE(world.alive(extra));
    EXPECT_FALSE(world.has<Keys>(doors[2000]));

    const Tick then = world.mark();
    snapshot.restore(world);
    EXPECT_TRUE((world.query<Changed<Door>>(then).empty()));
    EXPECT_TRUE((world.query<Changed<Handle>>(then).empty()));
    EXPECT_FALSE(world.resource_changed<Clock>(then));
}

TEST_F(SnapshotOfAWorld, BytesSayTheSame) {
    const std::vector<std::uint64_t> before = hashes();
    const std::string bytes = Snapshot::save(world, registry).to_bytes();
    disturb();
    world.get_mut<Door>(doors[1]).angle = 4;
    Snapshot::from_bytes(bytes, registry, "save").restore(world);
    EXPECT_EQ(hashes(), before);
    EXPECT_EQ(Snapshot::save(world, registry).to_bytes(), bytes);
    EXPECT_FALSE(world.has<Handle>(handled)) << "it died, and bytes cannot hold it";
    world.add(handled, Handle(std::make_shared<int>(8)));
    Snapshot::from_bytes(bytes, registry, "save").restore(world);
    EXPECT_EQ(world.get<Handle>(handled).use(), 8) << "it lives on, and keeps what it has";

    World empty;
    Snapshot::from_bytes(bytes, registry, "save").restore(empty);
    EXPECT_EQ(state_hashes(registry, empty), before);
}

TEST_F(SnapshotOfAWorld, BytesHoldTablesThatDifferByOpaqueComponentsAlone) {
    for (int i = 500; i < 1500; ++i) {
        world.add(doors[static_cast<std::size_t>(i)], Handle(std::make_shared<int>(i)));
    }
    const std::vector<std::uint64_t> before = hashes();
    const std::string bytes = Snapshot::save(world, registry).to_bytes();
    disturb();
    Snapshot::from_bytes(bytes, registry, "save").restore(world);
    EXPECT_EQ(hashes(), before);
    for (int i = 500; i < 1500; ++i) {
        EXPECT_EQ(world.get<Handle>(doors[static_cast<std::size_t>(i)]).use(), i);
        EXPECT_EQ(world.get<Door>(doors[static_cast<std::size_t>(i)]).angle, static_cast<float>(i));
    }
}

TEST_F(SnapshotOfAWorld, OtherFormsAndVersionsAreRefused) {
    std::string bytes = Snapshot::save(world, registry).to_bytes();
    const auto refusal = [&](std::string_view text, const Registry& by) {
        return line_of([&] { Snapshot::from_bytes(text, by, "a.save"); });
    };
    EXPECT_EQ(refusal("", registry), "a.save: is no snapshot, expected one that Lanthorn wrote");
    std::string newer = bytes;
    newer[8] = 9;
    EXPECT_EQ(refusal(newer, registry), "a.save: is a snapshot of version 9, expected version 2");
    const std::string damaged = "a.save: is a damaged snapshot, expected it as it was written";
    EXPECT_EQ(refusal(std::string_view(bytes).substr(0, bytes.size() - 1), registry), damaged);
    bytes[bytes.size() / 2] = static_cast<char>(~bytes[bytes.size() / 2]);
    EXPECT_EQ(refusal(bytes, registry), damaged);
}

TEST_F(SnapshotOfAWorld, WhatIsNotDeclaredIsNamed) {
    const Entity e = world.create(Secret{});
    const std::string line = line_of([&] { Snapshot::save(world, registry); });
    EXPECT_NE(line.find("Secret of " + to_string(e) + " is not declared"), std::string::npos) << line;
    EXPECT_NE(line_of([&] { hashes(); }).find("Secret"), std::string::npos);
}

TEST_F(SnapshotOfAWorld, IsNotRestoredWhileAQueryIterates) {
    const Snapshot snapshot = Snapshot::save(world, registry);
    world.query<Read<Keys>>().each([&](const Keys&) {
        EXPECT_NE(line_of([&] { snapshot.restore(world); }).find("cannot restore a snapshot"),
                  std::string::npos);
    });
}

}  // namespace
}  // namespace lanthorn::ecs

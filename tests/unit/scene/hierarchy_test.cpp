#include "lanthorn/scene/hierarchy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "engine/scene/declare_components.h"
#include "lanthorn/ecs/clone.h"
#include "lanthorn/ecs/commands.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/ecs/snapshot.h"
#include "lanthorn/scene/components.h"
#include "tests/unit/ecs/expect_error.h"

namespace lanthorn {
namespace {

using ecs::Entity;
using ecs::World;
using List = std::vector<Entity>;

List children(const World& world, Entity e) {
    const auto list = children_of(world, e);
    return {list.begin(), list.end()};
}

// Every Parent of a living entity is in its Children, once, and nothing else is.
void expect_sound(const World& world) {
    std::size_t listed = 0, fixed = 0;
    world.query<ecs::Read<Children>>().each([&](Entity e, const Children& list) {
        for (const Entity child : list.entities) {
            ++listed;
            EXPECT_EQ(parent_of(world, child), e);
        }
    });
    world.query<ecs::Read<Parent>>().each([&](Entity e, const Parent& parent) {
        if (world.alive(parent.entity)) {
            ++fixed;
            const auto list = children_of(world, parent.entity);
            EXPECT_EQ(std::count(list.begin(), list.end(), e), 1);
        }
    });
    EXPECT_EQ(listed, fixed);
}

static_assert(!std::is_assignable_v<decltype((std::declval<Parent&>().entity)), Entity>,
              "Children could not follow");

TEST(Hierarchy, ChildrenFollowEveryWayOfGivingAParent) {
    World world;
    const Entity a = world.create(), b = world.create(Name{"b"});
    const Entity one = world.create(Parent{a});
    const Entity two = world.create();
    world.add(two, Parent{a});
    const Entity three = world.create();
    world.insert(three, Parent{a});
    const Entity four = world.create();
    set_parent(world, four, a);
    EXPECT_EQ(children(world, a), (List{one, two, three, four}));
    EXPECT_EQ(parent_of(world, two), a);
    EXPECT_EQ(parent_of(world, a), ecs::kNullEntity);

    world.insert(two, Parent{b});
    set_parent(world, one, b);
    EXPECT_EQ(children(world, a), (List{three, four}));
    EXPECT_EQ(children(world, b), (List{two, one}));
    world.remove<Parent>(two);
    detach(world, one);
    detach(world, one);
    set_parent(world, three, ecs::kNullEntity);
    EXPECT_EQ(children(world, a), List{four});
    EXPECT_TRUE(children(world, b).empty());
    EXPECT_FALSE(world.has<Parent>(three));
    world.destroy(four);
    EXPECT_TRUE(children(world, a).empty());
    expect_sound(world);
}

TEST(Hierarchy, CommandsKeepItToo) {
    World world;
    ecs::Commands commands(world);
    const Entity parent = commands.create();
    const Entity first = commands.create(Parent{parent});
    const Entity second = commands.create();
    commands.add(second, Parent{parent});
    commands.apply();
    EXPECT_EQ(children(world, parent), (List{first, second}));
    commands.destroy(first);
    commands.apply();
    EXPECT_EQ(children(world, parent), List{second});

    const Entity late = world.create();
    const Entity not_yet = commands.create();
    EXPECT_ECS_ERROR(world.add(late, Parent{not_yet}), "is still to be created");
    EXPECT_FALSE(world.has<Parent>(late));
}

TEST(Hierarchy, AParentDestroyedAloneLeavesItsChildrenAsRoots) {
    World world;
    const Entity root = world.create();
    const Entity middle = world.create(Parent{root});
    const Entity a = world.create(Parent{middle}), b = world.create(Parent{middle});
    const Entity leaf = world.create(Parent{a});
    world.destroy(middle);
    EXPECT_TRUE(children(world, root).empty());
    EXPECT_FALSE(world.has<Parent>(a));
    EXPECT_FALSE(world.has<Parent>(b));
    EXPECT_EQ(children(world, a), List{leaf});
    world.remove<Children>(a);
    EXPECT_FALSE(world.has<Parent>(leaf));
    expect_sound(world);
}

TEST(Hierarchy, ADeadParentCountsAsNone) {
    World world;
    const Entity gone = world.create();
    world.destroy(gone);
    const Entity e = world.create(Parent{gone});
    const Entity f = world.create(Parent{});
    EXPECT_EQ(parent_of(world, e), ecs::kNullEntity);
    EXPECT_EQ(parent_of(world, f), ecs::kNullEntity);
    EXPECT_TRUE(children_of(world, gone).empty());
    EXPECT_ECS_ERROR(set_parent(world, e, gone), "set_parent: entity 0v1 is not alive");
    EXPECT_ECS_ERROR(detach(world, gone), "is not alive");
    world.destroy(e);
    expect_sound(world);
}

TEST(Hierarchy, CyclesAreRefusedByNameAndChangeNothing) {
    World world;
    const Entity a = world.create(Name{"a"});
    const Entity b = world.create(Name{"b"}, Parent{a});
    const Entity c = world.create(Name{"c"}, Parent{b});
    EXPECT_ECS_ERROR(
        world.add(a, Parent{c}),
        "parent: cycle: entity 0v1 'a' is below entity 2v1 'c', which is below entity 1v1 'b', which is "
        "below entity 0v1 'a'");
    EXPECT_ECS_ERROR(set_parent(world, b, b), "parent: cycle: entity 1v1 'b' is below entity 1v1 'b'");
    EXPECT_ECS_ERROR(set_parent(world, b, c), "cycle");
    EXPECT_FALSE(world.has<Parent>(a));
    EXPECT_EQ(parent_of(world, b), a);
    expect_sound(world);
}

TEST(Hierarchy, SiblingsKeepTheirOrderAndCanBeMoved) {
    World world;
    const Entity root = world.create();
    List list;
    for (int i = 0; i < 4; ++i) {
        list.push_back(world.create(Parent{root}));
    }
    move_child(world, list[3], 0);
    EXPECT_EQ(children(world, root), (List{list[3], list[0], list[1], list[2]}));
    move_child(world, list[3], 2);
    EXPECT_EQ(children(world, root), (List{list[0], list[1], list[3], list[2]}));
    move_child(world, list[0], 99);
    EXPECT_EQ(children(world, root), (List{list[1], list[3], list[2], list[0]}));
    EXPECT_ECS_ERROR(move_child(world, root, 0), "has no parent");
    // Giving the same parent again moves it to the end.
    set_parent(world, list[1], root);
    EXPECT_EQ(children(world, root), (List{list[3], list[2], list[0], list[1]}));
}

TEST(Hierarchy, ChildrenCanBeOrderedAnewButNotInvented) {
    World world, other;
    const Entity root = world.create();
    const Entity a = world.create(Parent{root}), b = world.create(Parent{root});
    // As restoring a snapshot does: the parents first, in whatever order, then the lists.
    const Entity root2 = other.create();
    other.create();
    other.create();
    other.add(b, Parent{root2});
    other.add(a, Parent{root2});
    ASSERT_EQ(children(other, root2), (List{b, a}));
    other.insert(root2, world.get<Children>(root));
    EXPECT_EQ(children(other, root2), (List{a, b}));
    EXPECT_EQ(parent_of(other, a), root2);
    expect_sound(other);
    EXPECT_ECS_ERROR(other.insert(a, world.get<Children>(root)), "cannot be given");
    EXPECT_ECS_ERROR(other.insert(root2, Children{}), "cannot be given");
}

TEST(Hierarchy, ClonesAndStoredSnapshotsHaveTheirChildren) {
    ecs::Registry registry;
    declare_scene_components(registry);
    World world;
    const Entity root = world.create(Name{"root"});
    const Entity a = world.create(Parent{root}), b = world.create(Parent{root});
    const Entity leaf = world.create(Parent{a});
    move_child(world, b, 0);

    const std::string bytes = ecs::Snapshot::save(world, registry).to_bytes();
    World restored;
    ecs::Snapshot::from_bytes(bytes, registry, "test").restore(restored);
    EXPECT_EQ(children(restored, root), (List{b, a}));
    expect_sound(restored);
    destroy_tree(restored, a);
    EXPECT_FALSE(restored.alive(leaf));

    const List copies = ecs::clone(world, registry, std::vector{root, b, a, leaf});
    EXPECT_EQ(children(world, copies[0]), (List{copies[1], copies[2]}));
    EXPECT_EQ(children(world, copies[2]), List{copies[3]});
    // Of a part of a tree: another child of the same parent.
    const List twin = ecs::clone(world, registry, std::vector{a});
    EXPECT_EQ(children(world, root), (List{b, a, twin[0]}));
    EXPECT_TRUE(children(world, twin[0]).empty());
    expect_sound(world);
}

TEST(Hierarchy, WalksGoDepthFirst) {
    World world;
    const Entity root = world.create();
    const Entity a = world.create(Parent{root}), b = world.create(Parent{root});
    const Entity a1 = world.create(Parent{a}), a2 = world.create(Parent{a}), b1 = world.create(Parent{b});
    List seen;
    for_each_child(world, root, [&](Entity e) { seen.push_back(e); });
    EXPECT_EQ(seen, (List{a, b}));
    seen.clear();
    for_each_descendant(world, root, [&](Entity e) { seen.push_back(e); });
    EXPECT_EQ(seen, (List{a, a1, a2, b, b1}));
    EXPECT_TRUE(is_within(world, b1, root));
    EXPECT_TRUE(is_within(world, b, b));
    EXPECT_FALSE(is_within(world, b1, a));
    EXPECT_TRUE(descendants(world, b1).empty());
    EXPECT_TRUE(descendants(world, ecs::kNullEntity).empty());
}

TEST(Hierarchy, DestroyTreeTakesWhatIsBelowAndNothingElse) {
    World world;
    const Entity root = world.create();
    const Entity a = world.create(Parent{root});
    world.create(Parent{a});
    world.create(Parent{a});
    const Entity other = world.create(Parent{root});
    destroy_tree(world, a);
    EXPECT_EQ(world.size(), 2u);
    EXPECT_EQ(children(world, root), List{other});
    EXPECT_ECS_ERROR(destroy_tree(world, a), "is not alive");
    destroy_tree(world, root);
    EXPECT_EQ(world.size(), 0u);
}

TEST(Hierarchy, ClearEmptiesAnyTree) {
    World world;
    const Entity root = world.create();
    for (int i = 0; i < 50; ++i) {
        world.create(Parent{world.create(Parent{root})});
    }
    world.clear();
    EXPECT_EQ(world.size(), 0u);
}

// What it costs shows in its size: 200 000 leaves of one parent, gone in the order of their making and at
// once.
TEST(Hierarchy, WideAndDeepTreesAreBuiltAndDestroyed) {
    World world;
    const Entity wide = world.create();
    for (int i = 0; i < 200'000; ++i) {
        world.create(Parent{wide});
    }
    Entity deep = world.create();
    const Entity top = deep;
    for (int i = 0; i < 50'000; ++i) {
        deep = world.create(Parent{deep});
    }
    destroy_tree(world, wide);
    EXPECT_EQ(descendants(world, top).size(), 50'000u);
    destroy_tree(world, top);
    EXPECT_EQ(world.size(), 0u);
}

TEST(Hierarchy, StaysSoundUnderRandomEdits) {
    std::mt19937 random(7);
    World world;
    for (int step = 0; step < 3000; ++step) {
        List all = world.query<ecs::With<Name>>().entities();
        const auto any = [&] { return all[random() % all.size()]; };
        switch (all.size() < 20 ? 0 : random() % 7) {
            case 0:
            case 1:
                all.push_back(world.create(Name{}, Parent{all.empty() ? ecs::kNullEntity : any()}));
                break;
            case 2: {
                const Entity child = any(), parent = any();
                if (!is_within(world, parent, child)) {
                    set_parent(world, child, parent);
                }
                break;
            }
            case 3:
                detach(world, any());
                break;
            case 4:
                world.destroy(any());
                break;
            case 5:
                if (step % 10 == 0) {
                    destroy_tree(world, any());
                }
                break;
            case 6:
                if (const Entity e = any(); world.has<Children>(e)) {
                    world.remove<Children>(e);
                }
                break;
        }
        if (step % 50 == 0) {
            expect_sound(world);
        }
    }
    expect_sound(world);
}

}  // namespace
}  // namespace lanthorn

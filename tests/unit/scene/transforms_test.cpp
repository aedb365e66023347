#include "lanthorn/scene/transforms.h"

#include <gtest/gtest.h>

#include <random>

#include "lanthorn/ecs/query.h"
#include "lanthorn/ecs/schedule.h"

namespace lanthorn {
namespace {

using ecs::Entity;
using ecs::World;

Transform at(double x, double y, double z) {
    Transform t;
    t.translation = {x, y, z};
    return t;
}

dvec3 place(const World& world, Entity e) {
    return dvec3(world.get<WorldTransform>(e).matrix[3]);
}

TEST(Transforms, FollowTheHierarchy) {
    World world;
    Transforms transforms;
    Transform turned = at(1, 0, 0);
    turned.rotation = glm::angleAxis(kPi / 2, vec3(0, 1, 0));
    turned.scale = vec3(2);
    const Entity root = world.create(LocalTransform{turned});
    const Entity child = world.create(LocalTransform{at(0, 0, 3)}, Parent{root});
    const Entity grandchild = world.create(LocalTransform{at(0, 1, 0)}, Parent{child});
    EXPECT_EQ(transforms.update(world), 3u);
    EXPECT_NEAR(glm::distance(place(world, child), dvec3(7, 0, 0)), 0, 1e-6);
    EXPECT_NEAR(glm::distance(place(world, grandchild), dvec3(7, 2, 0)), 0, 1e-6);
}

TEST(Transforms, RecomputeOnlyWhatIsBelowAChange) {
    World world;
    Transforms transforms;
    std::vector<Entity> roots, leaves;
    for (int i = 0; i < 100; ++i) {
        const Entity root = world.create(LocalTransform{at(i, 0, 0)});
        const Entity arm = world.create(LocalTransform{at(0, 1, 0)}, Parent{root});
        for (int k = 0; k < 8; ++k) {
            leaves.push_back(world.create(LocalTransform{at(0, 0, k)}, Parent{arm}));
        }
        roots.push_back(root);
    }
    for (int i = 0; i < 50; ++i) {
        world.create(LocalTransform{at(0, i, 0)});
    }
    EXPECT_EQ(transforms.update(world), 1050u);
    EXPECT_EQ(transforms.update(world), 0u);
    world.get_mut<LocalTransform>(roots[42]).value.translation.y = 5;
    EXPECT_EQ(transforms.update(world), 10u);
    EXPECT_EQ(place(world, leaves[42 * 8 + 7]), dvec3(42, 6, 7));
    world.get_mut<LocalTransform>(leaves[3]).value.translation.x = 9;
    EXPECT_EQ(transforms.update(world), 1u);
    // A child of what is recomputed anyway is not recomputed twice.
    world.get_mut<LocalTransform>(roots[7]).value.translation.y = 1;
    world.get_mut<LocalTransform>(leaves[7 * 8]).value.translation.x = 1;
    EXPECT_EQ(transforms.update(world), 10u);
    EXPECT_EQ(place(world, leaves[7 * 8]), dvec3(8, 2, 0));
    EXPECT_EQ(transforms.update(world), 0u);
}

TEST(Transforms, AWriteThatChangesNothingLeavesTheWorldTransformUnchanged) {
    World world;
    Transforms transforms;
    const Entity e = world.create(LocalTransform{at(1, 2, 3)});
    transforms.update(world);
    const ecs::Tick mark = world.mark();
    world.get_mut<LocalTransform>(e);
    EXPECT_EQ(transforms.update(world), 1u);
    EXPECT_FALSE(world.changed<WorldTransform>(e, mark));
    world.get_mut<LocalTransform>(e).value.translation.x = 0;
    transforms.update(world);
    EXPECT_TRUE(world.changed<WorldTransform>(e, mark));
}

TEST(Transforms, ReparentingAndOrphaning) {
    World world;
    Transforms transforms;
    const Entity a = world.create(LocalTransform{at(1, 0, 0)});
    const Entity b = world.create(LocalTransform{at(0, 1, 0)});
    const Entity child = world.create(LocalTransform{at(0, 0, 1)}, Parent{a});
    transforms.update(world);
    EXPECT_EQ(place(world, child), dvec3(1, 0, 1));
    world.insert(child, Parent{b});
    transforms.update(world);
    EXPECT_EQ(place(world, child), dvec3(0, 1, 1));
    world.remove<Parent>(child);
    transforms.update(world);
    EXPECT_EQ(place(world, child), dvec3(0, 0, 1));
    world.add(child, Shear{mat3(2)});
    transforms.update(world);
    EXPECT_EQ(world.get<WorldTransform>(child).matrix[0][0], 2);
    world.remove<Shear>(child);
    transforms.update(world);
    EXPECT_EQ(world.get<WorldTransform>(child).matrix[0][0], 1);
}

TEST(Transforms, ChildrenOfADestroyedParentStandWhereTheirOwnTransformSays) {
    World world;
    Transforms transforms;
    const Entity a = world.create(LocalTransform{at(1, 0, 0)});
    const Entity b = world.create(LocalTransform{at(0, 1, 0)}, Parent{a});
    const Entity c = world.create(LocalTransform{at(0, 0, 1)}, Parent{b});
    const Entity other = world.create(LocalTransform{at(0, 0, 5)}, Parent{a});
    transforms.update(world);
    world.destroy(a);
    EXPECT_EQ(transforms.update(world), 3u);
    EXPECT_EQ(place(world, b), dvec3(0, 1, 0));
    EXPECT_EQ(place(world, c), dvec3(0, 1, 1));
    EXPECT_EQ(place(world, other), dvec3(0, 0, 5));
    EXPECT_EQ(transforms.update(world), 0u);
    world.get_mut<LocalTransform>(b).value.translation.x = 7;
    EXPECT_EQ(transforms.update(world), 2u);
    EXPECT_EQ(place(world, c), dvec3(7, 1, 1));
}

TEST(Transforms, AParentThatIsDeadOrHasNoTransformCountsAsNone) {
    World world;
    Transforms transforms;
    const Entity gone = world.create();
    world.destroy(gone);
    const Entity plain = world.create(Name{"plain"});
    const Entity a = world.create(LocalTransform{at(1, 0, 0)}, Parent{gone});
    const Entity b = world.create(LocalTransform{at(2, 0, 0)}, Parent{plain});
    const Entity c = world.create(LocalTransform{at(0, 1, 0)}, Parent{b});
    transforms.update(world);
    EXPECT_EQ(place(world, a), dvec3(1, 0, 0));
    EXPECT_EQ(place(world, b), dvec3(2, 0, 0));
    EXPECT_EQ(place(world, c), dvec3(2, 1, 0));
    world.add(plain, LocalTransform{at(0, 0, 3)});
    transforms.update(world);
    EXPECT_EQ(place(world, c), dvec3(2, 1, 3));
    // One loses it in the step in which another gains it.
    world.remove<LocalTransform>(b);
    world.remove<LocalTransform>(plain);
    world.add(b, LocalTransform{at(4, 0, 0)});
    transforms.update(world);
    EXPECT_EQ(place(world, b), dvec3(4, 0, 0));
    EXPECT_EQ(place(world, c), dvec3(4, 1, 0));
}

TEST(Transforms, ANewParentMovesOnlyWhatIsBelowIt) {
    World world;
    Transforms transforms;
    const Entity a = world.create(LocalTransform{at(1, 0, 0)});
    for (int i = 0; i < 50; ++i) {
        world.create(LocalTransform{at(0, 0, i)}, Parent{a});
    }
    const Entity b = world.create(LocalTransform{at(0, 1, 0)}, Parent{a});
    const Entity leaf = world.create(LocalTransform{at(0, 0, 1)}, Parent{b});
    transforms.update(world);
    set_parent(world, b, world.create(LocalTransform{at(0, 0, 9)}));
    EXPECT_EQ(transforms.update(world), 3u);  // the new root too
    EXPECT_EQ(place(world, leaf), dvec3(0, 1, 10));
}

TEST(Transforms, KeepTheirPrecisionFarFromTheOrigin) {
    World world;
    Transforms transforms;
    const Entity root = world.create(LocalTransform{at(1e6, -1e6, 1e6)});
    const Entity child = world.create(LocalTransform{at(1e-4, 0, 0)}, Parent{root});
    transforms.update(world);
    EXPECT_NEAR(place(world, child).x - 1e6, 1e-4, 1e-9);
}

TEST(Transforms, RunAsASystem) {
    World world;
    const Entity root = world.create(LocalTransform{});
    const Entity child = world.create(LocalTransform{at(0, 1, 0)}, Parent{root});
    std::vector<std::size_t> computed, changed;
    ecs::Schedule schedule;
    schedule.add("move", [](ecs::Query<ecs::Write<LocalTransform>, ecs::Without<Parent>> q) {
        q.each([](LocalTransform& t) { t.value.translation.x += 1; });
    });
    schedule.add("transforms", [&, t = Transforms()](World& w) mutable { computed.push_back(t.update(w)); });
    schedule.add("look", [&](ecs::Query<ecs::Changed<WorldTransform>> q) { changed.push_back(q.count()); })
        .skip_if_empty(false);
    for (int i = 0; i < 3; ++i) {
        schedule.run(world);
    }
    EXPECT_EQ(computed, (std::vector<std::size_t>{2, 2, 2}));
    EXPECT_EQ(changed, (std::vector<std::size_t>{2, 2, 2}));
    EXPECT_EQ(place(world, child), dvec3(3, 1, 0));
}

// Random edits against matrices multiplied up the chain of parents.
TEST(Transforms, AgreeWithTheChainOfParentsUnderRandomEdits) {
    std::mt19937 random(3);
    World world;
    Transforms transforms;
    std::vector<Entity> all;
    const auto any = [&] { return all[random() % all.size()]; };
    const auto depth_to = [&](Entity e, Entity goal) {
        for (const Parent* p = world.try_get<Parent>(e); e != goal && p; p = world.try_get<Parent>(e)) {
            e = p->entity;
        }
        return e == goal;
    };
    for (int step = 0; step < 400; ++step) {
        for (int edit = 0; edit < 5; ++edit) {
            const auto number = static_cast<double>(random() % 100);
            switch (all.size() < 30 ? 0 : random() % 5) {
                case 0:
                    all.push_back(world.create(LocalTransform{at(number, 0, 0)}));
                    break;
                case 1:
                    world.get_mut<LocalTransform>(any()).value.translation.y = number;
                    break;
                case 2: {
                    const Entity child = any(), parent = any();
                    if (!depth_to(parent, child)) {
                        world.insert(child, Parent{parent});
                    }
                    break;
                }
                case 3: {
                    const Entity e = any();
                    if (world.has<Parent>(e)) {
                        world.remove<Parent>(e);
                    }
                    break;
                }
                case 4: {
                    const std::size_t i = random() % all.size();
                    world.destroy(all[i]);
                    all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
                    break;
                }
            }
        }
        transforms.update(world);
        for (const Entity e : all) {
            dvec3 expected(0);
            for (Entity up = e;;) {
                expected += world.get<LocalTransform>(up).value.translation;
                const Parent* p = world.try_get<Parent>(up);
                if (!p) {
                    break;
                }
                up = p->entity;
            }
            ASSERT_EQ(place(world, e), expected) << "step " << step;
        }
    }
}

}  // namespace
}  // namespace lanthorn

#include "lanthorn/ecs/query.h"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <random>

#include "tests/unit/ecs/components.h"
#include "tests/unit/ecs/expect_error.h"

namespace lanthorn::ecs {
namespace {

using namespace ecs_test;

TEST(World, CreatesAndDestroys) {
    World world;
    const Entity e = world.create(Position{1, 2, 3}, Frozen{});
    EXPECT_TRUE(world.alive(e));
    EXPECT_EQ(world.get<Position>(e), (Position{1, 2, 3}));
    EXPECT_TRUE(world.has<Frozen>(e));
    EXPECT_FALSE(world.has<Velocity>(e));
    EXPECT_EQ(world.try_get<Velocity>(e), nullptr);
    EXPECT_EQ(world.size(), 1u);
    world.destroy(e);
    EXPECT_FALSE(world.alive(e));
    EXPECT_EQ(world.try_get<Position>(e), nullptr);
    EXPECT_EQ(world.size(), 0u);
}

TEST(World, ReusedIndexHasAnotherGeneration) {
    World world;
    const Entity first = world.create();
    world.destroy(first);
    const Entity second = world.create();
    EXPECT_EQ(first.index, second.index);
    EXPECT_NE(first.generation, second.generation);
    EXPECT_FALSE(world.alive(first));
    EXPECT_TRUE(world.alive(second));
}

TEST(World, NullEntityIsNeverAlive) {
    World world;
    EXPECT_FALSE(world.alive(kNullEntity));
    EXPECT_FALSE(static_cast<bool>(kNullEntity));
    EXPECT_ECS_ERROR(world.get<Position>(kNullEntity), "entity null is not alive");
}

TEST(World, AddRemoveInsertKeepTheOtherComponents) {
    World world;
    const Entity e =
        world.create(Position{1, 0, 0}, Label{"a name that is longer than any small string buffer"});
    const Entity f = world.create(Position{2, 0, 0}, Label{"other"});
    world.add(e, Velocity{4, 5, 6});
    EXPECT_EQ(world.get<Label>(e).text, "a name that is longer than any small string buffer");
    EXPECT_EQ(world.get<Label>(f).text, "other");
    EXPECT_EQ(world.get<Velocity>(e).y, 5);
    world.insert(e, Velocity{7, 8, 9});
    EXPECT_EQ(world.get<Velocity>(e).y, 8);
    world.remove<Label>(e);
    EXPECT_FALSE(world.has<Label>(e));
    EXPECT_EQ(world.get<Position>(e).x, 1);
    EXPECT_EQ(world.get<Velocity>(e).z, 9);
    EXPECT_EQ(world.component_names(e).size(), 2u);
}

TEST(World, CarriesComponentsOfAnyMovableType) {
    Counted::living = 0;
    {
        World world;
        std::vector<Entity> all;
        for (int i = 0; i < 3000; ++i) {
            all.push_back(world.create(Counted(i), Owner{std::make_unique<int>(i)}, Wide{}));
        }
        EXPECT_EQ(Counted::living, 3000);
        for (int i = 0; i < 3000; i += 3) {
            world.destroy(all[static_cast<std::size_t>(i)]);
        }
        EXPECT_EQ(Counted::living, 2000);
        for (int i = 1; i < 3000; i += 3) {
            world.add(all[static_cast<std::size_t>(i)], Enemy{});
        }
        for (int i = 2; i < 3000; i += 3) {
            world.remove<Counted>(all[static_cast<std::size_t>(i)]);
        }
        EXPECT_EQ(Counted::living, 1000);
        for (int i = 1; i < 3000; i += 3) {
            const Entity e = all[static_cast<std::size_t>(i)];
            EXPECT_EQ(world.get<Counted>(e).id, i);
            EXPECT_EQ(*world.get<Owner>(e).value, i);
            EXPECT_EQ(reinterpret_cast<std::uintptr_t>(&world.get<Wide>(e)) % alignof(Wide), 0u);
            world.insert(e, Counted(-i));
            EXPECT_EQ(world.get<Counted>(e).id, -i);
        }
        EXPECT_EQ(Counted::living, 1000);
        world.clear();
        EXPECT_EQ(Counted::living, 0);
        EXPECT_EQ(world.size(), 0u);
        EXPECT_FALSE(world.alive(all[1]));
        world.create(Counted(1));
    }
    EXPECT_EQ(Counted::living, 0);
}

TEST(World, CarriesComponentsLargerThanAChunk) {
    struct Huge {
        std::array<int, 50000> numbers{};
    };
    World world;
    std::vector<Entity> all;
    for (int i = 0; i < 20; ++i) {
        auto huge = std::make_unique<Huge>();
        huge->numbers[49999] = i;
        all.push_back(world.create(std::move(*huge)));
    }
    world.destroy(all[3]);
    EXPECT_EQ(world.get<Huge>(all[19]).numbers[49999], 19);
}

TEST(World, ReferencesIntoTheWorldMayBeAddedFrom) {
    World world;
    const Entity e = world.create(Label{"copied from the row that moves, and long enough for the heap"});
    struct Second {
        Label label;
    };
    world.add(e, Second{world.get<Label>(e)});
    const Entity f = world.create(world.get<Label>(e));
    world.add(f, Second{world.get<Label>(f)});
    EXPECT_EQ(world.get<Second>(f).label.text, world.get<Label>(e).text);
}

TEST(World, CreateManyMakesCopies) {
    World world;
    const std::vector<Entity> all = world.create_many(5000, Position{1, 2, 3}, Label{"x"});
    EXPECT_EQ(all.size(), 5000u);
    EXPECT_EQ(world.size(), 5000u);
    EXPECT_EQ(world.get<Label>(all[4321]).text, "x");
}

TEST(World, MisuseNamesEntityAndComponent) {
    World world;
    const Entity e = world.create(Position{});
    EXPECT_ECS_ERROR(world.get<Velocity>(e), "entity 0v1 has no component ecs_test::Velocity");
    EXPECT_ECS_ERROR(world.get_mut<Velocity>(e), "entity 0v1 has no component ecs_test::Velocity");
    EXPECT_ECS_ERROR(world.remove<Velocity>(e), "entity 0v1 has no component ecs_test::Velocity");
    EXPECT_ECS_ERROR(world.add(e, Position{}), "entity 0v1 already has component ecs_test::Position");
    EXPECT_ECS_ERROR(world.create(Position{}, Position{}), "ecs_test::Position is given twice");
    world.destroy(e);
    EXPECT_ECS_ERROR(world.destroy(e), "destroy: entity 0v1 is not alive");
    EXPECT_ECS_ERROR(world.add(e, Velocity{}), "add: entity 0v1 is not alive");
    EXPECT_ECS_ERROR(world.get<Position>(e), "get: entity 0v1 is not alive");
    EXPECT_ECS_ERROR(world.resource<Mass>(), "no resource of type ecs_test::Mass");
    EXPECT_ECS_ERROR(world.resource_mut<Mass>(), "no resource of type ecs_test::Mass");
    EXPECT_ECS_ERROR(world.remove_resource<Mass>(), "no resource of type ecs_test::Mass");
}

TEST(World, ThrowingCopyLeavesTheWorldAsItWas) {
    struct Thrower {
        Thrower() = default;
        Thrower(const Thrower&) { throw std::runtime_error("copy"); }
        Thrower(Thrower&&) noexcept {}
    };
    World world;
    const Thrower thrower;
    EXPECT_THROW(world.create(Position{}, thrower), std::runtime_error);
    const Entity e = world.create(Position{});
    EXPECT_THROW(world.add(e, thrower), std::runtime_error);
    EXPECT_EQ(world.size(), 1u);
    EXPECT_EQ(world.component_names(e).size(), 1u);
}

TEST(World, ResourcesAreTypedSingletonsWithATick) {
    World world;
    world.insert_resource(Label{"first"});
    EXPECT_EQ(world.resource<Label>().text, "first");
    const Tick mark = world.mark();
    EXPECT_FALSE(world.resource_changed<Label>(mark));
    world.resource_mut<Label>().text = "second";
    EXPECT_TRUE(world.resource_changed<Label>(mark));
    world.insert_resource(Label{"third"});
    EXPECT_EQ(world.resource<Label>().text, "third");
    world.remove_resource<Label>();
    EXPECT_EQ(world.try_resource<Label>(), nullptr);
    EXPECT_FALSE(world.resource_changed<Label>(0));
}

TEST(World, EventsLastTwoUpdatesAndEachReaderHasItsCursor) {
    World world;
    std::uint64_t early = 0, late = 0;
    std::vector<int> seen;
    const auto collect = [&](int i) { seen.push_back(i); };
    world.send(1);
    world.send(2);
    EXPECT_EQ(world.events<int>().read(early, collect), 0u);
    EXPECT_EQ(seen, (std::vector{1, 2}));
    world.update_events();
    world.send(3);
    seen.clear();
    EXPECT_EQ(world.events<int>().unread(early), 1u);
    world.events<int>().read(early, collect);
    EXPECT_EQ(seen, (std::vector{3}));
    seen.clear();
    world.events<int>().read(late, collect);
    EXPECT_EQ(seen, (std::vector{1, 2, 3}));
    world.update_events();
    world.update_events();
    std::uint64_t never = 0;
    EXPECT_EQ(world.events<int>().read(never, collect), 3u);
}

// Every operation against a std::map that does the same.
TEST(World, BehavesLikeAMapUnderRandomOperations) {
    struct Model {
        std::optional<int> number;
        std::optional<std::string> text;
        bool tag = false;
        Tick number_changed = 0, text_changed = 0, number_added = 0;
    };
    std::mt19937 random(7);
    World world;
    std::map<Entity, Model> model;
    std::vector<Entity> dead;
    const auto pick = [&] {
        auto it = model.begin();
        std::advance(it, random() % model.size());
        return it;
    };
    for (int step = 0; step < 20000; ++step) {
        if (step % 7 == 0) {
            world.mark();
        }
        const Tick now = world.now();
        const int value = static_cast<int>(random());
        const std::string text = "text of step " + std::to_string(step);
        switch (random() % 10) {
            case 0:
                model[world.create()] = {};
                break;
            case 1: {
                Model& m = model[world.create(value, Frozen{})];
                m.number = value, m.tag = true, m.number_changed = m.number_added = now;
                break;
            }
            case 2: {
                Model& m = model[world.create(value, text)];
                m.number = value, m.text = text, m.number_changed = m.number_added = m.text_changed = now;
                break;
            }
            default: {
                if (model.empty()) {
                    break;
                }
                const auto it = pick();
                const Entity e = it->first;
                Model& m = it->second;
                switch (random() % 8) {
                    case 0:
                        world.destroy(e);
                        dead.push_back(e);
                        model.erase(it);
                        break;
                    case 1:
                        if (m.number) {
                            EXPECT_THROW(world.add(e, value), Error);
                        } else {
                            world.add(e, value);
                            m.number = value, m.number_changed = m.number_added = now;
                        }
                        break;
                    case 2:
                        if (!m.number) {
                            m.number_added = now;
                        }
                        world.insert(e, value);
                        m.number = value, m.number_changed = now;
                        break;
                    case 3:
                        world.insert(e, text);
                        m.text = text, m.text_changed = now;
                        break;
                    case 4:
                        if (m.text) {
                            world.remove<std::string>(e);
                            m.text.reset();
                        } else {
                            EXPECT_THROW(world.remove<std::string>(e), Error);
                        }
                        break;
                    case 5:
                        if (m.number) {
                            world.get_mut<int>(e) += 1;
                            m.number = *m.number + 1, m.number_changed = now;
                        }
                        break;
                    case 6:
                        if (m.tag) {
                            world.remove<Frozen>(e);
                        } else {
                            world.add(e, Frozen{});
                        }
                        m.tag = !m.tag;
                        break;
                    case 7:
                        if (random() % 20) {
                            break;
                        }
                        // A bulk write of all frozen numbers.
                        world.query<Write<int>, With<Frozen>>().each([](int& n) { n ^= 5; });
                        for (auto& [entity, other] : model) {
                            if (other.number && other.tag) {
                                other.number = *other.number ^ 5, other.number_changed = now;
                            }
                        }
                        break;
                }
            }
        }
        if (step % 500 != 0) {
            continue;
        }
        ASSERT_EQ(world.size(), model.size());
        const Tick since = now > 20 ? now - 20 : 0;
        std::size_t changed = 0;
        for (const auto& [e, m] : model) {
            ASSERT_TRUE(world.alive(e));
            ASSERT_EQ(world.has<int>(e), m.number.has_value());
            ASSERT_EQ(world.has<std::string>(e), m.text.has_value());
            ASSERT_EQ(world.has<Frozen>(e), m.tag);
            if (m.number) {
                ASSERT_EQ(world.get<int>(e), *m.number);
                ASSERT_EQ(world.changed<int>(e, since), m.number_changed > since);
                ASSERT_EQ(world.added<int>(e, since), m.number_added > since);
                changed += m.number_changed > since;
            }
            if (m.text) {
                ASSERT_EQ(world.get<std::string>(e), *m.text);
                ASSERT_EQ(world.changed<std::string>(e, since), m.text_changed > since);
            }
        }
        ASSERT_EQ((world.query<Read<int>, Changed<int>>(since).count()), changed);
        for (const Entity e : dead) {
            ASSERT_FALSE(world.alive(e));
        }
    }
}

}  // namespace
}  // namespace lanthorn::ecs

// A step that begins afresh depends on components alone; and nothing twitches by it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "lanthorn/ecs/snapshot.h"
#include "lanthorn/ecs/world_hash.h"
#include "tests/unit/physics/stage.h"

namespace lanthorn::physics::test {
namespace {

constexpr const char* kCrate = R"({"body": {"type": "dynamic", "size": [1, 1, 1]}})";

// A heap, a platform that carries a crate, and a walker among them.
class Heap : public Stage {
  public:
    Heap() {
        add_floor(0, {1000.25, 0, 0});
        for (int i = 0; i < 20; ++i) {
            crates.push_back(add("crate", kCrate, {1000 + 0.3 * (i % 3), 1 + 1.1 * i, 0.2 * (i % 5)}, nullptr,
                                 glm::angleAxis(0.1f * static_cast<float>(i), vec3(0.6f, 0.8f, 0)),
                                 vec3(1, 1 + 0.1f * static_cast<float>(i % 2), 1)));
        }
        platform = add("platform", R"({"body": {"type": "kinematic", "size": [3, 0.2, 3]}})", {1010, 2, 0});
        rider = add("rider", kCrate, {1010, 2.6, 0});
        walker = add("walker", R"({"character": {}})", {1000, 0, 4});
    }
    // The step `i`, afresh or not.
    std::vector<std::uint64_t> play(int i, bool afresh = false) {
        if (afresh) {
            physics.begin_afresh(world);
        }
        world.get_mut<LocalTransform>(platform).value.translation.x = 1010 + std::sin(0.03 * i);
        world.insert(walker,
                     CharacterInput{{2 * std::cos(0.05 * i), 0, 2 * std::sin(0.05 * i)}, i % 40 == 0});
        transforms.update(world);
        step();
        return ecs::state_hashes(registry, world);
    }

    std::vector<ecs::Entity> crates;
    ecs::Entity platform, rider, walker;
};

TEST(Afresh, AStateThatIsLoadedElsewhereGoesOnToTheBit) {
    for (const int at : {1, 30, 100, 200}) {
        Heap one;
        for (int i = 0; i < at; ++i) {
            one.play(i);
        }
        const std::string state = ecs::Snapshot::save(one.world, one.registry).to_bytes();
        Heap other;  // has not taken a step
        ecs::Snapshot::from_bytes(state, other.registry, "state").restore(other.world);
        Heap used;  // is somewhere else
        for (int i = 0; i < 50; ++i) {
            used.play(3 * i);
        }
        ecs::Snapshot::from_bytes(state, used.registry, "state").restore(used.world);
        for (int i = at; i < at + 60; ++i) {
            const auto expected = one.play(i, i == at);
            ASSERT_EQ(other.play(i, i == at), expected) << "step " << i << " from " << at;
            ASSERT_EQ(used.play(i, i == at), expected) << "step " << i << " from " << at;
        }
    }
}

// Without it the loaded state goes on differently: what the test above proves is no matter of course.
TEST(Afresh, WithoutItAHeapRemembers) {
    Heap one, other;
    for (int i = 0; i < 100; ++i) {
        one.play(i);
    }
    ecs::Snapshot::from_bytes(ecs::Snapshot::save(one.world, one.registry).to_bytes(), other.registry,
                              "state")
        .restore(other.world);
    bool same = true;
    for (int i = 100; i < 160; ++i) {
        same = one.play(i) == other.play(i) && same;
    }
    EXPECT_FALSE(same);
}

// A tower that has settled but is still awake: a step that begins afresh moves no crate by 0.3 mm
// more than a step that does not.
TEST(Afresh, NoCrateTwitches) {
    const auto furthest = [](bool afresh) {
        Stage stage;
        stage.add_floor();
        std::vector<ecs::Entity> tower;
        for (int i = 0; i < 5; ++i) {
            tower.push_back(stage.add("crate", kCrate, {0.03 * i, 0.5 + i, 0}));
        }
        stage.step(70);
        double most = 0;
        for (int i = 0; i < 40; ++i) {
            std::vector<dvec3> before;
            for (const ecs::Entity e : tower) {
                before.push_back(stage.place(e));
            }
            if (afresh && i % 5 == 0) {
                stage.physics.begin_afresh(stage.world);
            }
            stage.step();
            for (std::size_t k = 0; k < tower.size(); ++k) {
                most = std::max(most, glm::distance(stage.place(tower[k]), before[k]));
            }
        }
        EXPECT_NE(stage.motion(tower[4])->rest, BodyRest::asleep);
        return most;
    };
    const double plain = furthest(false), afresh = furthest(true);
    EXPECT_LT(afresh, plain + 3e-4) << plain;
}

// What a moving platform carries stays where it is on it.
TEST(Afresh, ARiderStaysOnItsPlatform) {
    Stage stage;
    const ecs::Entity platform =
        stage.add("platform", R"({"body": {"type": "kinematic", "size": [3, 0.2, 3]}})", {0, 2, 0});
    const ecs::Entity rider = stage.add("rider", kCrate, {0, 2.6, 0});
    const auto aside = [&] { return stage.place(rider).x - stage.place(platform).x; };
    double before = 0, first = 0;
    for (int i = 0; i < 400; ++i) {
        if (i > 60 && i % 50 == 0) {
            before = aside();
            stage.physics.begin_afresh(stage.world);
        }
        stage.world.get_mut<LocalTransform>(platform).value.translation.x = 0.5 * (1 - std::cos(0.02 * i));
        stage.transforms.update(stage.world);
        stage.step();
        first = i == 60 ? aside() : first;
        if (i > 60 && i % 50 == 0) {
            ASSERT_LT(std::abs(aside() - before), 1e-3) << "step " << i;
        }
    }
    EXPECT_LT(std::abs(aside() - first), 0.005);
    EXPECT_GT(stage.place(rider).y, 2.5);
}

TEST(Afresh, WhoSleepsGoesOnSleeping) {
    Stage stage;
    stage.add_floor();
    const ecs::Entity crate = stage.add("crate", kCrate, {0, 0.5, 0});
    stage.step(300);
    ASSERT_EQ(stage.motion(crate)->rest, BodyRest::asleep);
    const BodyMotion before = *stage.motion(crate);
    stage.physics.begin_afresh(stage.world);
    stage.step(10);
    EXPECT_EQ(*stage.motion(crate), before);
}

}  // namespace
}  // namespace lanthorn::physics::test

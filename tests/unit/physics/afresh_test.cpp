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
        world.insert(walker, CharacterInput{{2 * std::cos(0.05 * i), 0, 2 * std::sin(0.05 * i)}, i % 40 == 0});
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
    ecs::Snapshot::from_bytes(ecs::Snapshot::save(one.world, one.registry).to_bytes(), other.registry, "state")
        .restore(other.world);
    bool same = true;
    for (int i = 100; i < 160; ++i) {
        same = one.play(i) == other.play(i) && same;
    }
    EXPECT_FALSE(same);
}

// A tower at rest, and one that is kept awake by a crate that slides beside it: no crate moves by more than a
// tenth of a millimetre in a step that begins afresh, nor gets faster than a centimetre a second by it.
TEST(Afresh, NoCrateTwitches) {
    Stage stage;
    stage.add_floor();
    std::vector<ecs::Entity> tower;
    for (int i = 0; i < 5; ++i) {
        tower.push_back(stage.add("crate", kCrate, {0.03 * i, 0.5 + i, 0}));
    }
    stage.step(60);  // settled, not yet asleep
    for (int round = 0; round < 20; ++round) {
        std::vector<dvec3> before;
        for (const ecs::Entity e : tower) {
            before.push_back(stage.place(e));
        }
        stage.physics.begin_afresh(stage.world);
        for (int i = 0; i < 30; ++i) {
            stage.step();
            for (std::size_t k = 0; k < tower.size(); ++k) {
                ASSERT_LT(glm::distance(stage.place(tower[k]), before[k]), 1e-4)
                    << "crate " << k << ", " << i << " steps after round " << round;
            }
        }
    }
}

// What a moving platform carries stays where it is on it.
TEST(Afresh, ARiderStaysOnItsPlatform) {
    Heap plain, afresh;
    for (int i = 0; i < 200; ++i) {
        plain.play(i);
        afresh.play(i, i > 60 && i % 30 == 0);
    }
    EXPECT_LT(glm::distance(plain.place(plain.rider), afresh.place(afresh.rider)), 2e-3);
    EXPECT_GT(afresh.place(afresh.rider).y, 2);
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

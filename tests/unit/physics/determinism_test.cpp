// The same calls give the same bits, and far from the origin the same as at it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/shapes.h"
#include "tests/unit/physics/stage.h"

namespace lanthorn::physics::test {
namespace {

// A hundred bodies of all shapes that fall on a heap.
std::vector<ecs::Entity> add_pile(Stage& stage, const dvec3& at = dvec3(0)) {
    static const Mesh wedge = support::sphere(vec3(0), 0.3f, 1, false, 0);
    const char* shapes[] = {R"("size": [0.5, 0.5, 0.5])", R"("shape": "sphere", "radius": 0.3)",
                            R"("shape": "capsule", "radius": 0.2, "height": 0.8)", R"("shape": "convex")"};
    stage.add_floor(0, at);
    std::vector<ecs::Entity> pile;
    for (int i = 0; i < 100; ++i) {
        const dvec3 offset(0.37 * (i % 3) + 0.01 * (i % 7), 0.5 + 0.6 * (i / 4),
                           0.41 * (i % 4) - 0.02 * (i % 5));
        pile.push_back(stage.add(fmt::format("body {}", i),
                                 fmt::format(R"({{"body": {{"type": "dynamic", {}}}}})", shapes[i % 4]),
                                 at + offset, &wedge));
    }
    return pile;
}

TEST(Determinism, APileIsTheSameInEveryRun) {
    const auto run = [] {
        Stage stage;
        const auto pile = add_pile(stage);
        stage.step(240);
        return stage.pose(pile);
    };
    const std::vector<double> first = run();
    EXPECT_EQ(first, run());
    // It did fall, and spread.
    EXPECT_LT(first[12 * 99 + 10], 3);
}

TEST(Determinism, AlsoWithBodiesThatComeAndGo) {
    const auto run = [] {
        Stage stage;
        auto pile = add_pile(stage);
        stage.step(60);
        const ecs::Entity late = stage.add(
            "late", R"({"body": {"type": "dynamic", "mass": 5, "size": [1, 1, 1]}})", {0.4, 9, 0.4});
        stage.step(60);
        stage.world.destroy(late);
        stage.world.destroy(pile[17]);
        pile.erase(pile.begin() + 17);
        stage.step(60);
        EXPECT_EQ(stage.physics.body_count(), 100u);
        return stage.pose(pile);
    };
    EXPECT_EQ(run(), run());
}

// Another world was simulated before by the same object: nothing of it is left.
TEST(Determinism, AnotherWorldStartsAfresh) {
    Stage fresh;
    const auto expected_pile = add_pile(fresh);
    fresh.step(120);
    Stage used;
    add_pile(used);
    used.step(45);
    ecs::World other;
    SceneData empty;
    empty.materials.resize(1);
    spawn(other, empty);
    used.physics.step(other);
    EXPECT_EQ(used.physics.body_count(), 0u);
}

// A tower of crates, each a little off the one below: it settles and stays.
std::vector<dvec3> settled_tower(const dvec3& at, double aside) {
    Stage stage;
    stage.add_floor(0, at);
    std::vector<ecs::Entity> tower;
    for (int i = 0; i < 4; ++i) {
        tower.push_back(stage.add(fmt::format("crate {}", i),
                                  R"({"body": {"type": "dynamic", "size": [1, 1, 1]}})",
                                  at + dvec3(aside * i, 0.625 + 1.125 * i, 0)));
    }
    stage.step(180);
    std::vector<dvec3> places;
    for (const ecs::Entity e : tower) {
        places.push_back(stage.place(e) - at);
    }
    return places;
}

// Where places have the same bits after the point so do the results, but for the sum that is written; where
// rounding differs by 1e-12 m, contacts between flat faces magnify it.
TEST(Determinism, TenKilometresAwayIsTheSame) {
    const dvec3 far(1e4, 100, -1e4);
    for (const double aside : {0.125, 0.1}) {
        const auto here = settled_tower(dvec3(0), aside);
        const auto there = settled_tower(far, aside);
        for (std::size_t i = 0; i < here.size(); ++i) {
            EXPECT_LT(glm::distance(here[i], there[i]), aside == 0.125 ? 1e-11 : 0.02) << aside << ", " << i;
        }
    }
}

}  // namespace
}  // namespace lanthorn::physics::test

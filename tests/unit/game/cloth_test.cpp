// Cloths hang, keep their threads' lengths, make way and come to rest.
#include "game/rules/cloth.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "lanthorn/core/error.h"
#include "tests/unit/game/test_level.h"
#include "tools/scene_generator/curtain.h"

namespace lanthorn::game {
namespace {

const dvec3 kDown(0, -9.81, 0);

// 1 m wide and 2 m high, its top row at y = 0, along X, in folds.
Cloth curtain(std::uint32_t columns = 9, std::uint32_t rows = 9) {
    Cloth cloth;
    cloth.columns = columns;
    cloth.rows = rows;
    std::vector<dvec3> points;
    for (std::uint32_t r = 0; r < rows; ++r) {
        for (std::uint32_t c = 0; c < columns; ++c) {
            points.emplace_back(1.0 * c / (columns - 1), -2.0 * r / (rows - 1), c % 2 == 0 ? 0.03 : -0.03);
        }
    }
    start_cloth(cloth, std::move(points));
    return cloth;
}

void steps(Cloth& cloth, int count, const Pillar* player = nullptr) {
    for (int i = 0; i < count; ++i) {
        step_cloth(cloth, kDown, player);
    }
}

TEST(Cloth, HangsFromItsTopRowAndKeepsItsLengths) {
    Cloth cloth = curtain();
    const std::vector<dvec3> before = cloth.points;
    steps(cloth, 300);
    for (std::uint32_t c = 0; c < cloth.columns; ++c) {
        EXPECT_EQ(cloth.points[c], before[c]);
    }
    const std::vector<Thread> threads = cloth_threads(cloth.columns, cloth.rows);
    ASSERT_EQ(threads.size(), cloth.lengths.size());
    for (std::size_t t = 0; t < threads.size(); ++t) {
        if (!threads[t].soft) {
            EXPECT_NEAR(glm::distance(cloth.points[threads[t].a], cloth.points[threads[t].b]),
                        cloth.lengths[t], 0.05 * cloth.lengths[t]);
        }
    }
}

TEST(Cloth, ComesToRestForGood) {
    Cloth cloth = curtain();
    for (std::uint32_t i = cloth.columns; i < cloth.points.size(); ++i) {
        cloth.speeds[i] = {0, 0, 1};
    }
    steps(cloth, 1200);
    EXPECT_FALSE(step_cloth(cloth, kDown, nullptr));
    const Cloth at_rest = cloth;
    steps(cloth, 60);
    EXPECT_EQ(cloth, at_rest);
}

TEST(Cloth, MakesWayAndFallsBack) {
    Cloth cloth = curtain();
    steps(cloth, 600);
    const std::vector<dvec3> rest = cloth.points;
    // Through its middle, at 1.2 m/s.
    Pillar player{{0.5, -2, -1}, 0.28, 1.75};
    double furthest = 0;
    for (int i = 0; i < 100; ++i) {
        player.foot.z += 0.02;
        step_cloth(cloth, kDown, &player);
        for (std::uint32_t p = cloth.columns; p < cloth.points.size(); ++p) {
            const dvec3 at = cloth.points[p] - player.foot;
            const dvec3 axis(0, std::clamp(at.y, 0.28, 1.75 - 0.28), 0);
            EXPECT_GT(glm::distance(at, axis), 0.28);
            furthest = std::max(furthest, cloth.points[p].z);
        }
    }
    EXPECT_GT(furthest, 0.3);
    player.foot.z = 10;
    steps(cloth, 900, &player);
    double off = 0;  // folds may fall another way, on the whole it hangs as before
    for (std::size_t p = 0; p < rest.size(); ++p) {
        off += glm::distance(cloth.points[p], rest[p]) / static_cast<double>(rest.size());
    }
    EXPECT_LT(off, 0.06);
}

TEST(Cloth, AtRestWakesWhenThePlayerComes) {
    Cloth cloth = curtain();
    Pillar player{{0.5, -2, -3}, 0.28, 1.75};
    steps(cloth, 900, &player);
    ASSERT_FALSE(step_cloth(cloth, kDown, &player));
    player.foot.z = -0.3;
    EXPECT_TRUE(step_cloth(cloth, kDown, &player));
    // She stands still: so does it, in the end.
    steps(cloth, 1800, &player);
    EXPECT_FALSE(step_cloth(cloth, kDown, &player));
}

TEST(Cloth, StaysBetweenItsWalls) {
    Cloth cloth = curtain();
    cloth.low = -0.01;
    cloth.high = 1.01;
    Pillar player{{0.4, -2, 0.02}, 0.28, 1.75};
    for (int i = 0; i < 60; ++i) {
        player.foot.x -= 0.005;  // towards the wall
        step_cloth(cloth, kDown, &player);
        for (const dvec3& point : cloth.points) {
            EXPECT_GE(point.x, cloth.low);
            EXPECT_LE(point.x, cloth.high);
        }
    }
}

TEST(Cloth, SaysWhereALookMeetsIt) {
    const Cloth cloth = curtain();
    EXPECT_NEAR(share_before(cloth, {0.5, -1, -1}, {0.5, -1, 1}), 0.5, 0.02);
    EXPECT_NEAR(share_before(cloth, {0.5, -1, 3}, {0.5, -1, -1}), 0.75, 0.02);
    EXPECT_EQ(share_before(cloth, {1.5, -1, -1}, {1.5, -1, 1}), 1);
    EXPECT_EQ(share_before(cloth, {0.5, -1, -1}, {0.5, -1, -0.2}), 1);
}

// Its joints are its points: what the mesh is deformed by.
TEST(Cloth, InALevelIsPushedAsideByWalkingThrough) {
    scene_generator::Builder level = test_level();
    level.scene.nodes[3].extras.clear();  // no door
    const std::uint32_t cloth = scene_generator::curtain_cloth(level, "violet", {0.3f, 0.1f, 0.4f});
    scene_generator::add_curtain(level, "curtain", cloth, {-1.2, 2, -0.45}, -0.5 * double(kPi), 0.9, 1.9, -5,
                                 5);
    Played game(level.scene);
    game.steps(60);
    const dvec3 before = game.place("curtain.8.12");
    game.walk(0.5, 50);
    EXPECT_GT(game.place("player").x, -1.6);
    EXPECT_GT(glm::distance(game.place("curtain.8.12"), before), 0.1);
    EXPECT_EQ(game.place("curtain.0.12"), game.of<Cloth>("curtain").points[12]);
}

TEST(Cloth, WithoutAJointForEachPointIsRefused) {
    scene_generator::Builder level = test_level();
    const std::uint32_t node = level.node("rag", {});
    level.scene.nodes[node].extras = R"({"cloth":{"columns":3,"rows":3}})";
    try {
        Played game(level.scene);
        FAIL() << "it was taken";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("rag"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace lanthorn::game

// What is small or fast stays on the side from which it came.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/shapes.h"
#include "tests/unit/physics/stage.h"

namespace lanthorn::physics::test {
namespace {

constexpr double kGravity = 9.81;
constexpr double kHalf = 40;  // metres: of a floor's edge

enum class Thing { ball, box, turned_box, hull };

// A static floor whose top is at y = 0; one of no thickness is two triangles.
void add_thin_floor(Stage& stage, double thickness, const dvec3& at) {
    static const Mesh sheet =
        support::quad(vec3(-kHalf, 0, kHalf), vec3(2 * kHalf, 0, 0), vec3(0, 0, -2 * kHalf), 0);
    if (thickness > 0) {
        stage.add("floor",
                  fmt::format(R"({{"body": {{"size": [{}, {}, {}]}}}})", 2 * kHalf, thickness, 2 * kHalf),
                  at - dvec3(0, 0.5 * thickness, 0));
    } else {
        stage.add("floor", R"({"body": {"shape": "mesh"}})", at, &sheet);
    }
}

ecs::Entity add_thing(Stage& stage, Thing thing, double size, const dvec3& at) {
    static const Mesh die = support::box(vec3(-0.5f), vec3(0.5f), false, 0);
    const quat turned = thing == Thing::turned_box || thing == Thing::hull
                            ? glm::normalize(quat(0.9f, 0.1f, 0.2f, 0.3f))
                            : quat(1, 0, 0, 0);
    if (thing == Thing::hull) {
        return stage.add("hull", R"({"body": {"type": "dynamic", "shape": "convex"}})", at, &die, turned,
                         vec3(static_cast<float>(size)));
    }
    const std::string shape = thing == Thing::ball
                                  ? fmt::format(R"("shape": "sphere", "radius": {})", 0.5 * size)
                                  : fmt::format(R"("size": [{0}, {0}, {0}])", size);
    return stage.add("thing", fmt::format(R"({{"body": {{"type": "dynamic", {}}}}})", shape), at, nullptr,
                     turned);
}

struct Drop {
    Thing thing;
    double size, thickness, height;
    ecs::Entity entity = ecs::kNullEntity;
    dvec3 floor{0};
};

std::vector<Drop> all_drops() {
    std::vector<Drop> drops;
    for (const Thing thing : {Thing::ball, Thing::box, Thing::turned_box, Thing::hull}) {
        for (const double size : {0.01, 0.02, 0.04, 0.1, 0.3}) {
            for (const double thickness : {0.0, 0.001, 0.01, 0.02, 0.1, 0.3}) {
                for (const double height : {0.1, 1.0, 3.3, 8.0, 20.0, 50.0}) {
                    drops.push_back({thing, size, thickness, height});
                }
            }
        }
    }
    return drops;
}

// The same drops in one world, each on a floor of its own, until the last has lain for a second.
std::vector<double> run(std::vector<Drop>& drops) {
    Stage stage;
    std::vector<ecs::Entity> things;
    for (std::size_t i = 0; i < drops.size(); ++i) {
        Drop& d = drops[i];
        d.floor = dvec3(100.0 * static_cast<double>(i % 32), 0, 100.0 * static_cast<double>(i / 32));
        add_thin_floor(stage, d.thickness, d.floor);
        d.entity = add_thing(stage, d.thing, d.size, d.floor + dvec3(0.013, d.height + d.size, 0.017));
        things.push_back(d.entity);
    }
    stage.step(480);
    EXPECT_TRUE(stage.warnings().empty());
    std::size_t still = 0;
    for (const Drop& d : drops) {
        const dvec3 place = stage.place(d.entity) - d.floor;
        const std::string what = fmt::format("thing {} of {} m from {} m on {} m", static_cast<int>(d.thing),
                                             d.size, d.height, d.thickness);
        const bool lies = glm::length(stage.motion(d.entity)->linear) < 0.05;
        still += lies ? 1 : 0;
        EXPECT_GT(place.y, (lies ? 0.44 : 0.25) * d.size) << what;
        EXPECT_LT(place.y, (lies ? 0.9 : 4) * d.size) << what;  // were it on a corner; or it still tumbles
        EXPECT_LT(std::max(std::abs(place.x), std::abs(place.z)), kHalf) << what;
    }
    EXPECT_GT(still, drops.size() * 9 / 10);
    return stage.pose(things);
}

TEST(Continuous, WhatFallsLiesOnFloorsOfAnyThicknessTheSameInEveryRun) {
    std::vector<Drop> drops = all_drops();
    EXPECT_EQ(run(drops), run(drops));
}

// A wall of no thickness, of 2 mm and of 2 cm, hit at 10 to 300 m/s by things that spin.
TEST(Continuous, WhatIsThrownStaysBeforeTheWall) {
    const Mesh sheet = support::quad(vec3(0, -5, 5), vec3(0, 0, -10), vec3(0, 10, 0), 0);
    for (const double thickness : {0.0, 0.002, 0.02}) {
        for (const Thing thing : {Thing::ball, Thing::box, Thing::turned_box, Thing::hull}) {
            for (const double speed : {10.0, 60.0, 300.0}) {
                for (const double spin : {0.0, 100.0}) {
                    Stage stage;
                    if (thickness > 0) {
                        stage.add("wall", fmt::format(R"({{"body": {{"size": [{}, 10, 10]}}}})", thickness),
                                  {0.5 * thickness, 0, 0});
                    } else {
                        stage.add("wall", R"({"body": {"shape": "mesh"}})", dvec3(0), &sheet);
                    }
                    const ecs::Entity thing_thrown = add_thing(stage, thing, 0.04, {-4, 0.5, 0});
                    stage.step();
                    stage.push(thing_thrown, {speed, 0, 1}, {0, 0.3 * spin, spin});
                    double farthest = -4;
                    for (int i = 0; i < 60; ++i) {
                        stage.step();
                        farthest = std::max(farthest, stage.place(thing_thrown).x);
                    }
                    EXPECT_GT(farthest, -0.1) << "it gets there";
                    EXPECT_LT(farthest, -0.009) << static_cast<int>(thing) << " at " << speed << " m/s, spin "
                                                << spin << ", wall of " << thickness;
                }
            }
        }
    }
}

// A rod that falls on its end, or turns as it falls, has no part below the floor's middle at rest.
TEST(Continuous, ARodStaysAboveTheFloorWithBothEnds) {
    for (const double thickness : {0.0, 0.02}) {
        for (const double height : {1.0, 20.0}) {
            Stage stage;
            add_thin_floor(stage, thickness, dvec3(0));
            const ecs::Entity rod =
                stage.add("rod", R"({"body": {"type": "dynamic", "size": [0.5, 0.02, 0.02]}})",
                          {0, height, 0}, nullptr, glm::angleAxis(1.4f, vec3(0, 0, 1)));
            stage.step();
            stage.push(rod, dvec3(0), {0, 2, 12});
            stage.step(500);
            const dmat4& m = stage.world.get<WorldTransform>(rod).matrix;
            for (const double end : {-0.25, 0.25}) {
                EXPECT_GT((m * dvec4(end, 0, 0, 1)).y, 0.008) << height << ", " << thickness;
            }
        }
    }
}

TEST(Continuous, AThinPlateThatMovesIsHitToo) {
    Stage stage({.gravity = dvec3(0)});
    const ecs::Entity plate =
        stage.add("plate", R"({"body": {"type": "dynamic", "mass": 5, "size": [0.01, 1, 1]}})", dvec3(0));
    const ecs::Entity ball =
        stage.add("ball", R"({"body": {"type": "dynamic", "shape": "sphere", "radius": 0.02}})", {-3, 0, 0});
    stage.step();
    stage.push(plate, {-20, 0, 0});
    stage.push(ball, {40, 0, 0});
    for (int i = 0; i < 30; ++i) {
        stage.step();
        ASSERT_LT(stage.place(ball).x, stage.place(plate).x) << i;
    }
    EXPECT_NEAR(5 * stage.motion(plate)->linear.x + stage.motion(ball)->linear.x, -60, 0.1);
}

// A door of 4 cm that turns about its edge at 10 and 20 rad/s: its end moves by 17 and 33 cm a step.
TEST(Continuous, AFastDoorTakesSmallThingsAlong) {
    for (const double rate : {10.0, 20.0}) {
        Stage stage({.gravity = dvec3(0)});
        const ecs::Entity door = stage.add(
            "door",
            R"({"body": {"type": "kinematic", "size": [1, 2, 0.04], "centre": [0.5, 0, 0], "friction": 0}})",
            dvec3(0));
        std::vector<ecs::Entity> things;
        for (const Thing thing : {Thing::ball, Thing::box, Thing::hull}) {
            for (const double along : {0.3, 0.6, 0.9}) {
                things.push_back(
                    add_thing(stage, thing, 0.04, {along, 0.3 * static_cast<double>(thing), -0.14}));
            }
        }
        for (int i = 0; i * rate / 60 < 0.5 * static_cast<double>(kPi); ++i) {
            stage.world.get_mut<LocalTransform>(door).value.rotation =
                glm::angleAxis(static_cast<float>(rate * i / 60), vec3(0, 1, 0));
            stage.transforms.update(stage.world);
            stage.step();
            const dmat4 to_door = glm::inverse(stage.world.get<WorldTransform>(door).matrix);
            for (std::size_t k = 0; k < things.size(); ++k) {
                const dvec3 place(to_door * dvec4(stage.place(things[k]), 1));
                EXPECT_TRUE(place.z < 0 || place.x > 1) << "thing " << k << " at " << rate << " rad/s, step "
                                                        << i << ": at " << place.x << ", " << place.z;
            }
        }
        for (const ecs::Entity e : things) {
            EXPECT_LT(stage.motion(e)->linear.z, -0.2 * rate);
        }
    }
}

TEST(Continuous, ASmallFastBallBouncesAsItsRestitutionSays) {
    for (const double e : {0.5, 0.8}) {
        Stage stage;
        stage.add("floor", R"({"body": {"size": [20, 0.02, 20], "restitution": 1}})", {0, -0.01, 0});
        const ecs::Entity ball = stage.add(
            "ball",
            fmt::format(
                R"({{"body": {{"type": "dynamic", "shape": "sphere", "radius": 0.02, "restitution": {}}}}})",
                e),
            {0, 20.02, 0});
        double down = 0;
        double up = 0;
        for (int i = 0; i < 180; ++i) {
            stage.step();
            down = std::max(down, -stage.motion(ball)->linear.y);
            up = std::max(up, stage.motion(ball)->linear.y);
        }
        EXPECT_NEAR(down, std::sqrt(2 * kGravity * 20), 0.5);
        EXPECT_NEAR(up / down, e, 0.03);
    }
}

// What slides fast along a floor is not held by it, nor a ball by the edges between its triangles.
TEST(Continuous, WhatSlidesFastIsNotHeld) {
    const Mesh tiles = [] {
        Mesh mesh = support::quad(vec3(-1, 0, 1), vec3(0.25f, 0, 0), vec3(0, 0, -2), 0);
        for (int i = 1; i < 100; ++i) {
            const Mesh next = support::quad(vec3(-1 + 0.25f * static_cast<float>(i), 0, 1), vec3(0.25f, 0, 0),
                                            vec3(0, 0, -2), 0);
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.vertices.insert(mesh.vertices.end(), next.vertices.begin(), next.vertices.end());
            for (const std::uint32_t index : next.indices) {
                mesh.indices.push_back(first + index);
            }
        }
        return mesh;
    }();
    const char* ball = R"("shape": "sphere", "radius": 0.02)";
    const char* box = R"("size": [0.04, 0.04, 0.04])";
    for (const auto& [shape, tiled] : {std::pair(ball, false), {ball, true}, {box, false}}) {
        Stage stage;
        if (tiled) {
            stage.add("floor", R"({"body": {"shape": "mesh", "friction": 0}})", dvec3(0), &tiles);
        } else {
            stage.add_floor(0, dvec3(0), 0);
        }
        const ecs::Entity thing =
            stage.add("thing", fmt::format(R"({{"body": {{"type": "dynamic", {}}}}})", shape), {0, 0.02, 0});
        stage.step(30);
        stage.push(thing, {15, 0, 0});
        const double start = stage.place(thing).x;
        stage.step(60);
        EXPECT_NEAR(stage.place(thing).x - start, 15, 0.15) << shape << (tiled ? ", tiled" : "");
        EXPECT_NEAR(stage.place(thing).y, 0.02, 0.004);
    }
}

TEST(Continuous, ACharacterFallsFarOntoThinFloors) {
    for (const double thickness : {0.0, 0.001, 0.02, 0.3}) {
        for (const double height : {1.0, 8.0, 50.0, 500.0}) {
            Stage stage;
            add_thin_floor(stage, thickness, dvec3(0));
            const ecs::Entity walker = stage.add("walker", R"({"character": {}})", {0.3, height, 0.2});
            stage.step(static_cast<int>(60 * std::sqrt(2 * height / kGravity)) + 30);
            EXPECT_NEAR(stage.place(walker).y, 0, 0.01) << thickness << ", " << height;
            EXPECT_TRUE(stage.world.get<CharacterState>(walker).on_ground);
        }
    }
}

}  // namespace
}  // namespace lanthorn::physics::test

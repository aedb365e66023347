// Bodies in an App, at any moment.

#include <gtest/gtest.h>

#include <memory>

#include "lanthorn/replay/content_hash.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/spawn.h"

namespace lanthorn {
namespace scene_physics_test {

NodeData body(const char* name, const char* extras, const dvec3& at) {
    NodeData node;
    node.name = name;
    node.extras = extras;
    node.local.translation = at;
    return node;
}

constexpr const char* kCrate = R"({"body": {"type": "dynamic", "size": [1, 1, 1]}})";

// Crates that fall on each other and on a floor, and a ram that an animation drives into them from x = -4 at
// 2 m/s.
SceneData scene() {
    SceneData s;
    s.materials.resize(1);
    s.nodes = {body("floor", R"({"body": {"size": [40, 2, 40]}})", {0, -1, 0}),
               body("ram", R"({"body": {"type": "kinematic", "size": [1, 1, 1]}})", {-4, 0.5, 0})};
    for (int i = 0; i < 5; ++i) {
        s.nodes.push_back(body("crate", kCrate, {0.1 * i, 1 + 1.25 * i, 0.07 * i}));
    }
    AnimationClip& clip = s.animations.emplace_back();
    clip.duration = 4;
    AnimationChannel& channel = clip.channels.emplace_back();
    channel.node = 1;
    channel.times = {0, 4};
    channel.values = {-4, 0.5f, 0, 4, 0.5f, 0};
    return s;
}

struct Shown {
    explicit Shown(const char* animation = "", SceneData data = scene()) {
        add_scene_plugins(app);
        nodes = spawn_scene(app, std::move(data));
        play_clip(app.world(), animation, "s.glb");
    }
    std::vector<dmat4> at(double seconds) {
        app.show_at(seconds);
        std::vector<dmat4> places;
        for (const ecs::Entity e : nodes) {
            places.push_back(app.world().get<WorldTransform>(e).matrix);
        }
        return places;
    }
    App app;
    std::vector<ecs::Entity> nodes;
};

std::uint64_t hash(const std::vector<dmat4>& places) {
    return replay::hash_bytes(std::as_bytes(std::span(places)));
}

TEST(ScenePhysics, FallsByTheIntegratorsClosedForm) {
    SceneData s;
    s.nodes = {body("stone", kCrate, {0, 100, 0})};
    Shown shown("", s);
    const double n = 30, dt = 1.0 / 60;  // semi-implicit Euler after n steps: g dt^2 n (n + 1) / 2
    const auto fallen = [&](double steps) { return 100 - 9.81 * dt * dt * steps * (steps + 1) / 2; };
    EXPECT_NEAR(shown.at(0.5)[0][3].y, fallen(n), 1e-9);
    EXPECT_NEAR(shown.at(0.5 + 0.75 * dt)[0][3].y, 0.25 * fallen(n) + 0.75 * fallen(n + 1), 1e-9)
        << "between two steps";
}

TEST(ScenePhysics, TwoRunsHaveTheSameBits) {
    Shown one, other;
    const std::uint64_t first = hash(one.at(3));
    EXPECT_EQ(first, hash(other.at(3)));
    EXPECT_NE(first, hash(other.at(3.1)));
}

TEST(ScenePhysics, AMomentDoesNotDependOnThoseShownBefore) {
    Shown direct;
    const std::uint64_t expected = hash(direct.at(2.5));
    Shown step_by_step;
    for (int k = 0; k < 150; ++k) {
        step_by_step.at(k / 60.0);
    }
    EXPECT_EQ(hash(step_by_step.at(2.5)), expected);
    Shown at_any_rate;
    for (double t = 0; t < 2.5; t += 0.0071) {
        at_any_rate.at(t);
    }
    EXPECT_EQ(hash(at_any_rate.at(2.5)), expected);
    EXPECT_EQ(Shown().at(0)[2][3].y, 1) << "the start";
}

TEST(ScenePhysics, WhatAnAnimationMovesPushes) {
    Shown pushed, left_alone("none");
    EXPECT_GT(pushed.at(3.5)[2][3].x, 1.5) << "the lowest crate, before the ram at x = 3";
    EXPECT_LT(std::abs(left_alone.at(3.5)[2][3].x), 0.5);
}

}  // namespace scene_physics_test
}  // namespace lanthorn

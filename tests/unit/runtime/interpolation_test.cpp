// Between two steps: what is shown, and that the simulation never learns of it.
#include "lanthorn/runtime/interpolation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lanthorn/animation/animation_player.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/spawn.h"

namespace lanthorn {
namespace interpolation_test {

struct Spin {
    double phase = 0;
};

// Reads what the simulation has of itself, world transforms included, and goes on from there.
void spin(ecs::Query<ecs::Write<LocalTransform>, ecs::Write<Spin>, ecs::Read<WorldTransform>> things) {
    things.each([](LocalTransform& local, Spin& spin, const WorldTransform& world) {
        spin.phase += 0.1 + 0.01 * world.matrix[3].x;
        local.value.translation.x += std::sin(spin.phase);
        local.value.rotation = glm::angleAxis(static_cast<float>(spin.phase), vec3(0, 1, 0));
    });
}

// A node that gameplay moves, with a child that a clip moves (translation and weights).
struct Moving {
    Moving() {
        add_scene_plugins(app);
        app.fixed_schedule().add("spin", spin).in("gameplay");
        SceneData data;
        data.nodes.resize(2);
        data.nodes[1].parent = 0;
        AnimationClip& clip = data.animations.emplace_back();
        clip.duration = 2;
        AnimationChannel& channel = clip.channels.emplace_back();
        channel.node = 1;
        channel.times = {0, 2};
        channel.values = {0, 0, 0, 0, 3, 0};
        nodes = spawn(app.world(), std::move(data));
        app.world().add(nodes[0], Spin{});
        app.world().add(nodes[0], Interpolated{});
        for (const ecs::Entity e : app.world().query<ecs::With<AnimationSet>>().entities()) {
            AnimationPlayer player;
            play(player, app.world().get<AnimationSet>(e), 0);
            app.world().add(e, std::move(player));
        }
    }
    const Transform& local(std::size_t node) { return app.world().get<LocalTransform>(nodes[node]).value; }
    // Of the simulation's state, after as many steps, whatever has been shown in between.
    std::vector<Transform> after_a_step() {
        app.step();
        return {local(0), local(1)};
    }
    App app;
    std::vector<ecs::Entity> nodes;
};

TEST(Interpolation, TheSimulationIsTheSameAtAnyFrameRate) {
    Moving unseen;
    for (int i = 0; i < 119; ++i) {
        unseen.app.step();
    }
    const std::vector<Transform> expected = unseen.after_a_step();
    for (const double rate : {17.0, 30.0, 59.0, 60.0, 61.0, 144.0, 1000.0}) {
        Moving seen;
        while (seen.app.time().steps < 119) {
            seen.app.frame(1 / rate,
                           static_cast<int>(std::min<std::uint64_t>(8, 119 - seen.app.time().steps)));
        }
        ASSERT_EQ(seen.app.time().steps, 119u) << rate;
        EXPECT_EQ(seen.after_a_step(), expected) << rate;
        EXPECT_EQ(seen.app.world().get<Spin>(seen.nodes[0]).phase,
                  unseen.app.world().get<Spin>(unseen.nodes[0]).phase)
            << rate;
    }
}

TEST(Interpolation, AFrameShowsTheBlend) {
    Moving moving;
    moving.app.step();
    const Transform first = moving.local(0);
    moving.app.step();
    const Transform second = moving.local(0);
    const double climbed = moving.local(1).translation.y;
    Moving again;
    again.app.step();
    again.app.frame(0.25 / 60);
    EXPECT_EQ(again.local(0), between(first, second, again.app.time().blend));
    EXPECT_NEAR(again.app.time().blend, 0.25, 1e-9);
    EXPECT_NEAR(again.local(1).translation.y, climbed - 0.75 * 1.5 / 60, 1e-12) << "the clip at that moment";
    EXPECT_NEAR(again.app.world().get<WorldTransform>(again.nodes[1]).matrix[3].x,
                again.local(0).translation.x, 1e-12);
}

TEST(Interpolation, WhatIsMovedByHandJumps) {
    Moving moving;
    moving.app.step();
    moving.app.frame(0.5 / 60);
    moving.app.world().get_mut<LocalTransform>(moving.nodes[0]).value.translation = {100, 0, 0};
    moving.app.show();
    EXPECT_EQ(moving.local(0).translation.x, 100);
    moving.app.step();
    EXPECT_NEAR(moving.local(0).translation.x, 100, 1.1) << "the simulation goes on from there";
}

TEST(Interpolation, EndsAreExact) {
    Transform a, b;
    a.translation = {1, 2, 3};
    b.translation = {0.1, 0.7, 1e9};
    b.rotation = glm::angleAxis(1.0f, glm::normalize(vec3(1, 2, 3)));
    b.scale = vec3(0.3f);
    EXPECT_EQ(between(a, b, 0), a);
    EXPECT_EQ(between(a, b, 1), b);
    EXPECT_EQ(between(b, b, 0.3), b);
}

}  // namespace interpolation_test
}  // namespace lanthorn

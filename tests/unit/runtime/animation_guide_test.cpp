// The code of docs/animation.md: a figure that walks by its clips. style.docs compares the page with this
// file.
#include <gtest/gtest.h>

#include "lanthorn/animation/animation_player.h"
#include "lanthorn/core/time_step.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/spawn.h"

namespace lanthorn {
namespace {

struct Gait {
    bool walking = false;
};

void choose_gait(
    ecs::Query<ecs::Read<Gait>, ecs::Changed<Gait>, ecs::Read<AnimationSet>, ecs::Write<AnimationPlayer>>
        figures) {
    figures.each([](const Gait& gait, const AnimationSet& set, AnimationPlayer& player) {
        cross_fade(player, set, find_clip(set, gait.walking ? "walk" : "stand").value(), 0.5);
    });
}

void follow_hips(ecs::Query<ecs::Read<AnimationPlayer>, ecs::Write<LocalTransform>> figures) {
    figures.each([](const AnimationPlayer& player, LocalTransform& figure) {
        Transform& at = figure.value;
        at.translation += glm::dquat(at.rotation) * player.root.translation;
        at.rotation = glm::normalize(at.rotation * player.root.turn);
    });
}

// Hips that walk along +X at 1 m/s for 2 s, and hips that stand.
SceneData figure() {
    SceneData scene;
    scene.nodes.resize(2);
    scene.nodes[1].name = "hips";
    scene.nodes[1].parent = 0;
    for (const float speed : {0.0f, 1.0f}) {
        AnimationClip& clip = scene.animations.emplace_back();
        clip.name = speed > 0 ? "walk" : "stand";
        clip.duration = 2;
        AnimationChannel& channel = clip.channels.emplace_back();
        channel.node = 1;
        channel.times = {0, 2};
        channel.values = {0, 0, 0, 2 * speed, 0, 0};
    }
    return scene;
}

TEST(AnimationGuide, AFigureWalksByItsClips) {
    App app;
    add_scene_plugins(app);
    app.fixed_schedule().add("choose_gait", choose_gait).in("gameplay");
    app.fixed_schedule().add("follow_hips", follow_hips).after("animation").before("transforms");

    const std::vector<ecs::Entity> nodes = spawn(app.world(), figure());
    AnimationPlayer player;
    player.root.node = 1;  // the hips' index in the file
    app.world().add(nodes[0], std::move(player));
    app.world().add(nodes[0], Gait{});

    const auto walked = [&](int steps, bool walking) {
        const double from = app.world().get<LocalTransform>(nodes[0]).value.translation.x;
        app.world().get_mut<Gait>(nodes[0]).walking = walking;
        for (int step = 0; step < steps; ++step) {
            app.step();
        }
        EXPECT_NEAR(app.world().get<LocalTransform>(nodes[1]).value.translation.x, 0, 1e-9) << "of the hips";
        return app.world().get<LocalTransform>(nodes[0]).value.translation.x - from;
    };
    EXPECT_EQ(walked(60, false), 0);
    const double faded = walked(60, true);
    EXPECT_GT(faded, 0.7) << "half a second of rising weight, then half a second at 1 m/s";
    EXPECT_LT(faded, 0.8);
    EXPECT_NEAR(walked(300, true), 5, 1e-6) << "over the clip's end";
    EXPECT_GT(walked(60, false), 0.2);
    EXPECT_EQ(walked(60, false), 0);
}

}  // namespace
}  // namespace lanthorn

// Entities that sound.
#include "lanthorn/audio/sound_source.h"

#include <gtest/gtest.h>

#include "lanthorn/runtime/app.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/scene_data.h"
#include "lanthorn/scene/spawn.h"

namespace lanthorn::audio {
namespace {

const std::vector<SoundName> kNames = {{"step"}, {"water", true}};

// A world with one source at (1, 2, 3).
struct Heard1 {
    explicit Heard1(SoundSource source) {
        add_scene_plugins(app);
        declare_sound_source(app.registry());
        of = app.world().create(LocalTransform{{.translation = {1, 2, 3}}}, std::move(source));
    }
    SoundSource& source() { return app.world().get_mut<SoundSource>(of); }
    Heard listen() {
        app.step();
        Heard heard;
        ear.listen(app.world(), heard);
        return heard;
    }

    App app;
    SourceEar ear{kNames};
    ecs::Entity of;
};

TEST(SoundSource, WhatLoopsGoesOnWhileItPlays) {
    Heard1 brook({.sound = "water", .gain = 0.25f, .pitch = 1.5f});
    for (int i = 0; i < 3; ++i) {
        const Heard heard = brook.listen();
        ASSERT_EQ(heard.going.size(), 1u);
        EXPECT_TRUE(heard.begun.empty());
        const Sound& sound = heard.going.front();
        EXPECT_EQ(sound.kind, 1);
        EXPECT_EQ(sound.place, dvec3(1, 2, 3));
        EXPECT_EQ(sound.gain, 0.25f);
        EXPECT_EQ(sound.pitch, 1.5f);
        EXPECT_EQ(sound.of, brook.of);
    }
    brook.source().playing = false;
    EXPECT_TRUE(brook.listen().going.empty());
}

TEST(SoundSource, WhatIsPlayedOnceBeginsWhenItIsToPlay) {
    Heard1 step({.sound = "step", .placed = false, .playing = false});
    EXPECT_TRUE(step.listen().begun.empty());
    step.source().playing = true;
    const Heard heard = step.listen();
    ASSERT_EQ(heard.begun.size(), 1u);
    EXPECT_FALSE(heard.begun.front().placed);
    EXPECT_TRUE(step.listen().begun.empty()) << "it is played once";
    step.source().playing = false;
    step.listen();
    step.source().playing = true;
    EXPECT_EQ(step.listen().begun.size(), 1u);
}

TEST(SoundSource, OneThatIsGoneIsForgottenAndItsPlaceInTheWorldMayBeAnothers) {
    Heard1 step({.sound = "step"});
    EXPECT_EQ(step.listen().begun.size(), 1u);
    step.app.world().destroy(step.of);
    EXPECT_TRUE(step.listen().begun.empty());
    step.of = step.app.world().create(LocalTransform{}, SoundSource{.sound = "step"});
    EXPECT_EQ(step.listen().begun.size(), 1u);
}

TEST(SoundSource, AnUnknownSoundIsNamed) {
    Heard1 odd({.sound = "trumpet"});
    const Heard heard = odd.listen();
    EXPECT_TRUE(heard.begun.empty() && heard.going.empty());
    EXPECT_EQ(odd.ear.unknown(), std::set<std::string>{"trumpet"});
}

TEST(SoundSource, ComesFromExtras) {
    App app;
    add_scene_plugins(app);
    declare_sound_source(app.registry());
    SceneData scene;
    NodeData& node = scene.nodes.emplace_back();
    node.name = "brook";
    node.extras = R"({"sound_source": {"sound": "water", "gain": 0.5}})";
    const ecs::Entity brook = spawn_scene(app, std::move(scene)).front();
    EXPECT_EQ(app.world().get<SoundSource>(brook), (SoundSource{.sound = "water", .gain = 0.5f}));
}

TEST(SoundSource, IsHeardFromTheViewsCamera) {
    App app;
    add_scene_plugins(app);
    EXPECT_EQ(ears_of(app.world()).place, dvec3(0));
    app.view().camera = app.world().create(LocalTransform{{.translation = {4, 0, 0}}}, CameraComponent{});
    app.step();
    EXPECT_EQ(ears_of(app.world()).place, dvec3(4, 0, 0));
    EXPECT_EQ(ears_of(app.world()).ahead, dvec3(0, 0, -1));
}

}  // namespace
}  // namespace lanthorn::audio

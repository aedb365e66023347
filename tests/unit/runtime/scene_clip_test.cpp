// Clips by the App's clock.
#include <gtest/gtest.h>

#include "lanthorn/core/error.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/spawn.h"

namespace lanthorn {
namespace {

AnimationClip along(int axis, const char* name) {
    AnimationClip clip;
    clip.name = name;
    clip.duration = 2;
    AnimationChannel& channel = clip.channels.emplace_back();
    channel.times = {0, 2};
    channel.values.resize(6);
    channel.values[static_cast<std::size_t>(3 + axis)] = 2;  // one metre a second
    return clip;
}

// A node with a child; one clip moves it along x, one along y.
SceneData scene() {
    SceneData s;
    s.nodes.resize(2);
    s.nodes[1].parent = 0;
    s.nodes[1].local.translation.z = 5;
    s.animations = {along(0, "east"), along(1, "up")};
    return s;
}

struct Shown {
    explicit Shown(const std::string& animation, SceneData data = scene()) {
        add_scene_plugins(app);
        nodes = spawn(app.world(), std::move(data));
        play_clip(app.world(), animation, "scene.glb");
    }
    dvec3 place(ecs::Entity e) { return dvec3(app.world().get<WorldTransform>(e).matrix[3]); }
    dvec3 child(double seconds) {
        app.show_at(seconds);
        return place(nodes[1]);
    }
    App app;
    std::vector<ecs::Entity> nodes;
};

TEST(SceneClip, ChoosesByNameOrNumberOrTheFirst) {
    EXPECT_EQ(Shown("").child(0.5), dvec3(0.5, 0, 5));
    EXPECT_EQ(Shown("0").child(0.5), dvec3(0.5, 0, 5));
    EXPECT_EQ(Shown("up").child(0.5), dvec3(0, 0.5, 5));
    EXPECT_EQ(Shown("1").child(0.5), dvec3(0, 0.5, 5));
    EXPECT_EQ(Shown("none").child(0.5), dvec3(0, 0, 5));
}

TEST(SceneClip, IsAtItsMomentExactlyAndLooped) {
    Shown shown("east");
    EXPECT_EQ(shown.child(0.25), dvec3(0.25, 0, 5));
    EXPECT_EQ(shown.child(0.3125), dvec3(0.3125, 0, 5)) << "between two steps";
    EXPECT_EQ(shown.child(1.5), dvec3(1.5, 0, 5));
    EXPECT_EQ(shown.child(6.5), dvec3(0.5, 0, 5));
    EXPECT_EQ(Shown("east").child(0.3125), dvec3(0.3125, 0, 5)) << "whatever was shown before";
}

TEST(SceneClip, EmptyIsEveryScenesFirst) {
    Shown shown("none");
    SceneData other = scene();
    other.animations.erase(other.animations.begin());  // "up" alone
    const auto second = spawn(shown.app.world(), std::move(other));
    play_clip(shown.app.world(), "", "scene.glb");
    EXPECT_EQ(shown.child(0.5), dvec3(0.5, 0, 5));
    EXPECT_EQ(shown.place(second[1]), dvec3(0, 0.5, 5));
}

TEST(SceneClip, EverySceneThatHasItPlaysIt) {
    Shown shown("none");
    const auto second = spawn(shown.app.world(), scene());
    play_clip(shown.app.world(), "east", "scene.glb");
    EXPECT_EQ(shown.child(0.5), dvec3(0.5, 0, 5));
    EXPECT_EQ(shown.place(second[1]), dvec3(0.5, 0, 5));
}

void expect_refused(const std::string& animation, SceneData data, const std::string& line) {
    try {
        Shown shown(animation, std::move(data));
        ADD_FAILURE() << "took " << animation;
    } catch (const InputError& error) {
        EXPECT_EQ(error.what(), line);
    }
}

TEST(SceneClip, UnknownAnimationsAreNamedWithThoseThereAre) {
    expect_refused("west", scene(),
                   "scene.glb: found no animation 'west', expected one of 0 'east', 1 'up', or none");
    expect_refused("2", scene(),
                   "scene.glb: found no animation '2', expected one of 0 'east', 1 'up', or none");
    SceneData still = scene();
    still.animations.clear();
    expect_refused("east", still, "scene.glb: found no animation 'east': there is none");
    EXPECT_EQ(Shown("", still).child(1), dvec3(0, 0, 5));
    EXPECT_EQ(Shown("none", still).child(1), dvec3(0, 0, 5));
}

}  // namespace
}  // namespace lanthorn

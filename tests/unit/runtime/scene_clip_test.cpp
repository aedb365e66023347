// Clips by the App's clock.
#include <gtest/gtest.h>

#include "lanthorn/core/error.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/spawn.h"
#include "tests/support/sliding_node.h"

namespace lanthorn {
namespace {

using support::sliding_node;

struct Shown {
    explicit Shown(const std::string& animation, SceneData data = sliding_node()) {
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
    SceneData other = sliding_node();
    other.animations.erase(other.animations.begin());  // "up" alone
    const auto second = spawn(shown.app.world(), std::move(other));
    play_clip(shown.app.world(), "", "scene.glb");
    EXPECT_EQ(shown.child(0.5), dvec3(0.5, 0, 5));
    EXPECT_EQ(shown.place(second[1]), dvec3(0, 0.5, 5));
}

TEST(SceneClip, EverySceneThatHasItPlaysIt) {
    Shown shown("none");
    const auto second = spawn(shown.app.world(), sliding_node());
    play_clip(shown.app.world(), "east", "scene.glb");
    EXPECT_EQ(shown.child(0.5), dvec3(0.5, 0, 5));
    EXPECT_EQ(shown.place(second[1]), dvec3(0.5, 0, 5));
}

// A lamp that goes from 0 to 100 cd in two seconds. A picture between two steps shows it where it is then;
// the simulation goes on from its own.
TEST(SceneClip, MovesLights) {
    SceneData data;
    data.nodes.resize(1);
    data.nodes[0].light = 0;
    data.lights.resize(1);
    PropertyChannel channel;
    channel.property = AnimatedProperty::light_intensity;
    channel.nodes = {0};
    channel.keys.interpolation = Interpolation::linear;
    channel.keys.path = AnimationPath::weights;
    channel.keys.width = 1;
    channel.keys.times = {0, 2};
    channel.keys.values = {0, 100};
    AnimationClip clip;
    clip.name = "dawn";
    clip.duration = 2;
    clip.properties = {channel};
    data.animations = {clip};
    Shown shown("dawn", std::move(data));
    const auto intensity = [&] {
        return shown.app.world().get<LightComponent>(shown.nodes[0]).light.intensity;
    };
    shown.app.show_at(0);
    EXPECT_EQ(intensity(), 0);
    shown.app.show_at(1.0078125);  // between two steps
    EXPECT_EQ(intensity(), 50.390625f);
    float simulated = -1;
    shown.app.fixed_schedule().add("look", [&](ecs::World&) { simulated = intensity(); }).in("gameplay");
    shown.app.step();
    EXPECT_FLOAT_EQ(simulated, 100.0f / 2 * 61 / 60) << "of the last step, not of the picture";
    EXPECT_FLOAT_EQ(intensity(), 100.0f / 2 * 62 / 60);
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
    expect_refused("west", sliding_node(),
                   "scene.glb: found no animation 'west', expected one of 0 'east', 1 'up', or none");
    expect_refused("2", sliding_node(),
                   "scene.glb: found no animation '2', expected one of 0 'east', 1 'up', or none");
    SceneData still = sliding_node();
    still.animations.clear();
    expect_refused("east", still, "scene.glb: found no animation 'east': there is none");
    EXPECT_EQ(Shown("", still).child(1), dvec3(0, 0, 5));
    EXPECT_EQ(Shown("none", still).child(1), dvec3(0, 0, 5));
}

}  // namespace
}  // namespace lanthorn

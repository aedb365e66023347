// A scene that is shown: from a file, or as a program fills it.
#include "lanthorn/runtime/shown_scene.h"

#include <gtest/gtest.h>

#include "lanthorn/core/error.h"
#include "lanthorn/physics/components.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/spawn.h"

namespace lanthorn {
namespace {

// A square of 2 m at the origin, seen by a camera 10 m in front of it.
SceneData bare() {
    SceneData s;
    s.source = "bare.glb";
    s.materials.resize(1);
    Mesh& mesh = s.meshes.emplace_back();
    for (const vec3& p : {vec3(-1, -1, 0), vec3(1, -1, 0), vec3(1, 1, 0), vec3(-1, 1, 0)}) {
        mesh.vertices.emplace_back().position = p;
        mesh.vertices.back().normal = vec3(0, 0, 1);
        mesh.bounds.add(p);
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    s.nodes.resize(2);
    s.nodes[0].name = "square";
    s.nodes[0].meshes = {0};
    s.nodes[1].name = "eye";
    s.nodes[1].camera = 0;
    s.nodes[1].local.translation = dvec3(0, 0, 10);
    s.cameras.resize(1);
    return s;
}

SceneData shining() {
    SceneData s = bare();
    s.materials[0].emissive = vec3(1);
    return s;
}

TEST(ShownScene, RefusesWhatCannotBeSeen) {
    EXPECT_THROW(ShownScene(bare(), {}), InputError) << "no light";
    SceneData s = shining();
    EXPECT_NE(ShownScene(s, {}).camera(), ecs::kNullEntity);
    EXPECT_EQ(ShownScene(s, {.camera = "auto"}).camera(), ecs::kNullEntity);
    EXPECT_THROW(ShownScene(s, {.camera = "1"}), InputError);
    EXPECT_THROW(ShownScene(s, {.animation = "walk"}), InputError);
    s.nodes[1].camera = kNone;
    EXPECT_EQ(ShownScene(s, {}).camera(), ecs::kNullEntity) << "one that sees everything";
    s.nodes[0].meshes.clear();
    EXPECT_THROW(ShownScene(s, {}), InputError) << "no geometry";
}

// A program's own scene, in which the square moves a centimetre a step.
void fill(App& app) {
    spawn_scene(app, bare());
    app.view().camera = find_by_name(app.world(), "eye");
    app.fixed_schedule()
        .add("drift",
             [](ecs::Query<ecs::Write<LocalTransform>, ecs::With<MeshInstances>> things) {
                 things.each([](LocalTransform& at) { at.value.translation.x += 0.01; });
             })
        .in("gameplay");
}

double drift(const ShownScene& shown) {
    const ecs::World& world = shown.world();
    const auto squares = world.query<ecs::With<MeshInstances>>().entities();
    return world.get<LocalTransform>(squares.at(0)).value.translation.x;
}

TEST(ShownScene, TakesEveryStepOfWhatAProgramHasFilledItWith) {
    ShownScene shown(fill);
    EXPECT_TRUE(shown.camera());
    shown.show_at(10.5 / kStepsPerSecond);
    EXPECT_EQ(shown.app().time().steps, 11u);
    EXPECT_NEAR(drift(shown), 0.11, 1e-12);
    EXPECT_EQ(shown.frame().instances.size(), 1u) << "a scene without light is shown as well";
}

// The steps that are simulated on the way to a second.
int steps_of(ShownScene& shown) {
    int steps = 0;
    shown.app().fixed_schedule().add("count", [&](ecs::World&) { ++steps; }).after("remember");
    shown.show_at(1);
    return steps;
}

TEST(ShownScene, SkipsStepsOnWhichNothingDepends) {
    ShownScene still(shining(), {});
    EXPECT_LE(steps_of(still), 1);
    SceneData with_body = shining();
    with_body.nodes[0].extras = R"({"body": {"type": "dynamic", "size": [1, 1, 1]}})";
    ShownScene simulated(with_body, {});
    EXPECT_EQ(steps_of(simulated), 60);
}

TEST(ShownScene, GoesBackToAStateAndSaysWhatIsNone) {
    ShownScene shown(fill);
    shown.show_at(5 / kStepsPerSecond);
    const std::string state = shown.state();
    const double before = drift(shown);
    shown.show_at(20 / kStepsPerSecond);
    EXPECT_GT(drift(shown), before + 0.1);
    EXPECT_TRUE(shown.restore(state, "kept").empty());
    EXPECT_EQ(drift(shown), before);
    EXPECT_EQ(shown.state(), state);
    EXPECT_THROW(shown.restore(state.substr(0, state.size() / 2), "kept"), InputError);
    EXPECT_EQ(drift(shown), before) << "what is no state alters nothing";
}

TEST(ShownScene, HeldStandsAsItIsShown) {
    ShownScene shown(fill);
    shown.show_at(5.5 / kStepsPerSecond);
    const mat4 at = shown.frame().instances.at(0).transform;
    shown.hold();
    shown.app().show();
    EXPECT_EQ(shown.frame().instances.at(0).transform, at);
}

}  // namespace
}  // namespace lanthorn

// The moment of an animation that `lanthorn render` shows, and what `lanthorn inspect` says of what moves.
#include "tools/lanthorn/scene/scene_player.h"

#include <gtest/gtest.h>

#include "lanthorn/core/error.h"
#include "lanthorn/scene/spawn.h"
#include "tools/lanthorn/common/motion_tables.h"
#include "tools/lanthorn/render/render_job.h"

namespace lanthorn::tools {
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
        nodes = spawn(world, std::move(data));
        player = std::make_unique<ScenePlayer>(world, animation, "scene.glb");
    }
    dvec3 child(double seconds) {
        player->show(seconds);
        return dvec3(world.get<WorldTransform>(nodes[1]).matrix[3]);
    }
    ecs::World world;
    std::vector<ecs::Entity> nodes;
    std::unique_ptr<ScenePlayer> player;
};

TEST(ScenePlayer, ChoosesByNameOrNumberOrTheFirst) {
    EXPECT_EQ(Shown("").child(0.5), dvec3(0.5, 0, 5));
    EXPECT_EQ(Shown("0").child(0.5), dvec3(0.5, 0, 5));
    EXPECT_EQ(Shown("up").child(0.5), dvec3(0, 0.5, 5));
    EXPECT_EQ(Shown("1").child(0.5), dvec3(0, 0.5, 5));
    EXPECT_EQ(Shown("none").child(0.5), dvec3(0, 0, 5));
}

TEST(ScenePlayer, EverySpawnedSceneMoves) {
    ecs::World world;
    const std::vector<ecs::Entity> one = spawn(world, scene());
    SceneData other = scene();
    other.animations.erase(other.animations.begin());  // "up" alone
    const std::vector<ecs::Entity> two = spawn(world, std::move(other));
    const auto at = [&](ecs::Entity e) { return dvec3(world.get<WorldTransform>(e).matrix[3]); };
    ScenePlayer(world, "", "scene.glb").show(0.5);
    EXPECT_EQ(at(one[1]), dvec3(0.5, 0, 5));
    EXPECT_EQ(at(two[1]), dvec3(0, 0.5, 5));
    ScenePlayer(world, "up", "scene.glb").show(1);
    EXPECT_EQ(at(two[1]), dvec3(0, 1, 5));
    EXPECT_EQ(at(one[1]).y, 1);
}

TEST(ScenePlayer, AnyMomentInAnyOrderAndLooped) {
    Shown shown("east");
    EXPECT_EQ(shown.child(1.5), dvec3(1.5, 0, 5));
    EXPECT_EQ(shown.child(0.25), dvec3(0.25, 0, 5));
    EXPECT_EQ(shown.child(6.5), dvec3(0.5, 0, 5));
}

void expect_refused(const std::string& animation, SceneData data, const std::string& line) {
    try {
        Shown shown(animation, std::move(data));
        ADD_FAILURE() << "took " << animation;
    } catch (const InputError& error) {
        EXPECT_EQ(error.what(), line);
    }
}

TEST(ScenePlayer, UnknownAnimationsAreNamedWithThoseThereAre) {
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

TEST(ScenePlayer, TheLastFrameShowsTheTimeAndThoseBeforeLeadUpToIt) {
    RenderJob job;
    job.frames = 30;
    EXPECT_DOUBLE_EQ(shown_time(job), 0.5);
    EXPECT_DOUBLE_EQ(shown_time(job, 29), 1.0 / 60);
    EXPECT_EQ(shown_time(job, 40), 0);  // warm-up before the start
    job.view.time = 2;
    EXPECT_EQ(shown_time(job), 2);
    EXPECT_DOUBLE_EQ(shown_time(job, 6), 1.9);
}

TEST(MotionTables, SayWhatMoves) {
    SceneData s = scene();
    s.animations[1].channels[0].path = AnimationPath::rotation;
    s.animations[1].channels.push_back(s.animations[0].channels[0]);
    s.skins = {{"rig", {0, 1}, {mat4(1), mat4(1)}}};
    EXPECT_EQ(animation_table(s).text(),
              "  #  name  seconds  channels  nodes  moves\n"
              "  0  east  2.000    1         1      translation\n"
              "  1  up    2.000    2         1      translation, rotation\n");
    EXPECT_EQ(skin_table(s).text(), "  #  name  joints\n  0  rig   2\n");
    Mesh mesh;
    EXPECT_EQ(deformation_text(mesh), "-");
    mesh.skin.resize(2);
    mesh.skin[0].weights = {0.5f, 0.3f, 0.2f};
    mesh.skin[1].weights = {1};
    mesh.morphs.resize(4);
    mesh.cage = SubdivisionCage{};
    mesh.cage->level = 3;
    EXPECT_EQ(deformation_text(mesh), "skin of up to 3 joints, 4 morph targets, catmull-clark to level 3");
}

}  // namespace
}  // namespace lanthorn::tools

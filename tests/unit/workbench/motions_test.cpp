// What moves in `lanthorn measure motions`, and where it ends.
#include "lanthorn/workbench/motions.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gi_module/reference/scene_hash.h"
#include "lanthorn/core/error.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::workbench {
namespace {

constexpr int kFrames = 30;

SceneChoice at_start() {
    return {.time = 0};
}

MovingScene moving(const SceneData& scene, Motion motion) {
    return {scene, at_start(), motion, kFrames};
}

TEST(Swing, GoesThereAndBackAndEndsWhereItBegan) {
    const Swing swing{{1, 0, 0}, 0.3};
    EXPECT_EQ(swing.before_end(0), dvec3(0));
    EXPECT_NEAR(swing.before_end(0.25).x, 0.25, 1e-12);
    EXPECT_NEAR(swing.before_end(0.35).x, 0.25, 1e-12);
    EXPECT_NEAR(swing.before_end(0.65).x, 0.05, 1e-12);
    EXPECT_EQ(Swing().before_end(3), dvec3(0));
}

TEST(Motions, HaveNames) {
    for (const Motion motion : {Motion::rest, Motion::lamp, Motion::dim, Motion::walk, Motion::pan,
                                Motion::cut, Motion::box, Motion::figure}) {
        EXPECT_EQ(motion_named(name_of(motion)), motion) << name_of(motion);
    }
    EXPECT_EQ(name_of(Motion::figure), "figure");
    EXPECT_THROW(motion_named("dance"), InputError);
}

TEST(Motions, EndWhereTheSceneHasEverything) {
    const SceneData scene = scene_generator::two_rooms();
    MovingScene rest = moving(scene, Motion::rest);
    const std::uint64_t still = reference::scene_hash(rest.show(kFrames));
    for (const Motion motion : {Motion::lamp, Motion::dim, Motion::walk, Motion::pan, Motion::cut}) {
        MovingScene one = moving(scene, motion);
        ASSERT_EQ(one.lacking(), "");
        EXPECT_NE(reference::scene_hash(one.show(kFrames - 1)), still) << static_cast<int>(motion);
        EXPECT_EQ(reference::scene_hash(one.show(kFrames)), still) << static_cast<int>(motion);
    }
}

TEST(Motions, AreAsFastAsTheySay) {
    const SceneData scene = scene_generator::two_rooms();
    MovingScene lamp = moving(scene, Motion::lamp);
    EXPECT_NEAR(lamp.reach(), kFrames * kLampStep, 1e-9) << "there is room";
    vec3 before = lamp.show(0).lights.at(0).position;
    const vec3 start = before;
    for (int i = 1; i <= kFrames; ++i) {
        const FrameScene& frame = lamp.show(i);
        EXPECT_NEAR(glm::length(frame.lights.at(0).position - before), kLampStep, 1e-5);
        EXPECT_FALSE(frame.changes.geometry);
        before = frame.lights.at(0).position;
    }
    EXPECT_NEAR(glm::length(before - start), kFrames * kLampStep, 1e-5);

    MovingScene walk = moving(scene, Motion::walk);
    const CameraView first = walk.show(7).camera, second = walk.show(8).camera;
    EXPECT_NEAR(glm::length(second.position - first.position), kWalkStep, 1e-5);
    EXPECT_NEAR(glm::length(vec3(second.view * vec4(second.position, 1))), 0, 1e-5) << "view and place agree";
    EXPECT_EQ(mat3(first.view), mat3(second.view));

    MovingScene pan = moving(scene, Motion::pan);
    const mat3 turn = mat3(pan.show(7).camera.view) * glm::transpose(mat3(pan.show(8).camera.view));
    EXPECT_NEAR(std::acos(0.5f * (turn[0][0] + turn[1][1] + turn[2][2] - 1)), kPanStep, 1e-3);

    MovingScene dim = moving(scene, Motion::dim);
    const float brighter = dim.show(4).lights.at(0).light.intensity;
    EXPECT_NEAR(dim.show(5).lights.at(0).light.intensity / brighter, 1 - kDimStep, 1e-5);
}

TEST(Motions, KeepOutOfWalls) {
    // The room is 0.55 m wide and open in front, its lamp 0.13 m: there is no room for 60 cm in a line.
    MovingScene panel = moving(scene_generator::cornell(), Motion::lamp);
    ASSERT_EQ(panel.lacking(), "");
    EXPECT_GT(panel.reach(), kLampStep);
    EXPECT_LT(panel.reach(), 0.25);
    const Aabb room = panel.show(0).bounds;
    for (int i = 0; i <= kFrames; ++i) {
        ASSERT_EQ(panel.show(i).bounds, room) << "frame " << i;
    }
}

TEST(Motions, HaveABoxOfTheirOwn) {
    const SceneData scene = scene_generator::two_rooms();
    MovingScene moves = moving(scene, Motion::box), stands = moving(scene, Motion::box_rest);
    ASSERT_EQ(moves.lacking(), "");
    EXPECT_NEAR(moves.box().size().x, kBoxSide, 1e-5);
    const std::size_t parts = moving(scene, Motion::rest).show(0).instances.size();
    const auto box_of = [&](const FrameScene& frame) {
        EXPECT_EQ(frame.instances.size(), parts + 1);
        for (const Instance& instance : frame.instances) {
            if (glm::length(instance.bounds.size() - kBoxSide) < 1e-4f) {
                return instance.bounds.centre();
            }
        }
        ADD_FAILURE();
        return vec3(0);
    };
    const vec3 before = box_of(moves.show(3)), after = box_of(moves.show(4));
    EXPECT_NEAR(glm::length(after - before), kBoxStep, 1e-5);
    EXPECT_EQ(box_of(stands.show(3)), box_of(stands.show(4)));
    EXPECT_EQ(reference::scene_hash(moves.show(kFrames)), reference::scene_hash(stands.show(kFrames)));
    EXPECT_NEAR(glm::length(box_of(moves.show(kFrames)) - moves.box().centre()), 0, 1e-5);

    SceneData with_box = scene;
    place_box(with_box, moves.placed_box().value());
    EXPECT_EQ(reference::scene_hash(moving(with_box, Motion::rest).show(kFrames)),
              reference::scene_hash(moves.show(kFrames)))
        << "what a reference is traced of";
    EXPECT_EQ(moving(scene, Motion::rest).placed_box(), std::nullopt);
}

// A room that is a camera's width deep has none in front of it.
TEST(Motions, SayWhereABoxHasNoRoom) {
    SceneData scene = scene_generator::two_rooms();
    for (NodeData& node : scene.nodes) {
        if (node.camera != kNone) {
            node.local.translation = dvec3(0, 100, 0);
        }
    }
    const MovingScene moves = moving(scene, Motion::box);
    EXPECT_NE(moves.lacking().find("no room for a box"), std::string::npos) << moves.lacking();
    EXPECT_EQ(moves.placed_box(), std::nullopt);
}

TEST(Motions, PlayFigures) {
    MovingScene walker = moving(scene_generator::puppet(), Motion::figure);
    ASSERT_EQ(walker.lacking(), "");
    walker.show(3);
    EXPECT_TRUE(walker.show(4).changes.geometry);
    EXPECT_NE(moving(scene_generator::two_rooms(), Motion::figure).lacking(), "");
}

}  // namespace
}  // namespace lanthorn::workbench

// How most of a scene moves.
#include "gi_module/techniques/emc/maps/bulk_motion.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace lanthorn::gi {
namespace {

// Things of 1 m in a row along x, and a dome about them.
FrameScene row(int things) {
    FrameScene scene;
    for (int i = 0; i <= things; ++i) {
        Instance instance;
        instance.id = static_cast<std::uint32_t>(i + 1);
        const vec3 at(2 * i, 0, 0);
        instance.transform = glm::translate(mat4(1), at);
        instance.bounds = {at - 0.5f, at + 0.5f};
        if (i == things) {
            instance.transform = mat4(1);
            instance.bounds = {vec3(-1e4f), vec3(1e4f)};
        }
        scene.instances.push_back(instance);
    }
    return scene;
}

const Aabb kBox{vec3(-0.5f), vec3(18.5f, 0.5f, 0.5f)};  // of ten

void hold_still(FrameScene& scene) {
    scene.changes = {};
    scene.changes.geometry = false;
}

void move(FrameScene& scene, int thing, const vec3& by) {
    Instance& instance = scene.instances[static_cast<std::size_t>(thing)];
    instance.transform[3] += vec4(by, 0);
    instance.bounds = {instance.bounds.lower + by, instance.bounds.upper + by};
    scene.changes.geometry = true;
    scene.changes.moved.push_back(static_cast<std::uint32_t>(thing));
}

TEST(BulkMotion, MostThingsThatMoveAlikeAreTheBulk) {
    for (const int movers : {4, 6, 10}) {
        FrameScene scene = row(10);
        BulkMotion motion;
        motion.watch(scene, kBox);
        hold_still(scene);
        const vec3 by(0, 0.25f, -1);
        for (int i = 0; i < movers; ++i) {
            move(scene, i, by);
        }
        const BulkMotion::Step step = motion.follow(scene);
        EXPECT_EQ(step.by, movers > 5 ? by : vec3(0)) << movers;
        EXPECT_FALSE(step.apart) << movers;
    }
}

TEST(BulkMotion, ACrowdIsNoBulk) {
    FrameScene scene = row(10);
    BulkMotion motion;
    motion.watch(scene, kBox);
    hold_still(scene);
    for (int i = 0; i < 10; ++i) {
        move(scene, i, 0.1f * vec3(i % 3 - 1, 0, i % 4 - 1));
    }
    EXPECT_EQ(motion.follow(scene).by, vec3(0));
}

TEST(BulkMotion, TurningAboutItsMiddleMovesNothing) {
    FrameScene scene = row(1);
    BulkMotion motion;
    motion.watch(scene, {vec3(-0.5f), vec3(0.5f)});
    hold_still(scene);
    scene.instances[0].transform = glm::rotate(mat4(1), 0.5f, vec3(0, 1, 0));
    scene.instances[0].bounds = {vec3(-0.7f, -0.5f, -0.7f), vec3(0.7f, 0.5f, 0.7f)};
    scene.changes.moved = {0};
    EXPECT_EQ(motion.follow(scene).by, vec3(0));
}

TEST(BulkMotion, AnotherOriginMovesAll) {
    FrameScene scene = row(10);
    BulkMotion motion;
    motion.watch(scene, kBox);
    hold_still(scene);
    scene.origin = dvec3(5, 0, 0);
    for (int i = 0; i < 11; ++i) {
        move(scene, i, vec3(-5, 0, 0));
    }
    const BulkMotion::Step step = motion.follow(scene);
    EXPECT_EQ(step.by, vec3(-5, 0, 0));
    EXPECT_FALSE(step.apart);
    hold_still(scene);
    EXPECT_EQ(motion.follow(scene).by, vec3(0));
}

TEST(BulkMotion, ATenthThatLeavesTheRestIsApart) {
    for (const bool bulk : {false, true}) {  // two drive away; eight do, two stay
        FrameScene scene = row(10);
        BulkMotion motion;
        motion.watch(scene, kBox);
        for (int frame = 1; frame <= 4; ++frame) {
            hold_still(scene);
            for (int i = bulk ? 2 : 0; i < (bulk ? 10 : 2); ++i) {
                move(scene, i, vec3(0, 0, 0.6f));
            }
            EXPECT_EQ(motion.follow(scene).apart, frame == 4) << frame;  // 0.1 of 19 m is the box's margin
        }
    }
}

TEST(BulkMotion, NothingToWatchStays) {
    FrameScene scene = row(0);
    BulkMotion motion;
    motion.watch(scene, kBox);
    hold_still(scene);
    move(scene, 0, vec3(1));
    const BulkMotion::Step step = motion.follow(scene);
    EXPECT_EQ(step.by, vec3(0));
    EXPECT_FALSE(step.apart);
    scene = row(1);
    scene.instances[0].transform = mat4(0);  // as thin as a point
    motion.watch(scene, kBox);
    hold_still(scene);
    move(scene, 0, vec3(1));
    EXPECT_EQ(motion.follow(scene).by, vec3(0));
}

}  // namespace
}  // namespace lanthorn::gi

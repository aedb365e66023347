#include "lanthorn/gi/emc/swept_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lanthorn::gi {
namespace {

Aabb unit_box_at(float x, float y = 0) {
    return {vec3(x, y, 0), vec3(x + 1, y + 1, 1)};
}

// One instance a box; ids count from 0.
FrameScene scene_of_boxes(const std::vector<Aabb>& boxes) {
    FrameScene scene;
    scene.changes = {};
    scene.changes.geometry = false;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        Instance instance;
        instance.id = static_cast<std::uint32_t>(i);
        instance.bounds = boxes[i];
        scene.instances.push_back(instance);
    }
    return scene;
}

TEST(SweptBoxes, HoldWhereAMoverIsAndWas) {
    SweptBoxes swept;
    FrameScene scene = scene_of_boxes({unit_box_at(0), unit_box_at(5)});
    swept.follow(scene);
    EXPECT_TRUE(swept.movers().empty());
    scene.instances[1].bounds = unit_box_at(7);
    scene.changes.moved = {1};
    swept.follow(scene);
    ASSERT_EQ(swept.movers().size(), 1u);
    EXPECT_EQ(swept.movers()[0].swept, (Aabb{vec3(5, 0, 0), vec3(8, 1, 1)}));
    scene.changes.moved.clear();
    swept.follow(scene);
    EXPECT_TRUE(swept.movers().empty());
}

TEST(SweptBoxes, HoldWhatCameAndWhatWent) {
    SweptBoxes swept;
    swept.follow(scene_of_boxes({unit_box_at(0), unit_box_at(3)}));
    FrameScene scene = scene_of_boxes({unit_box_at(0)});
    Instance arrived;
    arrived.id = 7;
    arrived.bounds = unit_box_at(20);
    scene.instances.push_back(arrived);
    scene.changes.moved = {1};
    scene.changes.arrived = {1};
    swept.follow(scene);
    ASSERT_EQ(swept.movers().size(), 2u);
    EXPECT_EQ(swept.movers()[0].swept, unit_box_at(3));
    EXPECT_EQ(swept.movers()[1].swept, unit_box_at(20));
}

TEST(SweptBoxes, MoveWithTheOrigin) {
    SweptBoxes swept;
    FrameScene scene = scene_of_boxes({unit_box_at(100)});
    swept.follow(scene);
    scene.origin = {100, 0, 0};
    scene.instances[0].bounds = unit_box_at(0.5f);  // half a metre on
    scene.changes.moved = {0};
    swept.follow(scene);
    ASSERT_EQ(swept.movers().size(), 1u);
    EXPECT_EQ(swept.movers()[0].swept, (Aabb{vec3(0), vec3(1.5f, 1, 1)}));
}

// No more than the shader has room for, and every mover is in one.
TEST(SweptBoxes, BecomeOneWhereTheyLieTogether) {
    std::vector<Aabb> boxes;
    for (int i = 0; i < 40; ++i) {
        boxes.push_back(unit_box_at(i % 2 == 0 ? 0.1f * static_cast<float>(i) : 1000, static_cast<float>(i)));
    }
    SweptBoxes swept;
    FrameScene scene = scene_of_boxes(boxes);
    swept.follow(scene);
    for (std::uint32_t i = 0; i < 40; ++i) {
        scene.changes.moved.push_back(i);
    }
    swept.follow(scene);
    EXPECT_EQ(swept.movers().size(), SweptBoxes::kMost);
    for (const Aabb& box : boxes) {
        const bool inside = std::ranges::any_of(swept.movers(), [&](const Mover& m) {
            return glm::all(glm::lessThanEqual(m.swept.lower, box.lower)) &&
                   glm::all(glm::greaterThanEqual(m.swept.upper, box.upper));
        });
        EXPECT_TRUE(inside);
    }
    // The two crowds, a kilometre apart, are not joined.
    for (const Mover& m : swept.movers()) {
        EXPECT_LT(m.swept.size().x, 500);
        EXPECT_TRUE(!m.rigid || m.carry == mat4(1));
    }
}

// What turns and moves carries its points to where they are now.
TEST(SweptBoxes, CarryPointsAlong) {
    SweptBoxes swept;
    FrameScene scene = scene_of_boxes({unit_box_at(0)});
    scene.instances[0].transform = glm::translate(mat4(1), vec3(1, 2, 3));
    swept.follow(scene);
    const mat4 turned =
        glm::rotate(glm::translate(mat4(1), vec3(4, 2, 3)), glm::radians(90.0f), vec3(0, 0, 1));
    scene.instances[0].transform = turned;
    scene.changes.moved = {0};
    scene.origin = {0, 0, 1};
    scene.instances[0].transform[3].z -= 1;
    swept.follow(scene);
    ASSERT_EQ(swept.movers().size(), 1u);
    EXPECT_TRUE(swept.movers()[0].rigid);
    // A metre along the object's x, in the render space of the new origin.
    const vec3 now = vec3(swept.movers()[0].carry * vec4(2, 2, 2, 1));
    EXPECT_NEAR(glm::distance(now, vec3(4, 3, 2)), 0, 1e-5f);
}

TEST(SweptBoxes, PassOverWhatHasNoExtent) {
    SweptBoxes swept;
    FrameScene scene = scene_of_boxes({Aabb{}});
    swept.follow(scene);
    scene.changes.moved = {0};
    swept.follow(scene);
    EXPECT_TRUE(swept.movers().empty());
}

}  // namespace
}  // namespace lanthorn::gi

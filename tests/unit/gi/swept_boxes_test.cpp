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
    EXPECT_TRUE(swept.boxes().empty());
    scene.instances[1].bounds = unit_box_at(7);
    scene.changes.moved = {1};
    swept.follow(scene);
    ASSERT_EQ(swept.boxes().size(), 1u);
    EXPECT_EQ(swept.boxes()[0], (Aabb{vec3(5, 0, 0), vec3(8, 1, 1)}));
    scene.changes.moved.clear();
    swept.follow(scene);
    EXPECT_TRUE(swept.boxes().empty());
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
    ASSERT_EQ(swept.boxes().size(), 2u);
    EXPECT_EQ(swept.boxes()[0], unit_box_at(3));
    EXPECT_EQ(swept.boxes()[1], unit_box_at(20));
}

TEST(SweptBoxes, MoveWithTheOrigin) {
    SweptBoxes swept;
    FrameScene scene = scene_of_boxes({unit_box_at(100)});
    swept.follow(scene);
    scene.origin = {100, 0, 0};
    scene.instances[0].bounds = unit_box_at(0.5f);  // half a metre on
    scene.changes.moved = {0};
    swept.follow(scene);
    ASSERT_EQ(swept.boxes().size(), 1u);
    EXPECT_EQ(swept.boxes()[0], (Aabb{vec3(0), vec3(1.5f, 1, 1)}));
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
    EXPECT_EQ(swept.boxes().size(), SweptBoxes::kMost);
    for (const Aabb& box : boxes) {
        const bool inside = std::ranges::any_of(swept.boxes(), [&](const Aabb& b) {
            return glm::all(glm::lessThanEqual(b.lower, box.lower)) &&
                   glm::all(glm::greaterThanEqual(b.upper, box.upper));
        });
        EXPECT_TRUE(inside);
    }
    // The two crowds, a kilometre apart, are not joined.
    for (const Aabb& b : swept.boxes()) {
        EXPECT_LT(b.size().x, 500);
    }
}

TEST(SweptBoxes, PassOverWhatHasNoExtent) {
    SweptBoxes swept;
    FrameScene scene = scene_of_boxes({Aabb{}});
    swept.follow(scene);
    scene.changes.moved = {0};
    swept.follow(scene);
    EXPECT_TRUE(swept.boxes().empty());
}

}  // namespace
}  // namespace lanthorn::gi

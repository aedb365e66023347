// Poses: what `render --pose` takes, and what an editor copies.
#include <gtest/gtest.h>

#include "lanthorn/core/error.h"
#include "lanthorn/workbench/load_scene.h"

namespace lanthorn::workbench {
namespace {

TEST(CameraPose, IsReadAgainAsTheSameBits) {
    for (const CameraPose& pose : {CameraPose{{0.1, -1e-7, 123456.789012345}, 33.333333333333336, -7.1, 60},
                                   CameraPose{{1.0 / 3, 2, 3}, -180, 90, 35.5}, CameraPose{}}) {
        EXPECT_EQ(pose_of(text_of(pose)), pose) << text_of(pose);
    }
    EXPECT_EQ(text_of({{1, 2, 3}, 90, -10, 60}), "1,2,3,90,-10");
    EXPECT_EQ(pose_of("1,2,3,90,-10,50").fov, 50);
}

TEST(CameraPose, WhatIsNoneIsRefused) {
    for (const char* text : {"", "1", "1,2,3,4", "1,2,3,4,5,6,7", "1,2,3,4,x", "1,2,3,4,91", "1,2,3,4,5,0",
                             "1 2 3 4 5", "nan,0,0,0,0", "1,2,3,4,5,"}) {
        EXPECT_THROW(pose_of(std::string(text)), InputError) << text;
    }
}

TEST(PlacedBox, IsReadAgainAsTheSameBits) {
    for (const PlacedBox& box : {PlacedBox{{0.1, -1e-7, 123456.789012345}, 1.0 / 3}, PlacedBox{{}, 1}}) {
        const PlacedBox read = box_of(text_of(box));
        EXPECT_EQ(read.centre, box.centre);
        EXPECT_EQ(read.side, box.side);
    }
    for (const char* text :
         {"", "1,2,3", "1,2,3,4,5", "1,2,3,0", "1,2,3,-1", "1,2,3,x", "nan,0,0,1", "1,2,3,4,"}) {
        EXPECT_THROW(box_of(text), InputError) << text;
    }
}

TEST(CameraPose, YawTurnsLeftAndPitchUp) {
    const auto ahead = [](const CameraPose& pose) { return -dvec3(transform_of(pose).matrix()[2]); };
    EXPECT_LT(glm::length(ahead({}) - dvec3(0, 0, -1)), 1e-6);
    EXPECT_LT(glm::length(ahead({{}, 90, 0, 60}) - dvec3(-1, 0, 0)), 1e-6);
    EXPECT_LT(glm::length(ahead({{}, 90, 90, 60}) - dvec3(0, 1, 0)), 1e-6);
}

TEST(CameraPose, OfACameraIsWhereItLooks) {
    const CameraPose pose{{1, 2, 3}, 40, -20, 50};
    const CameraPose back = pose_of(transform_of(pose).matrix(), camera_of(pose));
    EXPECT_EQ(back.at, pose.at);
    EXPECT_NEAR(back.yaw, pose.yaw, 1e-4);
    EXPECT_NEAR(back.pitch, pose.pitch, 1e-4);
    EXPECT_NEAR(back.fov, pose.fov, 1e-4);
}

TEST(CameraPose, ComesLastAndUnderANameOfItsOwn) {
    SceneData scene;
    scene.nodes.emplace_back().name = "pose";
    const std::string name = add_pose_camera(scene, {{1, 2, 3}, 0, 0, 60});
    EXPECT_EQ(name, "pose_");
    EXPECT_EQ(scene.nodes.back().local.translation, dvec3(1, 2, 3));
    EXPECT_EQ(scene.cameras.size(), 1u);
}

}  // namespace
}  // namespace lanthorn::workbench

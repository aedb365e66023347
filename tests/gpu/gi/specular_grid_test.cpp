// Mirrors and glass whose rays are some pixels apart: what a ray a pixel shows, a little softer, and nothing
// of what stands beside it.
#include <gtest/gtest.h>

#include <cstdio>
#include <utility>
#include <vector>

#include "tests/gpu/gi/path_truth.h"
#include "tests/gpu/gi/specular_room.h"

namespace lanthorn::gi::test {
namespace {

// A picture with one ray in 2 x 2 pixels, from one with a ray a pixel.
Deviation coarser(const ImageF& coarse, const ImageF& every, const char* what) {
    const Deviation d = against(coarse, every.pixels);
    std::printf("%s, one ray in 2 x 2: flux %.4f, relRMSE %.4f\n", what, d.mean, d.rel_rmse);
    return d;
}

// The rays of one pixel in 2 x 2 or 4 x 4 show what each pixel's own do, a little softer: of a mirror and of
// brushed metal.
TEST_P(Specular, ACoarserGridShowsTheSame) {
    const vec3 eye(2.6f, 1.3f, 1.5f), target(4, 1.0f, 1.75f);
    for (const float roughness : {0.0f, 0.3f}) {
        const FrameScene scene =
            room({quad({3.99f, 0, 0}, {0, 0, 3}, {0, 2.6f, 0}, 0)}, {metal(vec3(1), roughness)}, eye, target);
        const ImageF every = picture(scene, 2);
        for (const int grid : {2, 4}) {
            const Deviation d = against(picture(scene, 2, grid), every.pixels);
            std::printf("one ray in %d x %d, roughness %.1f: flux %.4f, relRMSE %.4f\n", grid, grid,
                        static_cast<double>(roughness), d.mean, d.rel_rmse);
            EXPECT_NEAR(d.mean, 1, 0.005);
            EXPECT_LT(d.rel_rmse, grid == 2 ? 0.065 : 0.095);
            EXPECT_GT(d.rel_rmse, 0.01);  // it is coarser
        }
    }
}

// Slats of a mirror before a dull wall, hardly wider than a pixel: each pixel that shows another surface than
// the first of its cell has its own ray.
TEST_P(Specular, ACoarserGridLeavesThinThingsAlone) {
    std::vector<Mesh> slats;
    for (int i = 0; i < 12; ++i) {
        const float z = 0.5f + 0.17f * static_cast<float>(i);
        slats.push_back(
            quad({3.9f - 0.01f * static_cast<float>(i % 3), 0, z}, {0, 0, 0.012f}, {0, 2.6f, 0}, 0));
    }
    const FrameScene scene = room(slats, {metal(vec3(1), 0)}, vec3(2.6f, 1.3f, 1.5f), vec3(4, 1.0f, 1.75f));
    const Deviation d = coarser(picture(scene, 2, 2), picture(scene), "thin mirrors");
    EXPECT_NEAR(d.mean, 1, 0.001);
    EXPECT_LT(d.rel_rmse, 0.01);
}

// Strips of two materials in one plane, side by side, each a pixel and a half wide in the picture.
std::vector<Mesh> strips(const vec3& corner, const vec3& across, const vec3& up, int count) {
    std::vector<Mesh> result;
    const vec3 step = across / static_cast<float>(count);
    for (int i = 0; i < count; ++i) {
        result.push_back(
            quad(corner + step * static_cast<float>(i), step, up, static_cast<std::uint32_t>(i % 2)));
    }
    return result;
}

// What is polished mirrors a panel behind the eye, which lets no light past its lobe; rays of what is rough
// beside it often miss the panel.
TEST_P(Specular, ACoarserGridKeepsRoughnessesApart) {
    std::vector<Mesh> meshes = strips({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, 150);
    meshes.push_back(quad({-2.2f, -2.2f, 1.5f}, {0, 4.4f, 0}, {4.4f, 0, 0}, 2));
    FrameScene scene =
        scene_of(std::move(meshes), {metal(vec3(1), 0.11f), metal(vec3(0.02f), 0.447f), lamp(vec3(kNits))},
                 {}, vec3(0), vec3(0, 0, -1));
    scene.camera.camera.y_fov = 0.7f;
    const Deviation d = coarser(picture(scene, 2, 2), picture(scene), "two roughnesses");
    EXPECT_NEAR(d.mean, 1, 0.005);
    EXPECT_LT(d.rel_rmse, 0.015);
}

TEST_P(Specular, ACoarserGridShowsTheSameThroughAWindow) {
    const Pane pane(kPaneEye, kPaneTarget);
    const FrameScene scene = room({quad(pane.corner, pane.right, pane.up, 0)}, {Pane::material(vec3(0.5f))},
                                  kPaneEye, kPaneTarget);
    const Deviation d = coarser(picture(scene, 2, 2), picture(scene), "a window");
    EXPECT_NEAR(d.mean, 1, 0.005);
    EXPECT_LT(d.rel_rmse, 0.11);
    EXPECT_GT(d.rel_rmse, 0.01);  // it is coarser
}

// Stained glass: no colour runs into the one beside it.
TEST_P(Specular, ACoarserGridKeepsColoursOfGlassApart) {
    if (GetParam() == EmcRays::maps) {
        GTEST_SKIP() << "through the maps panes are as fine as texels";
    }
    const Pane pane(kPaneEye, kPaneTarget);
    const FrameScene scene =
        room(strips(pane.corner, pane.right, pane.up, 250),
             {Pane::material(vec3(0.9f, 0.2f, 0.1f)), Pane::material(vec3(0.1f, 0.3f, 0.9f))}, kPaneEye,
             kPaneTarget);
    const Deviation d = coarser(picture(scene, 2, 2), picture(scene), "stained glass");
    EXPECT_NEAR(d.mean, 1, 0.005);
    EXPECT_LT(d.rel_rmse, 0.15);
}

// Each ray takes one direction of the lobe of rough glass: no pixel shows fewer of them than all sixteen.
TEST_P(Specular, ACoarserGridShowsTheSameThroughRoughGlass) {
    if (GetParam() == EmcRays::maps) {
        GTEST_SKIP() << "through the maps glass is clear";
    }
    const Pane pane(kPaneEye, kPaneTarget);
    Material frosted = Pane::material(vec3(1));
    frosted.roughness = 0.4f;
    const FrameScene scene =
        room({quad(pane.corner, pane.right, pane.up, 0)}, {frosted}, kPaneEye, kPaneTarget);
    const Deviation d = coarser(picture(scene, 2, 2), picture(scene), "rough glass");
    EXPECT_NEAR(d.mean, 1, 0.005);
    EXPECT_LT(d.rel_rmse, 0.12);
}

}  // namespace
}  // namespace lanthorn::gi::test

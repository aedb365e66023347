// `drm` at the ends of its ranges: clear, bounded, nothing that is not a number.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/gpu/drm/drm_bench.h"
#include "tests/support/closed_forms.h"

namespace lanthorn::gi::test {
namespace drm_extremes_test {

constexpr ivec2 kSize(48);

TEST(DrmExtremes, MLargerThanTheMap) {
    DrmBench coarse, fine;
    coarse.set_shadow_resolution(16);  // a cube face: M = 16 asks for as many texels
    coarse.drm().samples = fine.drm().samples = 16;
    coarse.drm().texels = 1;  // fewer than samples: a sample has one all the same
    fine.drm().texels = 128;
    const double a = mean_of(coarse.frame(room_with_block(), kSize)),
                 b = mean_of(fine.frame(room_with_block(), kSize));
    EXPECT_EQ(coarse.now().samples, 256);
    EXPECT_EQ(coarse.technique().statistics(false).nan_count, 0u);
    EXPECT_NEAR(a / b, 1, 0.05);
}

TEST(DrmExtremes, ALightWithoutPowerSendsNothing) {
    DrmBench bench;
    FrameScene scene = room_with_block();
    scene.lights[0].light.intensity = 0;
    EXPECT_EQ(mean_of(bench.frame(scene, kSize)), 0);
    EXPECT_EQ(bench.now().samples, 0);
    // And with power it does, in the next frame.
    hold_still(scene);
    scene.lights[0].light.intensity = 100;
    scene.changes.lights = true;
    EXPECT_GT(mean_of(bench.frame(scene, kSize)), 1);
    hold_still(scene);
    scene.lights[0].light.intensity = 0;
    scene.changes.lights = true;
    EXPECT_EQ(mean_of(bench.frame(scene, kSize)), 0);
}

TEST(DrmExtremes, NoLight) {
    DrmBench bench;
    FrameScene scene = room_with_block();
    scene.lights.clear();
    EXPECT_EQ(mean_of(bench.frame(scene, kSize)), 0);
    EXPECT_EQ(bench.now().pictures, 0);
    FrameScene lit = room_with_block();
    hold_still(lit);
    lit.changes.lights = true;
    EXPECT_GT(mean_of(bench.frame(lit, kSize)), 1);
}

TEST(DrmExtremes, OneVertex) {
    Mesh dot;
    dot.vertices.resize(1);
    dot.indices = {0, 0, 0};
    dot.bounds.add(vec3(0));
    FrameScene scene =
        scene_of({dot}, {lambertian(vec3(0.8f))}, {point_light(vec3(0, 1, 0), 100)}, vec3(0, 0, 2), vec3(0));
    DrmBench bench;
    EXPECT_EQ(mean_of(bench.frame(scene, kSize)), 0);
    EXPECT_EQ(bench.technique().statistics(false).nan_count, 0u);
}

TEST(DrmExtremes, NoGeometry) {
    FrameScene scene;
    scene.assets = std::make_shared<SceneAssets>();
    scene.lights = {point_light(vec3(0), 100)};
    DrmBench bench;
    EXPECT_EQ(mean_of(bench.frame(scene, kSize)), 0);
}

// A lamp on a wall, and one in the room's corner: light that grazes, samples that touch what they light.
TEST(DrmExtremes, ALampThatTouchesAWall) {
    for (const float off : {1e-6f, 1e-3f, 0.0f}) {
        for (const SolidAngle kind :
             {SolidAngle::eq_14, SolidAngle::disc, SolidAngle::eq_15, SolidAngle::eq_11, SolidAngle::eq_13}) {
            DrmBench bench;
            bench.drm().visibility = DrmVisibility::maps;
            bench.drm().second = 2;
            bench.drm().solid_angle = kind;
            const double mean = mean_of(bench.frame(room_with_block(vec3(off, 2.6f - off, off)), kSize));
            EXPECT_TRUE(std::isfinite(mean));
            EXPECT_EQ(bench.technique().statistics(false).nan_count, 0u);
        }
    }
}

// The same room at other scales: the same light.
TEST(DrmExtremes, ARoomOfAnySize) {
    std::vector<double> means;
    for (const float size : {1e-3f, 1.0f, 1e4f}) {
        DrmBench bench;
        means.push_back(mean_of(bench.frame(closed_sphere(0.5f, size), kSize)));
    }
    EXPECT_NEAR(means[0] / means[1], 1, 0.01);
    EXPECT_NEAR(means[2] / means[1], 1, 0.01);
}

// As bright as floats hold: it is bounded, or counted and left out.
TEST(DrmExtremes, ALampOfAnyBrightness) {
    for (const float candela : {1e-30f, 1e30f, 3e38f, std::numeric_limits<float>::infinity(),
                                std::numeric_limits<float>::quiet_NaN()}) {
        DrmBench bench;
        FrameScene scene = room_with_block();
        scene.lights[0].light.intensity = candela;
        mean_of(bench.frame(scene, kSize));
    }
}

TEST(DrmExtremes, SixteenLampsOfSixteenSquared) {
    DrmBench bench;
    bench.drm().samples = 16;
    bench.drm().lights = 256;
    bench.drm().visibility = DrmVisibility::maps;
    bench.drm().second = 1;
    FrameScene scene = room_with_block();
    for (std::uint32_t i = 1; i < 16; ++i) {
        LightInstance lamp = scene.lights[0];
        lamp.id += i;
        lamp.position.x += 0.2f * static_cast<float>(i);
        scene.lights.push_back(lamp);
    }
    EXPECT_GT(mean_of(bench.frame(scene, kSize)), 1);
    EXPECT_EQ(bench.now().sample_pictures, 256);     // of the strongest
    EXPECT_EQ(bench.now().samples, 16 * 256 + 256);  // beyond the uniform block
}

}  // namespace drm_extremes_test
}  // namespace lanthorn::gi::test

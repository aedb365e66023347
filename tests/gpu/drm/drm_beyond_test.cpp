// What `drm` can do beyond Frisvad et al. 2005: shadows of indirect light, and a second bounce.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "gi_module/techniques/drm/sample_pictures.h"
#include "tests/gpu/drm/drm_bench.h"
#include "tests/gpu/gi/path_truth.h"
#include "tests/support/closed_forms.h"

namespace lanthorn::gi::test {
namespace {

constexpr ivec2 kSize(64);
constexpr float kAlbedo = 0.6f;

// A room of 4 x 2.6 x 3 m whose far half is behind a wall with a way past it: the lamp does not see that
// half, the camera does.
FrameScene alcove() {
    return scene_of(
        {box(vec3(0), vec3(4, 2.6f, 3), true, 0), box(vec3(1.9f, 0, 0), vec3(2.1f, 2.6f, 2.1f), false, 1)},
        {lambertian(vec3(0.7f)), lambertian(vec3(0.6f, 0.5f, 0.4f))},
        {point_light(vec3(0.9f, 1.9f, 1.0f), 100)}, vec3(3.8f, 1.6f, 2.8f), vec3(2.4f, 0.8f, 0.4f));
}

Deviation of(const FrameScene& scene, const Truth& truth, int side, DrmVisibility visibility, int second) {
    DrmBench bench;
    bench.drm().samples = side;
    bench.drm().visibility = visibility;
    bench.drm().second = second;
    const Deviation d = against(bench.frame(scene, kSize), truth);
    std::printf("drm, alcove, %s, second %d: flux %.3f, relRMSE %.3f\n",
                visibility == DrmVisibility::maps ? "maps" : "none", second, d.mean, d.rel_rmse);
    return d;
}

TEST(DrmBeyond, SamplesBehindAWallAreHidden) {
    const FrameScene scene = alcove();
    const Truth truth = path_traced(scene, kSize, 1, 256);
    const Deviation none = of(scene, truth, 8, DrmVisibility::none, 0),
                    maps = of(scene, truth, 8, DrmVisibility::maps, 0);
    EXPECT_GT(none.mean, 1.5) << "the wall hides much";
    EXPECT_LT(maps.rel_rmse, 0.5 * none.rel_rmse);
    EXPECT_NEAR(maps.mean, 1, 0.2);
}

TEST(DrmBeyond, ASecondBounceReachesWhereOneDoesNot) {
    const FrameScene scene = alcove();
    const Truth truth = path_traced(scene, kSize, 2, 256);
    const Deviation one = of(scene, truth, 4, DrmVisibility::maps, 0),
                    two = of(scene, truth, 4, DrmVisibility::maps, 3);
    EXPECT_LT(std::abs(two.mean - 1), std::abs(one.mean - 1));
    EXPECT_LT(two.rel_rmse, 0.7 * one.rel_rmse);
}

// A sphere hides nothing from itself.
TEST(DrmBeyond, NoSampleHidesFromWhatSeesIt) {
    const FrameScene scene = closed_sphere(kAlbedo);
    for (const int side : {3, 8}) {
        DrmBench bench;
        bench.drm().samples = side;
        const double open = deviation_of(bench.frame(scene, kSize), 1).mean;
        bench.drm().visibility = DrmVisibility::maps;
        FrameScene still = scene;
        hold_still(still);
        const double hidden = deviation_of(bench.frame(still, kSize), 1).mean;
        std::printf("drm, closed sphere, M = %d: %.4f of the light is seen\n", side, hidden / open);
        EXPECT_NEAR(hidden / open, 1, 0.02);
        EXPECT_EQ(bench.now().sample_pictures, side * side);
    }
}

// Inside of a sphere the second bounce is the first one's light times the albedo. What an equation leaves of
// the light is known (drm_closed_forms_test.cpp) by the number of its samples, of a picture's 16 as of a
// lamp's 64.
double share_of(SolidAngle kind, double samples) {
    const double a = (kind == SolidAngle::disc ? 1 : support::kPiD) / samples;
    return kind == SolidAngle::eq_13 ? 1 : 1 - a * std::log(1 + 1 / a);
}

TEST(DrmBeyond, ASpheresSecondBounceIsItsFirstTimesTheAlbedo) {
    const FrameScene scene = closed_sphere(kAlbedo);
    for (const SolidAngle kind : {SolidAngle::eq_13, SolidAngle::eq_14, SolidAngle::disc}) {
        DrmBench bench;
        bench.drm().samples = 8;
        bench.drm().solid_angle = kind;
        const double first = deviation_of(bench.frame(scene, kSize), 1).mean;
        bench.drm().second = 4;
        FrameScene still = scene;
        hold_still(still);
        const double both = deviation_of(bench.frame(still, kSize), 1).mean;
        std::printf("drm, closed sphere, solid angle %d: second bounce %.4f of the first\n",
                    static_cast<int>(kind), both / first - 1);
        const double expected = static_cast<double>(kAlbedo) * share_of(kind, 16) / share_of(kind, 64);
        EXPECT_NEAR((both / first - 1) / expected, 1, 0.04);
        EXPECT_EQ(bench.now().samples, 64 + 64 * 16);
    }
}

// What samples are by eqs. 11 and 15 is undone before they shine on.
TEST(DrmBeyond, EveryEquationSendsTheSameLightOn) {
    const FrameScene scene = room_with_block();
    std::vector<double> lumen;
    for (const SolidAngle kind : {SolidAngle::eq_14, SolidAngle::eq_15, SolidAngle::eq_11}) {
        DrmBench bench;
        bench.drm().solid_angle = kind;
        bench.drm().second = 1;
        bench.drm().mips = DrmMips::none;
        bench.frame(scene, kSize);
        std::vector<RadianceSample> samples = bench.at_work().map().read();
        samples.resize(9);
        double sum = 0;
        for (const render::LightData& light :
             pictures_of_samples(samples, kind, scene.diagonal(), 9).lights) {
            sum += static_cast<double>(light.intensity.y * light.area);
        }
        lumen.push_back(sum);
    }
    EXPECT_NEAR(lumen[1] / lumen[0], 1, 0.001);
    EXPECT_NEAR(lumen[2] / lumen[0], 1, 0.001);
}

}  // namespace
}  // namespace lanthorn::gi::test

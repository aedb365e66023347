// A ball inside a closed sphere of albedo rho with a light of I cd in its centre: the walls look the same
// from everywhere, so each point of the ball gets, after b reflections, the light that a wall sends out,
// rho^b * I / r^2 (the radiosity of a closed sphere, Jacquez and Kuppenheim 1955), if the ball is small. It
// is far narrower than a splat, and round.
#include <gtest/gtest.h>

#include "lanthorn/emc/emc_settings.h"
#include "tests/gpu/gi/test_scene.h"
#include "tests/support/closed_forms.h"

namespace lanthorn::gi::test {
namespace small_ball_test {

constexpr float kLux = 100;  // on the walls, directly

FrameScene ball_in_a_sphere(float radius) {
    const vec3 place(0.4f, 0, -0.3f);
    FrameScene scene = scene_of({inward_sphere(1, 4, 0), support::sphere(place, radius, 3, false, 1)},
                                {lambertian(vec3(0.5f)), lambertian(vec3(0))}, {point_light(vec3(0), kLux)},
                                place + vec3(0, 0, 0.6f), place);
    // A square inside the ball's outline: pixels of the ball alone.
    look_closely(scene, place + vec3(0, 0, 0.6f), place, 0.6f * radius);
    return scene;
}

// Radius in m, and the most that relRMSE may be: few photons fall on little balls.
class SmallBall : public ::testing::TestWithParam<std::pair<float, double>> {};

TEST_P(SmallBall, GetsWhatTheWallsSendOut) {
    const auto [radius, limit] = GetParam();
    const double expected = support::sphere_irradiance(kLux, 1, 0.5, 2);
    double mean = 0;
    double error = 0;
    constexpr int kSeeds = 4;
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
        Bench bench;
        bench.settings.bounces = 2;
        bench.settings.seed = seed;
        bench.settings.edit<EmcSettings>().steps =
            256;  // so that photons do not step past the ball; this is about gathering them
        const Deviation a = deviation_of(bench.frame(ball_in_a_sphere(radius), ivec2(64)), expected);
        mean += a.mean / kSeeds;
        error = std::max(error, a.rel_rmse);
    }
    std::printf("ball of %g m: mean %.4f, largest relRMSE %.4f\n", static_cast<double>(radius), mean, error);
    EXPECT_NEAR(mean, 1, 0.06);
    EXPECT_LT(error, limit);
}

INSTANTIATE_TEST_SUITE_P(Radii, SmallBall,
                         ::testing::Values(std::pair(0.05f, 0.55), std::pair(0.1f, 0.25),
                                           std::pair(0.2f, 0.22)));

}  // namespace small_ball_test
}  // namespace lanthorn::gi::test

// Inside of a sphere that glows with radiance L and reflects rho: E = pi L (rho + rho^2 + ... + rho^n) after
// 1 to n reflections (Kirchhoff's cavity; Pharr, Jakob and Humphreys 2023, sec. 14.1).
#include <gtest/gtest.h>

#include "tests/gpu/gi/test_scene.h"
#include "tests/support/closed_forms.h"

namespace lanthorn::gi::test {
namespace {

constexpr float kNits = 10;

class GlowingCavity : public ::testing::TestWithParam<std::tuple<int, float>> {};

TEST_P(GlowingCavity, IsTheGeometricSeries) {
    const auto [bounces, albedo] = GetParam();
    Material walls = lambertian(vec3(albedo));
    walls.emissive = vec3(kNits);
    FrameScene scene = scene_of({inward_sphere(1, 4, 0)}, {walls}, {}, vec3(0.2f), vec3(0, 0, -1));
    scene.camera.camera.y_fov = 1.4f;
    const double direct =
        support::kPiD * static_cast<double>(kNits);  // what a centred light of pi L r^2 gives
    const double expected = support::sphere_irradiance(direct, 1, static_cast<double>(albedo), bounces);
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
        Bench bench;
        bench.settings.bounces = bounces;
        bench.settings.seed = seed;
        const Deviation a = deviation_of(bench.frame(scene, ivec2(128)), expected);
        std::printf("glowing cavity, albedo %g, %d bounces, seed %u: mean %.4f, relRMSE %.4f\n",
                    static_cast<double>(albedo), bounces, seed, a.mean, a.rel_rmse);
        EXPECT_NEAR(a.mean, 1, bounces == 1 ? 0.05 : 0.03) << "seed " << seed;
        EXPECT_LT(a.rel_rmse, bounces == 1 ? 0.165 : 0.105) << "seed " << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(Albedos, GlowingCavity,
                         ::testing::Combine(::testing::Values(1, 3), ::testing::Values(0.5f, 0.9f)));

}  // namespace
}  // namespace lanthorn::gi::test

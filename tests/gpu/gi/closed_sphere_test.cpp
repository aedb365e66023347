// Inside a closed sphere of albedo rho with a point light of I cd at its centre, every point gets I / r^2
// directly and rho^b * I / r^2 after b reflections: the answer is exact, whatever the geometry in between
// (the form factor between any two points of a sphere is the same; Jacquez and Kuppenheim 1955, integrating
// sphere theory).
#include <gtest/gtest.h>

#include <map>

#include "tests/gpu/gi/test_scene.h"
#include "tests/support/closed_forms.h"

namespace lanthorn::gi::test {
namespace {

// Bounces add up independent noise, so that more of them show less.
double noise_limit(int bounces) {
    return bounces == 1 ? 0.14 : bounces == 2 ? 0.12 : 0.095;
}

class ClosedSphere : public ::testing::TestWithParam<std::tuple<int, float>> {};

TEST_P(ClosedSphere, IndirectIrradianceIsTheGeometricSeries) {
    const auto [bounces, albedo] = GetParam();
    const double expected = support::sphere_irradiance(kSphereLux, 1, static_cast<double>(albedo), bounces);
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
        Bench bench;
        bench.settings.bounces = bounces;
        bench.settings.seed = seed;
        const Deviation a = deviation_of(bench.frame(closed_sphere(albedo), ivec2(128)), expected);
        std::printf("closed sphere, albedo %g, %d bounces, seed %u: mean %.4f, relRMSE %.4f\n",
                    static_cast<double>(albedo), bounces, seed, a.mean, a.rel_rmse);
        EXPECT_NEAR(a.mean, 1, 0.02) << "seed " << seed;
        EXPECT_LT(a.rel_rmse, noise_limit(bounces)) << "seed " << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(Bounces, ClosedSphere,
                         ::testing::Combine(::testing::Values(1, 2, 4, 8), ::testing::Values(0.5f, 0.9f)));

TEST(MorePhotons, AreLessNoise) {
    const auto noise = [](int photons) {
        Bench bench;
        bench.settings.photons = photons;
        return deviation_of(bench.frame(closed_sphere(0.5f), ivec2(64)),
                            support::sphere_irradiance(kSphereLux, 1, 0.5, 2))
            .rel_rmse;
    };
    const double few = noise(20'000), many = noise(160'000);
    std::printf("closed sphere, 20 000 photons: relRMSE %.4f, 160 000: %.4f\n", few, many);
    EXPECT_LT(many, 0.9 * few);  // 0.0429, 0.0546; with one C0 for all, 1.0 of it
}

Deviation of_four_bounces(float albedo, float radius) {
    Bench bench;
    bench.settings.bounces = 4;
    return deviation_of(bench.frame(closed_sphere(albedo, radius), ivec2(128)),
                        support::sphere_irradiance(kSphereLux, 1, static_cast<double>(albedo), 4));
}

class SphereOfAnySize : public ::testing::TestWithParam<float> {};

TEST_P(SphereOfAnySize, ShowsTheSame) {
    const float radius = GetParam();
    for (const float albedo : {0.5f, 0.9f}) {
        static std::map<float, Deviation> of_one_metre;  // by albedo; every radius is held against them
        const auto [entry, fresh] = of_one_metre.try_emplace(albedo);
        if (fresh) {
            entry->second = of_four_bounces(albedo, 1);
        }
        const Deviation a = of_four_bounces(albedo, radius), &ordinary = entry->second;
        std::printf("closed sphere of %g m, albedo %g: mean %.6f, relRMSE %.6f; of 1 m: %.6f, %.6f\n",
                    static_cast<double>(radius), static_cast<double>(albedo), a.mean, a.rel_rmse,
                    ordinary.mean, ordinary.rel_rmse);
        EXPECT_NEAR(a.mean, ordinary.mean, 1.2e-3);
        EXPECT_NEAR(a.rel_rmse, ordinary.rel_rmse, 1.3e-3);
    }
}

INSTANTIATE_TEST_SUITE_P(Radii, SphereOfAnySize, ::testing::Values(1e-3f, 1e3f));

}  // namespace
}  // namespace lanthorn::gi::test

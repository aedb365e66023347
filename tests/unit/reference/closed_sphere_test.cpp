// Inside a closed sphere of albedo rho with a point light of I cd at its centre, every point gets I / r^2
// directly and rho^b I / r^2 after b reflections, 1 / (1 - rho) times as much in all: between any two points
// of a sphere the form factor is the same (Jacquez and Kuppenheim 1955, "Theory of the Integrating Sphere",
// JOSA 45).
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/closed_forms.h"
#include "tests/unit/reference/scenes.h"

namespace lanthorn::reference::test {
namespace {

constexpr float kCandela = 100;

FrameScene closed_sphere(float albedo, float radius = 1) {
    FrameScene scene = scene_of({sphere(vec3(0), radius, 5, true, 0)}, {lambertian(vec3(albedo))},
                                {point_light(vec3(0), kCandela * radius * radius)}, vec3(0, 0, 0.5f * radius),
                                vec3(0, 0, -radius));
    scene.camera.camera.y_fov = 1.4f;
    return scene;
}

class PartialSums : public testing::TestWithParam<std::tuple<int, float>> {};

TEST_P(PartialSums, IndirectIrradianceIsTheGeometricSeries) {
    const auto [bounces, albedo] = GetParam();
    PathSettings settings;
    settings.bounces = bounces;
    settings.spp = 16;
    const double expected = support::sphere_irradiance(kCandela, 1, static_cast<double>(albedo), bounces);
    // The polyhedron is inside its sphere, by 0.05 % of the radius at most: within a tenth of that of the
    // truth.
    EXPECT_NEAR(mean_of(closed_sphere(albedo), settings, PathAov::indirect) / expected, 1, 2e-3);
}

INSTANTIATE_TEST_SUITE_P(ClosedSphere, PartialSums,
                         testing::Combine(testing::Values(1, 2, 4, 8), testing::Values(0.5f, 0.9f)));

TEST(ClosedSphere, UnlimitedBouncesGiveTheWholeSeries) {
    PathSettings settings;
    settings.unlimited = true;
    settings.spp = 64;
    for (const float albedo : {0.5f, 0.9f}) {
        const double expected = kCandela * static_cast<double>(albedo) / (1 - static_cast<double>(albedo));
        EXPECT_NEAR(mean_of(closed_sphere(albedo), settings, PathAov::indirect) / expected, 1, 0.01)
            << albedo;
    }
}

// The light grows with the square of the radius, so that the answer stays.
TEST(ClosedSphere, AnySizeWillDo) {
    PathSettings settings;
    settings.bounces = 4;
    settings.spp = 16;
    const double expected = mean_of(closed_sphere(0.5f), settings, PathAov::indirect);
    for (const float radius : {1e-4f, 1e-2f, 1e3f, 1e5f}) {
        EXPECT_NEAR(mean_of(closed_sphere(0.5f, radius), settings, PathAov::indirect) / expected, 1, 1e-3)
            << radius;
    }
}

TEST(ClosedSphere, FullTransportOfADiffuseMaterialIsTheSame) {
    PathSettings settings;
    settings.bounces = 4;
    settings.spp = 32;
    const double diffuse = mean_of(closed_sphere(0.5f), settings, PathAov::indirect);
    settings.transport = Transport::full;
    EXPECT_NEAR(mean_of(closed_sphere(0.5f), settings, PathAov::indirect) / diffuse, 1, 2e-3);
}

}  // namespace
}  // namespace lanthorn::reference::test

// White furnaces: where light of the same radiance comes from everywhere, a surface of albedo rho shows rho
// times that radiance, whatever its shape (Kirchhoff's cavity; Pharr, Jakob and Humphreys 2023, sec. 14.1).
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/reference/scenes.h"

namespace lanthorn::reference::test {
namespace furnace_test {

constexpr float kNits = 10;

class WhiteFurnace : public testing::TestWithParam<std::tuple<float, Transport>> {};

// A ball that fills the picture, in a black sphere that glows.
TEST_P(WhiteFurnace, AConvexBallShowsItsAlbedo) {
    const auto [albedo, transport] = GetParam();
    FrameScene scene = scene_of({sphere(vec3(0), 10, 4, true, 0), sphere(vec3(0, 0, -3), 1, 4, false, 1)},
                                {lamp(vec3(kNits)), lambertian(vec3(albedo))}, {}, vec3(0), vec3(0, 0, -1));
    scene.camera.camera.y_fov = 0.4f;
    PathSettings settings;
    settings.transport = transport;
    settings.spp = 64;
    // Radiance is emission and reflection; `direct` is the reflection of emission.
    EXPECT_NEAR(mean_of(scene, settings, PathAov::direct) / (albedo * kNits), 1, 4e-3);
    EXPECT_NEAR(mean_of(scene, settings, PathAov::radiance) / (albedo * kNits), 1, 4e-3);
}

// Inside of a sphere that glows and reflects: the radiance after n reflections is the sum of albedo^k, k =
// 0..n.
TEST_P(WhiteFurnace, AGlowingCavityIsTheGeometricSeries) {
    const auto [albedo, transport] = GetParam();
    Material walls = lambertian(vec3(albedo));
    walls.emissive = vec3(kNits);
    FrameScene scene = scene_of({sphere(vec3(0), 1, 4, true, 0)}, {walls}, {}, vec3(0.2f), vec3(0, 0, -1));
    PathSettings settings;
    settings.transport = transport;
    settings.bounces = 3;
    settings.spp = 32;
    double reflected = 0;
    for (int k = 1; k <= settings.bounces; ++k) {
        reflected += std::pow(albedo, k);
    }
    EXPECT_NEAR(mean_of(scene, settings, PathAov::indirect) / (kPi * kNits * reflected), 1, 3e-3);
    const double all = 1 + reflected + std::pow(albedo, settings.bounces + 1);
    EXPECT_NEAR(mean_of(scene, settings, PathAov::radiance) / (kNits * all), 1, 3e-3);
}

INSTANTIATE_TEST_SUITE_P(Albedos, WhiteFurnace,
                         testing::Combine(testing::Values(0.5f, 0.9f, 1.0f),
                                          testing::Values(Transport::diffuse, Transport::full)));

// A surface that shines to both sides of itself lights both.
TEST(Furnace, DoubleSidedLampsLightBothSides) {
    Material panel = lamp(vec3(kNits));
    const auto lit = [&](float height) {
        FrameScene scene = scene_of({quad({-50, 1, 50}, {100, 0, 0}, {0, 0, -100}, 0),
                                     quad({-50, 0, 50}, {100, 0, 0}, {0, 0, -100}, 1)},
                                    {panel, lambertian(vec3(0.5f))}, {}, vec3(0), vec3(0, 0, 1));
        look_closely(scene, vec3(0, height, 0), vec3(0), 0.1f);
        PathSettings settings;
        return mean_of(scene, settings, PathAov::direct);
    };
    EXPECT_EQ(lit(0.5f), 0) << "the panel's front is above";
    panel.double_sided = true;
    EXPECT_NEAR(lit(0.5f) / (0.5f * kNits), 1, 0.01) << "a plane as good as infinite: E = pi L";
}

}  // namespace furnace_test
}  // namespace lanthorn::reference::test

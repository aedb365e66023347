// Light in thin air against what single scattering is on paper.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/gpu/render/scenes.h"

namespace lanthorn {
namespace air_test {

constexpr ivec2 kSize(64, 64);
constexpr float kScattering = 0.01f, kWall = 10, kCandela = 500;

// Looks from 0 along -Z at a black wall kWall metres away, which throws nothing back.
testing::SceneBuilder view() {
    testing::SceneBuilder b;
    b.add_quad(b.add_lambert(vec3(0)), vec3(0, 0, -kWall), vec3(30, 0, 0), vec3(0, 30, 0));
    b.look(vec3(0), vec3(0, 0, -1), 0.02f);  // nearly one ray
    return b;
}

double seen(const testing::SceneBuilder& b, float scattering, int steps, ivec2 size = kSize) {
    testing::context();
    render::FrameRenderer renderer;
    renderer.settings.air_scattering = scattering;
    renderer.settings.air_steps = steps;
    testing::render_once(renderer, b.build(), size);
    const std::vector<float> radiance = renderer.read(render::Aov::radiance).pixels;
    double sum = 0;
    for (std::size_t i = 0; i < radiance.size(); i += 3) {
        sum += static_cast<double>(radiance[i]);
    }
    return sum / static_cast<double>(radiance.size() / 3);
}

// Of a lamp `height` metres beside the ray, abreast of it `at` metres away, from `from` to `to` metres:
// scattering / (4 pi) * I / h * (the angle that it sees that piece of the ray by).
double on_paper(double height, double at, double from, double to) {
    return kScattering / (4 * 3.14159265358979) * kCandela / height *
           (std::atan((to - at) / height) - std::atan((from - at) / height));
}

TEST(Air, OffTheAirIsBlack) {
    testing::SceneBuilder b = view();
    b.add_point({0, 2, -5}, kCandela);
    EXPECT_EQ(seen(b, 0, 8), 0);
}

TEST(Air, APointLampIsExactWithAnyNumberOfSteps) {
    for (const double height : {0.3, 2.0, 8.0}) {
        testing::SceneBuilder b = view();
        b.add_point({0, height, -5}, kCandela);
        const double expected = on_paper(height, 5, 0, kWall);
        for (const int steps : {1, 3, 16}) {
            EXPECT_NEAR(seen(b, kScattering, steps) / expected, 1, 0.02) << height << " m, " << steps;
        }
    }
}

TEST(Air, ASpotLightsTheRayWithinItsConeAlone) {
    testing::SceneBuilder b = view();
    const float half = 0.2f, height = 2;
    b.add_spot({0, height, -5}, {0, -1, 0}, kCandela, half - 0.002f, half);
    const double reach = height * std::tan(half);
    EXPECT_NEAR(seen(b, kScattering, 8) / on_paper(height, 5, 5 - reach, 5 + reach), 1, 0.03);
    // Along the beam's own way.
    testing::SceneBuilder along = view();
    along.add_spot({0, 0.5f, 0}, {0, 0, -1}, kCandela, half - 0.002f, half);
    const double begin = 0.5 / std::tan(half);
    EXPECT_NEAR(seen(along, kScattering, 8) / on_paper(0.5, 0, begin, kWall), 1, 0.04);
    testing::SceneBuilder away = view();
    away.add_spot({0, height, -5}, {0, 1, 0}, kCandela, half - 0.002f, half);
    EXPECT_EQ(seen(away, kScattering, 8), 0);
}

TEST(Air, WhatStandsInTheLightHasAShadowInAir) {
    testing::SceneBuilder b = view();
    b.add_point({0, 2, -5}, kCandela);
    // Between lamp and ray, over the half of the ray that is nearer.
    b.add_quad(b.add_lambert(vec3(0)), {0, 1, -2.5f}, {20, 0, 0}, {0, 0, -2.5f});
    const double expected = on_paper(2, 5, 5, kWall);
    EXPECT_NEAR(seen(b, kScattering, 32) / expected, 1, 0.06);
}

TEST(Air, ADirectionalLampFillsTheRay) {
    testing::SceneBuilder b = view();
    b.add_directional({0, -1, 0}, 40);
    const double expected = kScattering / (4 * 3.14159265358979) * 40 * kWall;
    EXPECT_NEAR(seen(b, kScattering, 8) / expected, 1, 0.03);
}

}  // namespace air_test
}  // namespace lanthorn

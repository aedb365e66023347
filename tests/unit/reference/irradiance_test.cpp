// Irradiance of one light on a plane by closed forms. The plane is Lambertian, so that E = pi L / albedo.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/closed_forms.h"
#include "tests/unit/reference/scenes.h"

namespace lanthorn::reference::test {
namespace {

using support::kPiD;
using support::parallel_corner;

constexpr float kAlbedo = 0.5f;

Mesh floor_mesh() {
    return quad({-20, 0, 20}, {40, 0, 0}, {0, 0, -40}, 0);
}

// At the world's origin, on a floor that faces up.
double irradiance(std::vector<LightInstance> lights, std::vector<Mesh> lamps = {}, float nits = 0,
                  int spp = 256) {
    std::vector<Mesh> meshes{floor_mesh()};
    meshes.insert(meshes.end(), lamps.begin(), lamps.end());
    FrameScene scene = scene_of(meshes, {lambertian(vec3(kAlbedo)), lamp(vec3(nits))}, std::move(lights),
                                vec3(0, 1, 0), vec3(0));
    look_closely(scene, vec3(0, 0.5f, 0.5f), vec3(0), 1e-4f);
    PathSettings settings;
    settings.spp = spp;
    return mean_of(scene, settings, PathAov::direct, ivec2(4)) * kPiD / static_cast<double>(kAlbedo);
}

// I cos / d^2 (Lambert 1760; CIE S 017).
TEST(Irradiance, PointLightByTheInverseSquareLaw) {
    for (const vec3& p : {vec3(0, 2, 0), vec3(3, 1, -2), vec3(0, 0.01f, 0.5f)}) {
        const double d2 = glm::dot(dvec3(p), dvec3(p));
        const double expected = 90 * static_cast<double>(p.y) / std::sqrt(d2) / d2;
        EXPECT_NEAR(irradiance({point_light(p, 90)}) / expected, 1, 2e-3);
    }
}

// KHR_lights_punctual: clamp(1 - (d / range)^4, 0, 1).
TEST(Irradiance, RangeIsAWindow) {
    LightInstance light = point_light(vec3(0, 2, 0), 90);
    light.light.range = 2.5f;
    EXPECT_NEAR(irradiance({light}), 90.0 / 4 * support::range_window(2, 2.5), 0.01);
    light.light.range = 1.9f;
    EXPECT_EQ(irradiance({light}), 0);
}

// KHR_lights_punctual: the square of a linear ramp in the cosine, from the outer cone to the inner one.
TEST(Irradiance, SpotLightByItsCone) {
    const auto expected = [](float angle) {
        return support::spot_cone(std::cos(static_cast<double>(angle)), 0.3, 0.6) * 90 / 4;
    };
    for (const float angle : {0.0f, 0.2f, 0.45f, 0.55f, 0.7f}) {
        const vec3 aim(std::sin(angle), -std::cos(angle), 0);
        const double e = irradiance({spot_light(vec3(0, 2, 0), aim, 90, 0.3f, 0.6f)});
        EXPECT_NEAR(e, expected(angle), 0.02) << angle;
    }
}

// E cos.
TEST(Irradiance, DirectionalLightByTheCosine) {
    EXPECT_NEAR(irradiance({directional_light({0, -1, 0}, 1000)}), 1000, 0.1);
    EXPECT_NEAR(irradiance({directional_light({std::sqrt(3.0f), -1, 0}, 1000)}), 500, 0.1);
    EXPECT_EQ(irradiance({directional_light({0, 1, 0}, 1000)}), 0) << "from below";
}

// Howell, B-3.
TEST(Irradiance, ParallelRectangle) {
    // Four corners meet above the point: at heights from far to almost touching.
    for (const float h : {5.0f, 1.0f, 0.1f, 0.01f}) {
        const Mesh panel = quad({-1.5f, h, -0.5f}, {3, 0, 0}, {0, 0, 1}, 1);
        const double expected = 100 * kPiD * 4 * parallel_corner(1.5, 0.5, static_cast<double>(h));
        EXPECT_NEAR(irradiance({}, {panel}, 100) / expected, 1, 0.01) << h;
    }
}

// Howell, B-4.
TEST(Irradiance, PerpendicularRectangle) {
    const double factor = support::perpendicular_corner(2, 1.5, 0.75);
    const Mesh wall = quad({0, 0, -0.75f}, {1.5f, 0, 0}, {0, 2, 0}, 1);
    EXPECT_NEAR(irradiance({}, {wall}, 100) / (100 * kPiD * factor), 1, 0.01);
}

// Many lamps drawn by chance add up as they should.
TEST(Irradiance, LightsAddUp) {
    std::vector<LightInstance> lights;
    double expected = 0;
    for (int i = 0; i < 20; ++i) {
        const vec3 p(0.5f * static_cast<float>(i % 5), 1.0f + 0.2f * static_cast<float>(i),
                     0.3f * static_cast<float>(i % 3));
        lights.push_back(point_light(p, 10.0f + 5.0f * static_cast<float>(i)));
        const double d2 = glm::dot(dvec3(p), dvec3(p));
        expected += (10.0 + 5.0 * i) * static_cast<double>(p.y) / std::sqrt(d2) / d2;
    }
    EXPECT_NEAR(irradiance(lights, {}, 0, 2048) / expected, 1, 0.01);
}

// What the path tracer finds by chance alone - light after one reflection - against the same integral by
// hand: a floor lit evenly from straight above, seen by the underside of a ceiling: E = rho E0 F, F of a
// square seen from its middle.
TEST(Irradiance, OneReflectionOffAnEvenlyLitSquare) {
    const Mesh square = quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, 0);
    const Mesh ceiling = quad({-1, 1, -1}, {2, 0, 0}, {0, 0, 2}, 1);
    FrameScene scene = scene_of({square, ceiling}, {lambertian(vec3(0.8f)), lambertian(vec3(0))}, {},
                                vec3(0, 0.1f, 0), vec3(0, 1, 0));
    // Slanting, so that the ceiling casts its shadow elsewhere; far enough for that.
    LightInstance sun = directional_light({10, -1, 0}, 1000);
    scene.lights = {sun};
    look_closely(scene, vec3(0, 0.5f, 0), vec3(0, 1, 0), 1e-4f);
    PathSettings settings;
    settings.bounces = 1;
    settings.spp = 4096;
    const double lit = 1000 / std::sqrt(101.0);
    const double expected = 0.8 * lit * 4 * parallel_corner(1, 1, 1);
    EXPECT_NEAR(mean_of(scene, settings, PathAov::indirect, ivec2(4)) / expected, 1, 0.01);
}

}  // namespace
}  // namespace lanthorn::reference::test

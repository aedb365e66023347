// Light of the sky, held to closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "gi_module/reference/sky_light.h"
#include "tests/unit/reference/scenes.h"

namespace lanthorn::reference::test {
namespace sky_test {

constexpr double kPiD = 3.14159265358979323846;
constexpr float kNits = 10;

SkyInstance even_sky() {
    return sky_of(kNits, [](const vec3&) { return true; });
}

FrameScene ball(float albedo) {
    FrameScene scene = scene_of({sphere(vec3(0, 0, -3), 1, 4, false, 0)}, {lambertian(vec3(albedo))}, {},
                                vec3(0), vec3(0, 0, -1));
    scene.camera.camera.y_fov = 0.4f;
    return scene;
}

TEST(SkyLight, DrawsWithTheDensityThatItStates) {
    FrameScene scene = ball(0.5f);
    scene.sky = sky_of(kNits, [](const vec3& d) { return d.x > 0.8f; });
    scene.sky->to_sky = mat3(glm::mat3_cast(glm::angleAxis(0.7f, glm::normalize(vec3(1, 2, 3)))));
    const SkyLight sky(scene);
    double inverse = 0, flux = 0;
    constexpr int kDraws = 40000;
    for (int i = 0; i < kDraws; ++i) {
        // R2 (Roberts 2018).
        const vec2 u(std::fmod((i + 0.5) * 0.7548776662466927, 1.0),
                     std::fmod((i + 0.5) * 0.5698402909980532, 1.0));
        const SkyLight::Sample sample = sky.draw(u);
        ASSERT_NEAR(glm::length(sample.direction), 1, 1e-5);
        ASSERT_NEAR(sky.density(sample.direction) / sample.density, 1, 1e-3);
        inverse += 1 / static_cast<double>(sample.density) / kDraws;
        flux += static_cast<double>(sample.radiance.x / sample.density) / kDraws;
    }
    EXPECT_NEAR(inverse / (4 * kPiD), 1, 0.02) << "all of the sphere";
    EXPECT_NEAR(flux / (2 * kPiD * 0.2 * static_cast<double>(kNits)), 1, 0.03) << "a cap of height 1 - 0.8";
}

// Of a thin wall without reflection all light comes through, once on the way into the ball and once, through
// the backs of its single-sided triangles, on the way out. GGX loses little of it at this roughness.
TEST(SkyLight, ShinesThroughARoughBall) {
    Material frosted = lambertian(vec3(1));
    frosted.transmission = 1;
    frosted.roughness = 0.3f;
    FrameScene scene =
        scene_of({sphere(vec3(0, 0, -3), 1, 4, false, 0)}, {frosted}, {}, vec3(0), vec3(0, 0, -1));
    scene.camera.camera.y_fov = 0.3f;
    scene.sky = even_sky();
    PathSettings settings;
    settings.spp = 64;
    settings.transport = Transport::full;
    settings.unlimited = true;
    const double shown = mean_of(scene, settings, PathAov::radiance) / static_cast<double>(kNits);
    EXPECT_GT(shown, 0.97);
    EXPECT_LT(shown, 1.005);
}

// Under a sky of radiance L everywhere the irradiance of what is convex is pi L, and it shows albedo L.
TEST(SkyLight, LightsAConvexBallEvenly) {
    FrameScene scene = ball(0.5f);
    scene.sky = even_sky();
    PathSettings settings;
    settings.spp = 64;
    EXPECT_NEAR(mean_of(scene, settings, PathAov::indirect) / (kPiD * static_cast<double>(kNits)), 1, 4e-3);
    EXPECT_NEAR(mean_of(scene, settings, PathAov::direct), 0, 1e-9) << "diffuse transport: indirect light";
    for (const Transport transport : {Transport::diffuse, Transport::full}) {
        settings.transport = transport;
        EXPECT_NEAR(mean_of(scene, settings, PathAov::radiance) / (0.5 * static_cast<double>(kNits)), 1,
                    6e-3);
    }
}

// Half a sky: a floor that faces it gets all its light, one that is square to its edge half of it.
TEST(SkyLight, IsTurnedWithItsNode) {
    const auto irradiance = [](const mat3& to_sky) {
        FrameScene scene = scene_of({quad({-20, 0, 20}, {40, 0, 0}, {0, 0, -40}, 0)},
                                    {lambertian(vec3(0.5f))}, {}, vec3(0, 1, 0), vec3(0));
        look_closely(scene, vec3(0, 0.5f, 0.5f), vec3(0), 1e-4f);
        scene.sky = sky_of(kNits, [](const vec3& d) { return d.y > 0; });
        scene.sky->to_sky = to_sky;
        PathSettings settings;
        settings.spp = 512;
        return mean_of(scene, settings, PathAov::indirect, ivec2(4)) / (kPiD * static_cast<double>(kNits));
    };
    EXPECT_NEAR(irradiance(mat3(1)), 1, 5e-3);
    EXPECT_NEAR(irradiance(mat3(glm::mat3_cast(glm::angleAxis(kPi / 2, vec3(1, 0, 0))))), 0.5, 0.01);
    EXPECT_NEAR(irradiance(mat3(glm::mat3_cast(glm::angleAxis(kPi, vec3(1, 0, 0))))), 0, 5e-3);
}

// An open corner of two white walls in a white furnace: every reflection counts, and sums up to L.
TEST(SkyLight, ComesBackFromWhiteWalls) {
    FrameScene scene =
        scene_of({quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, 0), quad({-1, 0, -1}, {2, 0, 0}, {0, 2, 0}, 0)},
                 {lambertian(vec3(1))}, {}, vec3(0, 1.5f, 2.5f), vec3(0, 0.5f, -0.5f));
    scene.camera.camera.y_fov = 0.3f;
    scene.sky = even_sky();
    PathSettings settings;
    settings.spp = 256;
    settings.unlimited = true;
    for (const Transport transport : {Transport::diffuse, Transport::full}) {
        settings.transport = transport;
        EXPECT_NEAR(mean_of(scene, settings, PathAov::radiance) / static_cast<double>(kNits), 1, 0.01);
    }
    // With one reflection: what the other wall hides, F of the rays, has the light that it got itself.
    settings.unlimited = false;
    settings.transport = Transport::diffuse;
    settings.bounces = 1;
    const double one = mean_of(scene, settings, PathAov::indirect) / (kPiD * static_cast<double>(kNits));
    EXPECT_GT(one, 0.8);
    EXPECT_LT(one, 0.999);
}

TEST(SkyLight, IsSeenBehindEverything) {
    FrameScene scene = ball(0.5f);
    scene.camera.camera.y_fov = 1.5f;
    scene.sky = sky_of(kNits, [](const vec3&) { return true; });
    scene.sky->sky.colour = vec3(1, 2, 0);
    PathSettings settings;
    settings.spp = 1;
    PathTracer tracer(scene, ivec2(9), settings, {.radiance = true});
    tracer.render({});
    const std::vector<float> image = tracer.image(PathAov::radiance);
    EXPECT_NEAR(image[0], kNits, 1e-4);
    EXPECT_NEAR(image[1], 2 * kNits, 1e-4);
    EXPECT_EQ(image[2], 0);
}

// One bright spot and a black sky: both ways of drawing find it, and their weights sum up to one.
TEST(SkyLight, FindsASmallSpot) {
    FrameScene scene = scene_of({quad({-20, 0, 20}, {40, 0, 0}, {0, 0, -40}, 0)}, {lambertian(vec3(0.5f))},
                                {}, vec3(0, 1, 0), vec3(0));
    look_closely(scene, vec3(0, 0.5f, 0.5f), vec3(0), 1e-4f);
    // A cap around the zenith: E = pi L sin^2 of its angle.
    scene.sky = sky_of(
        1e6f, [](const vec3& d) { return d.y > 0.9988f; }, 512);
    const SkyImage& image = *scene.sky->sky.image;
    double expected = 0;
    for (std::uint32_t y = 0; y < image.height; ++y) {
        const double mid = kPiD * (y + 0.5) / image.height;
        expected +=
            static_cast<double>(image.at(0, y).x) * image.pixel_solid_angle(y) * image.width * std::cos(mid);
    }
    PathSettings settings;
    settings.spp = 8192;
    EXPECT_NEAR(mean_of(scene, settings, PathAov::indirect, ivec2(4)) / expected, 1, 0.02);
}

}  // namespace sky_test
}  // namespace lanthorn::reference::test

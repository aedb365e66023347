// Glass and water traced: slabs and balls whose light is known in closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "gi_module/reference/dielectric.h"
#include "tests/unit/reference/scenes.h"

namespace lanthorn::reference::test {
namespace volume_test {

constexpr double kPiD = 3.14159265358979323846;
constexpr float kNits = 10;

Material glass(float ior) {
    Material m;
    m.metallic = 0;
    m.roughness = 0;
    m.transmission = 1;
    m.thickness = 1;
    m.ior = ior;
    return m;
}

SkyInstance even_sky() {
    return sky_of(kNits, [](const vec3&) { return true; });
}
SkyInstance half_sky(bool above) {
    return sky_of(kNits, [=](const vec3& d) { return (d.y > 0) == above; });
}

// Two parallel surfaces, `thick` apart below y = 0, as good as endless.
std::vector<Mesh> slab(float thick, std::uint32_t material) {
    return {quad({-500, 0, 500}, {1000, 0, 0}, {0, 0, -1000}, material),
            quad({-500, -thick, -500}, {1000, 0, 0}, {0, 0, 1000}, material)};
}

PathSettings full(int spp) {
    PathSettings settings;
    settings.transport = Transport::full;
    settings.spp = spp;
    return settings;
}

// What a narrow view from above, `degrees` off the vertical, shows, over the sky's radiance.
double seen_through(FrameScene scene, double degrees, int spp = 4096) {
    const vec3 eye(dvec3(std::sin(glm::radians(degrees)), std::cos(glm::radians(degrees)), 0));
    look_closely(scene, eye, vec3(0), 1e-3f);
    return mean_of(scene, full(spp), PathAov::radiance, ivec2(4)) / static_cast<double>(kNits);
}

// Light that goes to and fro within a slab: the share that passes is (1-R)^2 a / (1 - R^2 a^2), a what is
// left of light after one way; (1-R) / (1+R) where nothing is absorbed.
TEST(Volume, ASlabPassesTheGeometricSeries) {
    for (const float ior : {1.33f, 1.5f, 3.0f}) {
        for (const double degrees : {0.0, 45.0, 70.0}) {
            for (const double sigma : {0.0, 2.0}) {
                Material m = glass(ior);
                constexpr double kThick = 0.25;
                if (sigma > 0) {
                    m.attenuation_distance = static_cast<float>(1 / sigma);
                    m.attenuation_colour = vec3(static_cast<float>(std::exp(-1)));
                }
                const auto cosine = static_cast<float>(std::cos(glm::radians(degrees)));
                const Incidence at(cosine, ior);
                const double r = static_cast<double>(at.reflectance);
                const double a = std::exp(-sigma * kThick / static_cast<double>(at.beyond));
                const double passed = (1 - r) * (1 - r) * a / (1 - r * r * a * a);
                FrameScene scene = scene_of(slab(kThick, 0), {m}, {}, vec3(0, 1, 0), vec3(0));
                scene.sky = half_sky(false);
                EXPECT_NEAR(seen_through(scene, degrees), passed, 0.006)
                    << ior << ", " << degrees << " degrees, " << sigma << " 1/m";
                if (sigma == 0) {
                    EXPECT_NEAR(passed, (1 - r) / (1 + r), 1e-6);
                }
                scene.sky = half_sky(true);
                const double reflected = r + (1 - r) * (1 - r) * r * a * a / (1 - r * r * a * a);
                EXPECT_NEAR(seen_through(scene, degrees), reflected, 0.006)
                    << ior << ", " << degrees << " degrees, " << sigma << " 1/m";
            }
        }
    }
}

// What is seen through a tilted view of a slab is where Snell says: a lamp as narrow as the view, displaced
// by the slab's thickness times the difference of the tangents.
TEST(Volume, ASlabDisplacesWhatIsBehindIt) {
    constexpr double kThick = 1, kDegrees = 50;
    const double i = glm::radians(kDegrees), t = std::asin(std::sin(i) / 1.5);
    const auto below = static_cast<float>(-kThick * std::tan(t) - std::tan(i));  // a metre under the slab
    for (const float aside : {0.0f, 0.05f}) {
        auto meshes = slab(kThick, 0);
        meshes.push_back(quad({below - 0.02f + aside, -2, 0.02f}, {0.04f, 0, 0}, {0, 0, -0.04f}, 1));
        FrameScene scene = scene_of(meshes, {glass(1.5f), lamp(vec3(kNits))}, {}, vec3(0, 1, 0), vec3(0));
        const double seen = seen_through(scene, kDegrees);
        if (aside == 0) {
            EXPECT_NEAR(
                seen,
                std::pow(
                    1 - static_cast<double>(Incidence(static_cast<float>(std::cos(i)), 1.5f).reflectance), 2),
                0.01);
        } else {
            EXPECT_NEAR(seen, 0, 1e-6);
        }
    }
}

class Furnace : public testing::TestWithParam<float> {};

// Without absorption a body of glass in an even sky is not to be seen, from outside or inside.
TEST_P(Furnace, GlassIsAsBrightAsTheSky) {
    for (const vec3& eye : {vec3(0, 0, 3), vec3(0, 0.3f, 0.2f)}) {
        FrameScene scene = scene_of({sphere(vec3(0), 1, 3, false, 0)}, {glass(GetParam())}, {}, eye, vec3(0));
        scene.camera.camera.y_fov = 0.6f;
        scene.sky = even_sky();
        EXPECT_NEAR(mean_of(scene, full(16), PathAov::radiance) / static_cast<double>(kNits), 1, 2e-3)
            << eye.z;
    }
}

// Nor is a white body within it: what it does not get from outside, it gets back from the glass.
TEST_P(Furnace, AWhiteBallInGlassIsAsBrightAsTheSky) {
    FrameScene scene = scene_of({sphere(vec3(0), 1, 4, false, 0), sphere(vec3(0), 0.5f, 4, false, 1)},
                                {glass(GetParam()), lambertian(vec3(1))}, {}, vec3(0, 0, 3), vec3(0));
    scene.camera.camera.y_fov = 0.2f;
    scene.sky = even_sky();
    PathSettings settings = full(256);
    settings.unlimited = true;
    EXPECT_NEAR(mean_of(scene, settings, PathAov::radiance) / static_cast<double>(kNits), 1, 0.02);
}

TEST_P(Furnace, RoughGlassIsNeverBrighter) {
    for (const float roughness : {0.2f, 0.5f, 1.0f}) {
        Material m = glass(GetParam());
        m.roughness = roughness;
        FrameScene scene = scene_of({sphere(vec3(0), 1, 4, false, 0)}, {m}, {}, vec3(0, 0, 3), vec3(0));
        scene.camera.camera.y_fov = 0.6f;
        scene.sky = even_sky();
        const double seen = mean_of(scene, full(64), PathAov::radiance) / static_cast<double>(kNits);
        EXPECT_LE(seen, 1.002) << roughness;
        // The facets' shadows upon each other are lost, again at each boundary.
        EXPECT_GT(seen, roughness < 0.3f ? 0.95 : 0.2) << roughness;
    }
}

INSTANTIATE_TEST_SUITE_P(Indices, Furnace, testing::Values(1.0f, 1.33f, 1.5f, 3.0f));

// Half of it opaque and white: what is not sent on by the one half is by the other. A coat over the opaque
// half and facets in each other's shadow keep some of it.
TEST(Volume, AnOpaqueShareKeepsItsEnergy) {
    for (const bool coated : {false, true}) {
        Material m = glass(1.5f);
        m.transmission = 0.5f;
        m.roughness = coated ? 0.6f : 0.0f;
        m.specular = coated ? 1.0f : 0.0f;
        FrameScene scene = scene_of({sphere(vec3(0), 1, 4, false, 0)}, {m}, {}, vec3(0, 0, 3), vec3(0));
        scene.camera.camera.y_fov = 0.4f;
        scene.sky = even_sky();
        PathSettings settings = full(256);
        settings.unlimited = true;
        const double seen = mean_of(scene, settings, PathAov::radiance) / static_cast<double>(kNits);
        if (coated) {
            EXPECT_LE(seen, 1.01);
            EXPECT_GT(seen, 0.7);
        } else {
            EXPECT_NEAR(seen, 1, 0.02);
        }
    }
}

// Base colour tints light at each boundary that it passes, not what is reflected.
TEST(Volume, BaseColourTintsWhatPasses) {
    Material m = glass(1.5f);
    m.base_colour = vec4(vec3(0.5f), 1);
    FrameScene scene = scene_of(slab(0.1f, 0), {m}, {}, vec3(0, 1, 0), vec3(0));
    scene.sky = half_sky(false);
    const double r = 0.04;
    EXPECT_NEAR(seen_through(scene, 0), 0.25 * (1 - r) * (1 - r) / (1 - r * r), 0.004);
    scene.sky = half_sky(true);
    EXPECT_NEAR(seen_through(scene, 0), r + 0.25 * (1 - r) * (1 - r) * r / (1 - r * r), 0.004);
}

// Under water: the camera, a glowing floor, and Beer's law between them.
TEST(Volume, AViewUnderWaterIsAbsorbedOnItsWay) {
    Material water = glass(1.33f);
    water.attenuation_distance = 2;
    water.attenuation_colour = vec3(0.25f);
    FrameScene scene = scene_of({quad({-50, 0, 50}, {100, 0, 0}, {0, 0, -100}, 0),
                                 quad({-50, -1.5f, 50}, {100, 0, 0}, {0, 0, -100}, 1)},
                                {water, lamp(vec3(kNits))}, {}, vec3(0), vec3(0, -1, 0));
    look_closely(scene, vec3(0, -0.5f, 0), vec3(0, -1.5f, 0), 1e-3f);
    const double shown = mean_of(scene, full(16), PathAov::radiance, ivec2(4)) / static_cast<double>(kNits);
    EXPECT_NEAR(shown, 0.5 / (1.33 * 1.33), 1e-4) << "a metre is half of 2 m, to 0.25; radiance over n^2";
    look_closely(scene, vec3(0, -0.5f, 0), vec3(0, 0, 0), 1e-3f);
    scene.sky = half_sky(true);
    EXPECT_NEAR(mean_of(scene, full(4096), PathAov::radiance, ivec2(4)) / static_cast<double>(kNits),
                std::sqrt(0.5) * (1 - Incidence(1, 1.33f).reflectance), 0.02)
        << "up: half a metre of water";
}

// Beyond the critical angle the surface shows the bottom.
TEST(Volume, UnderWaterTheSurfaceIsAMirrorFarAway) {
    FrameScene scene = scene_of(
        {quad({-50, 0, 50}, {100, 0, 0}, {0, 0, -100}, 0), quad({-50, -1, 50}, {100, 0, 0}, {0, 0, -100}, 1)},
        {glass(1.33f), lamp(vec3(kNits))}, {}, vec3(0, -0.5f, 0), vec3(0));
    for (const auto& [degrees, total] : {std::pair(48.0, false), std::pair(49.5, true)}) {
        const vec3 up(dvec3(std::sin(glm::radians(degrees)), std::cos(glm::radians(degrees)), 0));
        look_closely(scene, vec3(0, -0.5f, 0), vec3(0, -0.5f, 0) + up, 1e-4f);
        const double shown =
            mean_of(scene, full(256), PathAov::radiance, ivec2(4)) * 1.33 * 1.33 / static_cast<double>(kNits);
        if (total) {
            EXPECT_NEAR(shown, 1, 1e-3);
        } else {
            EXPECT_LT(shown, 0.6) << "air is above: dark";
        }
    }
}

// The irradiance below a slab is that of the lamp times what the slab passes, over all directions; it is
// indirect light, which no shadow ray brings.
TEST(Volume, LightThatGlassBendsReachesTheFloor) {
    double passed = 0;
    constexpr int kSteps = 2000;
    for (int k = 0; k < kSteps; ++k) {
        const double angle = 0.5 * kPiD * (k + 0.5) / kSteps;
        const double r =
            static_cast<double>(Incidence(static_cast<float>(std::cos(angle)), 1.5f).reflectance);
        passed += 2 * std::sin(angle) * std::cos(angle) * (1 - r) / (1 + r) * (0.5 * kPiD / kSteps);
    }
    for (const bool by_sky : {true, false}) {
        auto meshes = slab(0.1f, 0);
        meshes.push_back(quad({-500, -1, 500}, {1000, 0, 0}, {0, 0, -1000}, 1));
        if (!by_sky) {
            meshes.push_back(quad({-500, 1, -500}, {1000, 0, 0}, {0, 0, 1000}, 2));
        }
        FrameScene scene = scene_of(meshes, {glass(1.5f), lambertian(vec3(0.001f)), lamp(vec3(kNits))}, {},
                                    vec3(0, -0.5f, 0), vec3(0, -1, 0));
        look_closely(scene, vec3(0, -0.5f, 0), vec3(0, -1, 0), 1e-3f);
        if (by_sky) {
            scene.sky = half_sky(true);
        }
        EXPECT_NEAR(mean_of(scene, full(2048), PathAov::indirect, ivec2(4)) / (kPiD * kNits), passed, 0.01)
            << by_sky;
        EXPECT_NEAR(mean_of(scene, full(256), PathAov::direct, ivec2(4)), 0, 1e-6) << by_sky;
        EXPECT_NEAR(mean_of(scene, full(2048), PathAov::radiance, ivec2(4)) / (0.001 * kNits), passed, 0.01)
            << by_sky;
    }
}

// A light within glass lights what is within it, less what is absorbed on the way.
TEST(Volume, ALightInGlassShinesThere) {
    Material m = glass(1.5f);
    m.attenuation_distance = 1;
    m.attenuation_colour = vec3(0.5f);
    const Mesh floor = quad({-20, -1, 20}, {40, 0, 0}, {0, 0, -40}, 1);
    FrameScene inside = scene_of({sphere(vec3(0), 30, 3, false, 0), floor}, {m, lambertian(vec3(0.5f))},
                                 {point_light(vec3(0), 100)}, vec3(0), vec3(0, -1, 0));
    look_closely(inside, vec3(0, -0.9f, 0), vec3(0, -1, 0), 1e-3f);
    const double shown = mean_of(inside, full(64), PathAov::radiance, ivec2(4)) * 1.5 * 1.5;
    EXPECT_NEAR(shown / (0.5 * 100 / kPiD), std::pow(0.5, 1.1), 0.02);
}

// Points of light have no size: glass blocks them, and a thin pane does not.
TEST(Volume, BlocksShadowRays) {
    Material pane = glass(1.5f);
    for (const float thickness : {0.0f, 1.0f}) {
        pane.thickness = thickness;
        auto meshes = slab(0.1f, 0);
        meshes.push_back(quad({-20, -1, 20}, {40, 0, 0}, {0, 0, -40}, 1));
        FrameScene scene = scene_of(meshes, {pane, lambertian(vec3(0.5f))}, {point_light(vec3(0, 1, 0), 100)},
                                    vec3(0, -0.5f, 0), vec3(0, -1, 0));
        look_closely(scene, vec3(0, -0.5f, 0), vec3(0, -1, 0), 1e-3f);
        const double seen = mean_of(scene, full(64), PathAov::direct, ivec2(4));
        EXPECT_EQ(seen > 0, thickness == 0);
    }
}

// Diffuse transport knows no volumes.
TEST(Volume, DiffuseTransportTreatsThickGlassAsThin) {
    Material pane = glass(1.5f);
    double seen[2];
    for (const int thick : {0, 1}) {
        pane.thickness = static_cast<float>(thick);
        FrameScene scene = scene_of({sphere(vec3(0), 1, 3, false, 0), sphere(vec3(0, 3, 0), 1, 3, false, 1)},
                                    {pane, lamp(vec3(kNits))}, {}, vec3(0, 1, 6), vec3(0));
        PathSettings settings;
        settings.spp = 4;
        settings.transport = Transport::diffuse;
        seen[thick] = mean_of(scene, settings, PathAov::radiance);
    }
    EXPECT_EQ(seen[0], seen[1]);
}

}  // namespace volume_test
}  // namespace lanthorn::reference::test

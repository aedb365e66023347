// Light of the sky by both final stages: against what is known on paper and against the path tracer; and what
// the camera sees of the sky.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "engine/render/light_sensors.h"
#include "gi_module/shared/rays/embree_rays.h"
#include "gi_module/techniques/emc/photons/sky_photons.h"
#include "gi_module/techniques/emc/photons/sky_places.h"
#include "lanthorn/core/colour.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/emc/emc_statistics.h"
#include "tests/gpu/gi/path_truth.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace {

constexpr float kNits = 100;
constexpr ivec2 kSize(96);

// `radiance` of a direction towards the sky.
template <class Radiance>
SkyInstance sky_of(const Radiance& radiance) {
    SkyImage image;
    image.width = 128;
    image.height = 64;
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            image.radiance.push_back(
                radiance(sky_direction({(static_cast<float>(x) + 0.5f) / static_cast<float>(image.width),
                                        (static_cast<float>(y) + 0.5f) / static_cast<float>(image.height)})));
        }
    }
    SkyInstance sky;
    sky.sky.image = std::make_shared<const SkyImage>(std::move(image));
    return sky;
}

SkyInstance even_sky() {
    return sky_of([](const vec3&) { return vec3(kNits); });
}

// Blue above, warm at one side.
SkyInstance day() {
    return sky_of([](const vec3& d) {
        const float warm = std::max(d.x, 0.0f);
        return d.y > 0 ? vec3(60, 90, 140) * (0.3f + d.y) + warm * warm * vec3(300, 180, 60) : vec3(20);
    });
}

FrameScene floor_scene(float albedo) {
    FrameScene scene = scene_of({quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, 0)}, {lambertian(vec3(albedo))}, {},
                                vec3(0, 1.2f, 1.6f), vec3(0));
    scene.camera.camera.y_fov = 0.5f;
    return scene;
}

// A court: four walls and a floor, open above, with a block.
FrameScene court() {
    return scene_of(
        {quad({0, 0, 3}, {4, 0, 0}, {0, 0, -3}, 0), quad({0, 0, 0}, {4, 0, 0}, {0, 2.6f, 0}, 0),
         quad({4, 0, 0}, {0, 0, 3}, {0, 2.6f, 0}, 0), quad({4, 0, 3}, {-4, 0, 0}, {0, 2.6f, 0}, 0),
         quad({0, 0, 3}, {0, 0, -3}, {0, 2.6f, 0}, 0),
         box(vec3(1.6f, 0, 0.7f), vec3(2.4f, 1.2f, 2.3f), false, 1)},
        {lambertian(vec3(0.6f)), lambertian(vec3(0.7f, 0.3f, 0.2f))}, {}, vec3(3.7f, 2.2f, 2.8f),
        vec3(1, 0.6f, 1));
}

GiSettings gather_settings(EmcRays rays, int bounces) {
    GiSettings settings;
    settings.edit<EmcSettings>().final_stage = EmcFinal::gather;
    settings.edit<EmcSettings>().rays = rays;
    settings.edit<EmcSettings>().gather_points = 1;
    settings.edit<EmcSettings>().gather_grid = 2;
    settings.bounces = bounces;
    settings.edit<EmcSettings>().gather_endless = false;
    return settings;
}

ImageF still_picture(Bench& bench, FrameScene scene, int frames = 16, ivec2 size = kSize) {
    ImageF image = bench.frame(scene, size);
    hold_still(scene);
    for (int f = 1; f < frames; ++f) {
        image = bench.frame(scene, size);
    }
    return image;
}

TEST(SkyPlaces, KeepTheImagesFlux) {
    const SkyInstance sky = day();
    const SkyImage& image = *sky.sky.image;
    dvec3 wanted(0), got(0);
    double sphere = 0;
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            wanted += dvec3(image.at(x, y)) * image.pixel_solid_angle(y);
        }
    }
    const std::vector<vec4> cells = sky_radiosity(sky);
    for (int i = 0; i < kSkyPlaces; ++i) {
        const vec2 e = 2.0f * (vec2(i % kSkySide, i / kSkySide) + 0.5f) / static_cast<float>(kSkySide) - 1.0f;
        const double z = 1 - static_cast<double>(std::abs(e.x) + std::abs(e.y));
        const double x = z < 0 ? 1 - static_cast<double>(std::abs(e.y)) : static_cast<double>(e.x);
        const double y = z < 0 ? 1 - static_cast<double>(std::abs(e.x)) : static_cast<double>(e.y);
        const double weight = std::pow(x * x + y * y + z * z, -1.5);
        got += weight * dvec3(cells[static_cast<std::size_t>(i)]);
        sphere += weight;
    }
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(got[c] / sphere / (wanted[c] / 4), 1, 0.01) << c;
    }
    EXPECT_EQ(sky_radiosity(std::nullopt).front(), vec4(0));
}

class SkyGathered : public ::testing::TestWithParam<EmcRays> {
  protected:
    void SetUp() override { add_embree_rays(); }
};

TEST_P(SkyGathered, AFloorUnderAnEvenSkyHasPiTimesItsRadiance) {
    Bench bench;
    bench.settings = gather_settings(GetParam(), 2);
    FrameScene scene = floor_scene(0.5f);
    scene.sky = even_sky();
    const Deviation a = deviation_of(still_picture(bench, scene), static_cast<double>(kPi * kNits));
    std::printf("floor under an even sky: mean %.5f, relRMSE %.5f\n", a.mean, a.rel_rmse);
    EXPECT_NEAR(a.mean, 1, 2e-3);
    EXPECT_LT(a.rel_rmse, 5e-3);
}

FrameScene court_by_day() {
    FrameScene scene = court();
    scene.sky = day();
    return scene;
}

// Traced once for both final stages and both kinds of rays.
const Truth& truth_of_court(int bounces) {
    static std::map<int, Truth> traced;
    const auto [found, missing] = traced.try_emplace(bounces);
    if (missing) {
        found->second = path_traced(court_by_day(), kSize, bounces, 512);
    }
    return found->second;
}

// Shadows of the sky, and its light reflected 0 to N times: as `path` has it, and not once more.
TEST_P(SkyGathered, ACourtIsLitAsThePathTracerFinds) {
    const FrameScene scene = court_by_day();
    for (const int bounces : {1, 3}) {
        const Truth& truth = truth_of_court(bounces);
        Bench bench;
        bench.settings = gather_settings(GetParam(), bounces);
        const Deviation a = against(still_picture(bench, scene), truth);
        std::printf("court, %d bounces: flux %.4f, relRMSE %.4f\n", bounces, a.mean, a.rel_rmse);
        EXPECT_NEAR(a.mean, 1, 0.02) << bounces;
        EXPECT_LT(a.rel_rmse, 0.08) << bounces;
    }
}

// Photons bring the lamp's light and rays the sky's: the lamp comes and goes without a ray, and nothing of it
// stays.
TEST_P(SkyGathered, ALampComesAndGoesUnderTheSky) {
    constexpr ivec2 kSmall(48);
    constexpr int kBounces = 3;
    FrameScene lit = court(), dark = court();
    lit.sky = dark.sky = day();
    lit.lights = {point_light(vec3(2, 2, 0.4f), 60)};
    static const Truth with = path_traced(lit, kSmall, kBounces, 512);
    static const Truth without = path_traced(dark, kSmall, kBounces, 512);
    Bench bench;
    bench.settings = gather_settings(GetParam(), kBounces);
    const auto shown = [&](const FrameScene& scene, const Truth& truth, const char* what) {
        const Deviation a = against(bench.frame(scene, kSmall, true), truth);
        std::printf("court, %s: flux %.4f, relRMSE %.4f\n", what, a.mean, a.rel_rmse);
        EXPECT_NEAR(a.mean, 1, 0.02) << what;
        EXPECT_LT(a.rel_rmse, 0.08) << what;
    };
    still_picture(bench, lit, 16, kSmall);
    for (FrameScene* scene : {&lit, &dark}) {
        hold_still(*scene);
    }
    shown(lit, with, "lamp and sky");
    lit.changes.lights = dark.changes.lights = true;
    shown(dark, without, "the lamp goes off");
    shown(lit, with, "it goes on");
    for (const auto& span : bench.spans) {
        EXPECT_NE(span.name, "lit_rays");
    }
}

INSTANTIATE_TEST_SUITE_P(Rays, SkyGathered, ::testing::Values(EmcRays::maps, EmcRays::bvh));

// Nothing has moved: the rays hold, and all light doubles with the sky, bit for bit.
TEST(Sky, ThatIsTwiceAsBrightShootsNoRay) {
    add_embree_rays();
    Bench bench;
    bench.settings = gather_settings(EmcRays::bvh, 2);
    FrameScene scene = court();
    scene.sky = day();
    const ImageF before = still_picture(bench, scene, 20);
    hold_still(scene);
    scene.changes.lights = true;
    scene.sky->sky.intensity = 2;
    const ImageF after = bench.frame(scene, kSize, true);
    for (std::size_t i = 0; i < before.pixels.size(); ++i) {
        ASSERT_EQ(after.pixels[i], 2 * before.pixels[i]) << i;
    }
    for (const auto& span : bench.spans) {
        EXPECT_NE(span.name, "gather_rays");
    }
    scene.sky.reset();
    scene.lights = {point_light(vec3(2, 2, 0.4f), 1e-6f)};
    EXPECT_LT(mean_of(bench.frame(scene, kSize)), 1e-3 * mean_of(before)) << "the sky has gone";
}

TEST(Sky, IsSeenWhereNothingElseIs) {
    Bench bench;
    bench.settings = gather_settings(EmcRays::maps, 1);
    FrameScene scene = floor_scene(0.5f);
    scene.camera.camera.y_fov = 2.4f;  // beyond the floor's edges
    scene.sky = day();
    scene.sky->sky.colour = vec3(1, 0.5f, 2);
    bench.frame(scene, kSize);
    const ImageF radiance = bench.renderer().read(render::Aov::radiance);
    const ImageF depth = bench.renderer().read(render::Aov::depth);
    const render::CameraUniforms camera = render::CameraUniforms::from(scene.camera, 1);
    int seen = 0;
    for (int y = 0; y < kSize.y; y += 5) {
        for (int x = 0; x < kSize.x; x += 5) {
            if (depth.at(x, y, 0) > 0) {
                continue;
            }
            const vec2 p((static_cast<float>(x) + 0.5f) / static_cast<float>(kSize.x) * 2 - 1,
                         1 - (static_cast<float>(y) + 0.5f) / static_cast<float>(kSize.y) * 2);
            const vec3 d = glm::normalize(camera.forward + camera.right * p.x + camera.up * p.y);
            const vec3 expected = sky_radiance(*scene.sky->sky.image, d) * scene.sky->scale();
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(radiance.at(x, y, c), expected[c], 0.01f * expected[c] + 0.3f) << x << ' ' << y;
            }
            ++seen;
        }
    }
    EXPECT_GT(seen, 50);
}

// Cauchy 1832: over all directions the shadow of a convex body has a quarter of its surface, so that an even
// sky sends pi L S into it.
TEST(SkyPhotonCells, CatchWhatTheBoxDoes) {
    Aabb box;
    box.add(vec3(-1, 0, 2));
    box.add(vec3(3, 1, 5));
    const double surface = 2 * (4 * 1 + 1 * 3 + 3 * 4);
    const SkyPhotonCells even = SkyPhotonCells::of(even_sky(), box);
    EXPECT_NEAR(even.flux.y / (static_cast<double>(kPi * kNits) * surface), 1, 2e-3);
    EXPECT_EQ(even.cells.back().cumulative, 1);
    // Under one bright pixel every photon comes from there; under a black sky none comes.
    const SkyPhotonCells spot =
        SkyPhotonCells::of(sky_of([](const vec3& d) { return vec3(d.y > 0.9996f ? 1e6f : 0.0f); }), box);
    std::size_t cells = 0;
    for (const SkyPhotonCell& cell : spot.cells) {
        cells += cell.power.y > 0 ? 1 : 0;
    }
    EXPECT_GT(cells, 0u);
    EXPECT_LE(cells, spot.width);
    EXPECT_EQ(SkyPhotonCells::of(sky_of([](const vec3&) { return vec3(0); }), box).flux, dvec3(0));
    EXPECT_TRUE(SkyPhotonCells::of(even_sky(), Aabb()).cells.empty());
}

GiSettings splat_settings(int bounces) {
    GiSettings settings;
    settings.edit<EmcSettings>().final_stage = EmcFinal::splat;
    settings.photons = 60'000;
    settings.bounces = bounces;
    return settings;
}

// Mean over the middle of the picture, away from where splats reach over the edge.
double middle_of(const ImageF& image) {
    double sum = 0;
    int count = 0;
    for (int y = image.height / 3; y < 2 * image.height / 3; ++y) {
        for (int x = image.width / 3; x < 2 * image.width / 3; ++x) {
            sum += static_cast<double>(image.at(x, y, 1));
            ++count;
        }
    }
    return sum / count;
}

TEST(SkySplatted, AFloorUnderAnEvenSkyHasPiTimesItsRadiance) {
    Bench bench;
    bench.settings = splat_settings(2);
    FrameScene scene = floor_scene(0.5f);
    scene.sky = even_sky();
    const double lux = middle_of(bench.frame(scene, kSize));
    std::printf("floor under an even sky, splatted: %.4f of pi L\n", lux / static_cast<double>(kPi * kNits));
    EXPECT_NEAR(lux / static_cast<double>(kPi * kNits), 1, 0.02);
    const PhotonStatistics photons = bench.technique().statistics(true).of<PhotonStatistics>();
    EXPECT_NEAR(photons.flux_from_sky.y / static_cast<double>(kPi * kNits * 32), 1, 0.01)
        << "16 m^2 above, and as much below";
}

// Shadows of the sky, and its light reflected 0 to N times.
TEST(SkySplatted, ACourtIsLitAsThePathTracerFinds) {
    const FrameScene scene = court_by_day();
    for (const int bounces : {1, 3}) {
        const Truth& truth = truth_of_court(bounces);
        Bench bench;
        bench.settings = splat_settings(bounces);
        const Deviation a = against(bench.frame(scene, kSize), truth);
        std::printf("court, splatted, %d bounces: flux %.4f, relRMSE %.4f\n", bounces, a.mean, a.rel_rmse);
        EXPECT_NEAR(a.mean, 1, 0.04) << bounces;
        EXPECT_LT(a.rel_rmse, 0.2) << bounces;
    }
}

// Photons that enter the box from outside must not get through walls and roof, which no map sees from there.
TEST(SkySplatted, NothingComesIntoAClosedRoom) {
    FrameScene scene = scene_of({box(vec3(0), vec3(4, 2.6f, 3), true, 0)}, {lambertian(vec3(0.6f))}, {},
                                vec3(3.5f, 1.4f, 2.6f), vec3(0.5f, 1, 0.5f));
    scene.sky = even_sky();
    Bench bench;
    bench.settings = splat_settings(2);
    EXPECT_LT(mean_of(bench.frame(scene, kSize)), 1e-3 * static_cast<double>(kPi * kNits));
}

// With a lamp both add up, and the sky may come and go.
TEST(SkySplatted, AddsToLamps) {
    Bench bench;
    bench.settings = splat_settings(2);
    FrameScene scene = court();
    scene.lights = {point_light(vec3(2, 2, 0.4f), 100)};
    const double lamp = mean_of(bench.frame(scene, kSize));
    scene.sky = even_sky();
    const double both = mean_of(bench.frame(scene, kSize));
    scene.lights.clear();
    const double sky = mean_of(bench.frame(scene, kSize));
    EXPECT_NEAR((lamp + sky) / both, 1, 0.02);
    scene.sky.reset();
    EXPECT_EQ(mean_of(bench.frame(scene, kSize)), 0);
    EXPECT_EQ(bench.renderer().nan_count(), 0u);
}

// A sensor on a floor under an even sky reads pi L, whichever way the picture is lit.
TEST(SkySensors, CountItsPhotons) {
    add_embree_rays();
    FrameScene scene = floor_scene(0.5f);
    scene.sky = even_sky();
    scene.sensors = {{7, {0, 0, 0}, {0, 1, 0}, 0.5f}};
    for (const EmcFinal final : {EmcFinal::splat, EmcFinal::gather}) {
        Bench bench;
        bench.settings = splat_settings(2);
        bench.settings.edit<EmcSettings>().final_stage = final;
        bench.frame(scene, kSize);
        render::LightSensors sensors;
        const render::LightMaps& maps = bench.renderer().light_maps();
        ASSERT_TRUE(sensors.wants(scene, maps, scene.frame));
        bench.add_irradiance(scene, sensors.measure_direct(scene, maps));
        sensors.send(scene.frame);
        const auto samples = sensors.finish();
        ASSERT_EQ(samples.size(), 1u);
        EXPECT_NEAR(luminance(dvec3(samples[0].illuminance)) / static_cast<double>(kPi * kNits), 1, 0.03);
    }
}

// One pixel of a million nits in a black sky, seen square on by the floor: what it sends is its radiance
// times its solid angle.
TEST(SkySplatted, OneBrightPixelKeepsItsFlux) {
    SkyImage image;
    image.width = 256;
    image.height = 128;
    image.radiance.assign(std::size_t{256} * 128, vec3(0));
    image.radiance[std::size_t{3} * 256 + 40] = vec3(1e6f);
    const double lux = 1e6 * image.pixel_solid_angle(3) * std::cos(3.5 / 128 * static_cast<double>(kPi));
    FrameScene scene = floor_scene(0.5f);
    scene.sky = SkyInstance();
    scene.sky->sky.image = std::make_shared<const SkyImage>(std::move(image));
    Bench bench;
    bench.settings = splat_settings(1);
    const double got = middle_of(bench.frame(scene, kSize));
    std::printf("one pixel of 1e6 nits: %.4f of its flux\n", got / lux);
    EXPECT_NEAR(got / lux, 1, 0.03);
    EXPECT_EQ(bench.renderer().nan_count(), 0u);
}

// Small plates everywhere, of which the maps see many edge on, with nothing beside them: rays must start at
// the plates, not where their planes meet some direction far away. An exact ray from there is refused.
TEST(Sky, BehindPlatesSeenEdgeOnIsNoPlaceForRays) {
    add_embree_rays();
    std::vector<Mesh> plates;
    std::uint32_t state = 1;
    const auto number = [&] {
        state = state * 1664525u + 1013904223u;
        return static_cast<float>(state >> 8) / 16777216.0f;
    };
    for (int i = 0; i < 300; ++i) {
        const vec3 at = 4.0f * vec3(number(), number(), number());
        const vec3 u = glm::normalize(vec3(number(), number(), number()) - 0.5f);
        const vec3 v = glm::normalize(glm::cross(u, vec3(number(), number(), number()) - 0.5f));
        plates.push_back(quad(at, 0.3f * u, 0.3f * v, 0));
    }
    Material grey = lambertian(vec3(0.5f));
    grey.double_sided = true;
    FrameScene scene = scene_of(std::move(plates), {grey}, {}, vec3(2, 2, 9), vec3(2));
    scene.sky = even_sky();
    Bench bench;
    bench.settings = gather_settings(EmcRays::bvh, 2);
    const Deviation a = deviation_of(bench.frame(scene, ivec2(48)), 1);  // finite
    EXPECT_GT(a.mean, 0);
    EXPECT_EQ(bench.renderer().nan_count(), 0u);
}

// Suns are taken out of images, but a black sky and one of few pixels must be stable all the same.
TEST(Sky, OfAnySortIsFinite) {
    for (const auto& [nits, final] : {std::pair(0.0f, EmcFinal::gather), std::pair(1e-20f, EmcFinal::gather),
                                      std::pair(1e6f, EmcFinal::gather), std::pair(0.0f, EmcFinal::splat),
                                      std::pair(1e-20f, EmcFinal::splat), std::pair(1e6f, EmcFinal::splat)}) {
        Bench bench;
        bench.settings = gather_settings(EmcRays::maps, 2);
        bench.settings.edit<EmcSettings>().final_stage = final;
        FrameScene scene = court();
        scene.sky = sky_of([&](const vec3& d) { return vec3(d.y > 0.99f ? nits : 0.0f); });
        const ImageF image = still_picture(bench, scene, 3, ivec2(48));
        for (const float v : image.pixels) {
            ASSERT_TRUE(std::isfinite(v));
            ASSERT_GE(v, 0);
        }
    }
}

}  // namespace
}  // namespace lanthorn::gi::test

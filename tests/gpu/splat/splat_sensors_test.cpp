// Light sensors under `splat`.
#include <gtest/gtest.h>

#include "lanthorn/core/colour.h"
#include "tests/gpu/gi/sensor_room.h"
#include "tests/gpu/splat/splat_bench.h"

namespace lanthorn::gi::test {
namespace {

void expect_the_path_tracers_light(int photons, double tolerance) {
    const FrameScene scene = lantern_room(1.9f, 1);
    const double expected = sensor_truth(scene);
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
        Splat bench(photons);
        bench.settings.seed = seed;
        const double got = reading_of(bench, scene);
        std::printf("splat, sensor in the lantern room, %d photons: %.3f of path's\n", photons,
                    got / expected);
        EXPECT_NEAR(got, expected, tolerance * expected) << seed;
    }
}

TEST(PhotonSplatSensors, ReadTheLightThatThePathTracerFinds) {
    expect_the_path_tracers_light(800'000, 0.1);
}

// Over the whole wall, as far as the kernels of its few photons reach, light is 0.64 of that.
TEST(PhotonSplatSensors, SpreadNoLightOverTheWallThatFallsThroughTheDoor) {
    expect_the_path_tracers_light(100'000, 0.2);
}

TEST(PhotonSplatSensors, SeeTheColourOfBouncedLight) {
    Splat bench;
    expect_the_colour_of_bounced_light(bench, 0.05);  // facets instead of a sphere, and the photons' noise
}

TEST(PhotonSplatSensors, SayWhenTheirLightIsAnother) {
    Splat bench, fresh;
    expect_other_light_to_be_told(bench, fresh);
}

// Without a photon traced again.
TEST(PhotonSplatSensors, SayWhenTheKernelIsAnother) {
    Splat bench(20'000);
    FrameScene scene = lantern_room(1.9f, 1);
    bench.frame(scene, kSensorPicture);
    hold_still(scene);
    const auto expect_other_light = [&](const char* what) {
        const std::uint64_t before = bench.technique().light_version();
        bench.frame(scene, kSensorPicture);
        EXPECT_GT(bench.technique().light_version(), before) << what;
        EXPECT_FALSE(bench.technique().statistics(false).plan.on("photons")) << what;
        const std::uint64_t after = bench.technique().light_version();
        bench.frame(scene, kSensorPicture);
        EXPECT_EQ(bench.technique().light_version(), after) << what;
    };
    bench.own().bandwidth = 8;
    expect_other_light("bandwidth");
    bench.own().caustic_bandwidth = 3;
    expect_other_light("caustic_bandwidth");
    bench.own().kernel = PhotonKernel::epanechnikov;
    expect_other_light("kernel");
    bench.own().boundaries = false;
    expect_other_light("boundaries");
}

// On a floor, with their rims at its edge, where part of the kernels lies beyond it.
TEST(PhotonSplatSensors, ReadTheSameAloneAndBesideOthers) {
    const auto lights = [](const std::vector<SensorInstance>& sensors) {
        FrameScene scene = scene_of({box(vec3(0), vec3(4, 2.6f, 3), true, 0)}, {lambertian(vec3(0.6f))},
                                    {point_light(vec3(2, 1.3f, 1.5f), 100)}, vec3(2, 2, 2), vec3(1, 1, 1));
        scene.sensors = sensors;
        Splat bench;
        bench.own().bandwidth = 8;
        render::LightSensors read;
        std::vector<double> result;
        for (const render::SensorLight& light : measured(scene, bench, read)) {
            result.push_back(luminance(dvec3(light.illuminance)));
        }
        return result;
    };
    std::vector<SensorInstance> sensors;
    for (const vec2 at : {vec2(3.7f, 0.3f), vec2(3.7f, 1), vec2(3.7f, 1.7f), vec2(3.7f, 2.7f),
                          vec2(0.3f, 0.3f), vec2(2, 1.5f), vec2(1, 2.7f), vec2(2, 0.3f)}) {
        sensors.push_back({static_cast<std::uint32_t>(7 + sensors.size()), {at.x, 0, at.y}, {0, 1, 0}, 0.3f});
    }
    const std::vector<double> together = lights(sensors);
    ASSERT_EQ(together.size(), sensors.size());
    for (std::size_t i = 0; i < sensors.size(); ++i) {
        const std::vector<double> alone = lights({sensors[i]});
        ASSERT_EQ(alone.size(), 1u);
        EXPECT_NEAR(together[i] / alone[0], 1, 1e-5) << i;
    }
}

}  // namespace
}  // namespace lanthorn::gi::test

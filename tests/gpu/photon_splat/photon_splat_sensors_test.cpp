// Light sensors under `splat`.
#include <gtest/gtest.h>

#include "tests/gpu/gi/sensor_room.h"
#include "tests/gpu/photon_splat/photon_splat_bench.h"

namespace lanthorn::gi::test {
namespace {

TEST(PhotonSplatSensors, ReadTheLightThatThePathTracerFinds) {
    const FrameScene scene = lantern_room(1.9f, 1);
    const double expected = sensor_truth(scene);
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
        Splat bench(800'000);
        bench.settings.seed = seed;
        bench.own().bandwidth = 8;  // wide ones blur the light that falls through the door
        const double got = reading_of(bench, scene);
        std::printf("splat, sensor in the lantern room: %.3f of path's\n", got / expected);
        EXPECT_NEAR(got, expected, 0.15 * expected) << seed;
    }
}

TEST(PhotonSplatSensors, SeeTheColourOfBouncedLight) {
    Splat bench;
    expect_the_colour_of_bounced_light(bench, 0.05);
}

TEST(PhotonSplatSensors, SayWhenTheirLightIsAnother) {
    Splat bench, fresh;
    expect_other_light_to_be_told(bench, fresh);
}

}  // namespace
}  // namespace lanthorn::gi::test

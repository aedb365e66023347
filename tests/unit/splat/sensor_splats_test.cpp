// Which bandwidth a light sensor reads by.
#include "gi_module/techniques/splat/sensor_splats.h"

#include <gtest/gtest.h>

#include <vector>

namespace lanthorn::gi {
namespace {

constexpr std::uint64_t kLeast = 20;

// Grey light by so many photons of one power.
SensorLevel level(double lux, std::uint64_t photons) {
    return {dvec3(lux), photons > 0 ? lux * lux / static_cast<double>(photons) : 0, photons};
}

TEST(SensorLevel, EvenLightIsReadByTheWidest) {
    // Off by less than the standard deviation, a tenth and a fifth.
    EXPECT_EQ(sensor_level(std::vector{level(10, 400), level(10.4, 100), level(8.8, 25)}, kLeast), 0u);
}

TEST(SensorLevel, APatchOfLightIsReadByTheWidestThatLiesInIt) {
    const std::vector levels{level(4, 400), level(6, 300), level(10, 200), level(10.5, 100), level(9.6, 25)};
    EXPECT_EQ(sensor_level(levels, kLeast), 2u);
    // And so is a dark place beside it.
    const std::vector dark{level(10, 400), level(4, 100), level(4.1, 60)};
    EXPECT_EQ(sensor_level(dark, kLeast), 1u);
}

TEST(SensorLevel, TooFewPhotonsSayNothing) {
    EXPECT_EQ(sensor_level(std::vector{level(4, 400), level(12, 19)}, kLeast), 0u);
    EXPECT_EQ(sensor_level(std::vector{level(4, 400), level(12, 20)}, kLeast), 1u);
    EXPECT_EQ(sensor_level(std::vector{level(4, 19), level(0, 0)}, kLeast), 0u);
    EXPECT_EQ(sensor_level(std::vector{level(4, 19), level(0, 0)}, 0), 0u);
    EXPECT_EQ(sensor_level(std::vector{level(0, 0)}, kLeast), 0u);
}

// Few photons where the light is dim by chance would have next to no variance of their own.
TEST(SensorLevel, IsNotMisledByFewPhotonsThatVaryLittle) {
    EXPECT_EQ(sensor_level(std::vector{level(10, 400), SensorLevel{dvec3(7.5), 0.1, 25}}, kLeast), 0u);
}

}  // namespace
}  // namespace lanthorn::gi

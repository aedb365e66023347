// What is outside of windows.
#include "game/level/night_sky.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lanthorn/core/colour.h"

namespace lanthorn::game {
namespace {

vec3 towards(float azimuth, float elevation) {
    return {std::cos(elevation) * std::cos(azimuth), std::sin(elevation),
            std::cos(elevation) * std::sin(azimuth)};
}

TEST(NightSky, TheMoonStandsWhereItsLightComesFrom) {
    for (const vec3& moon : {towards(0.3f, 0.4f), towards(-2.5f, 0.8f), vec3(0, 1, 0), towards(3.1f, 0.1f)}) {
        const Sky sky = night_sky(moon);
        EXPECT_GT(luminance(sky_radiance(*sky.image, glm::normalize(moon))), 15) << moon.x << ' ' << moon.y;
        const vec3 beside = glm::normalize(moon + vec3(0.3f, 0.2f, -0.3f));
        EXPECT_LT(luminance(sky_radiance(*sky.image, beside)), 8);
    }
}

// Of 2.6 degrees and some 40 nits: 40 * pi * 0.0227^2 = 0.065 nits steradians, less its seas and with its
// halo.
TEST(NightSky, TheMoonHasItsFlux) {
    const Sky with = night_sky(towards(1, 0.6f)), without = night_sky(towards(1, -1.2f));
    double flux = 0;
    for (std::uint32_t y = 0; y < with.image->height / 2; ++y) {
        for (std::uint32_t x = 0; x < with.image->width; ++x) {
            flux += with.image->pixel_solid_angle(y) *
                    static_cast<double>(luminance(with.image->at(x, y)) - luminance(without.image->at(x, y)));
        }
    }
    EXPECT_GT(flux, 0.04);
    EXPECT_LT(flux, 0.09);
}

// Rooms are lit by what is even in it: levels have the moon as a lamp, and stars would be noise.
TEST(NightSky, NeitherMoonNorStarsLight) {
    const Sky sky = night_sky(towards(1, 0.6f));
    float most = 0, least = 1e9f;
    for (const vec3& radiance : sky.lights_by()->radiance) {
        most = std::max(most, luminance(radiance));
        least = std::min(least, luminance(radiance));
    }
    EXPECT_LT(most, 0.2f);
    EXPECT_GT(least, 0);
    EXPECT_EQ(night_sky(towards(1, 0.6f)).lights_by(), sky.lights_by());
}

TEST(NightSky, HasStarsAboveTheHillsAlone) {
    const Sky sky = night_sky(towards(1, -1.2f));
    int above = 0, below = 0;
    for (std::uint32_t y = 0; y < sky.image->height; ++y) {
        for (std::uint32_t x = 0; x < sky.image->width; ++x) {
            (y < sky.image->height / 2 ? above : below) += luminance(sky.image->at(x, y)) > 0.3f ? 1 : 0;
        }
    }
    EXPECT_GT(above, 800);
    EXPECT_EQ(below, 0);
}

}  // namespace
}  // namespace lanthorn::game

#include "lanthorn/scene/sky.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lanthorn {
namespace {

SkyImage uniform(std::uint32_t width, std::uint32_t height, const vec3& radiance) {
    return {"uniform", width, height, std::vector<vec3>(std::size_t{width} * height, radiance)};
}

dvec3 flux(const SkyImage& image) {
    dvec3 sum(0);
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            sum += dvec3(image.at(x, y)) * image.pixel_solid_angle(y);
        }
    }
    return sum;
}

TEST(Sky, PixelsShareTheWholeSphere) {
    EXPECT_NEAR(flux(uniform(37, 11, vec3(1))).x, 4 * static_cast<double>(kPi), 1e-6);
}

TEST(Sky, DirectionsAndPlacesAreInverse) {
    for (const vec2 place : {vec2(0.1f, 0.2f), vec2(0.5f, 0.5f), vec2(0.93f, 0.71f)}) {
        const vec2 back = sky_place(sky_direction(place));
        EXPECT_NEAR(back.x, place.x, 1e-6);
        EXPECT_NEAR(back.y, place.y, 1e-6);
    }
    EXPECT_NEAR(sky_direction({0.5f, 0.5f}).x, 1, 1e-6);   // the middle
    EXPECT_NEAR(sky_direction({0.75f, 0.5f}).z, 1, 1e-6);  // to the right of it
    EXPECT_NEAR(sky_direction({0.2f, 0.0f}).y, 1, 1e-6);
}

TEST(Sky, IsReadBilinearlyAndRoundTheBack) {
    SkyImage image = uniform(4, 2, vec3(0));
    image.radiance[0] = vec3(8);  // columns 0 and 3 meet at the back
    const vec3 between = sky_radiance(image, sky_direction({0.0f, 0.25f}));
    EXPECT_NEAR(between.x, 4, 1e-4);
    EXPECT_NEAR(sky_radiance(image, sky_direction({0.125f, 0.25f})).x, 8, 1e-4);
    EXPECT_NEAR(sky_radiance(image, vec3(0, 1, 0)).x, 0, 8.1);  // finite at the pole
}

TEST(Sky, KeepsItsFluxWhenCoarser) {
    SkyImage image = uniform(96, 50, vec3(1, 2, 3));
    image.radiance[96 * 7 + 13] = vec3(1e6f);
    const dvec3 before = flux(image);
    const SkyImage coarse = coarser(image, 32);
    EXPECT_EQ(coarse.width, 64u);
    EXPECT_EQ(coarse.height, 32u);
    EXPECT_NEAR(flux(coarse).y / before.y, 1, 1e-6);
}

TEST(Sky, GivesSunsWithTheFluxThatTheImageLoses) {
    SkyImage image = uniform(256, 128, vec3(2000));
    image.radiance[256 * 30 + 100] = vec3(2e9f, 1.8e9f, 1.5e9f);
    const dvec3 before = flux(image);
    const std::vector<SkySun> suns = take_suns(image);
    ASSERT_EQ(suns.size(), 1u);
    const vec3 expected = sky_direction({100.5f / 256, 30.5f / 128});
    EXPECT_GT(glm::dot(suns[0].towards, expected), 0.99999f);
    EXPECT_NEAR((flux(image).x + static_cast<double>(suns[0].illuminance.x)) / before.x, 1, 1e-6);
    EXPECT_NEAR(image.radiance[256 * 30 + 100].x, 2000, 1);  // what lay around it
    EXPECT_TRUE(take_suns(image).empty());
}

TEST(Sky, LeavesWideAndDimSkiesAlone) {
    SkyImage half = uniform(128, 64, vec3(0));
    std::fill(half.radiance.begin(), half.radiance.begin() + 128 * 32, vec3(5000));
    EXPECT_TRUE(take_suns(half).empty());
    SkyImage black = uniform(128, 64, vec3(0));
    EXPECT_TRUE(take_suns(black).empty());
}

// One pixel of 1e6 in a black sky, and an image of a few pixels.
TEST(Sky, TakesOnePixelAsASun) {
    SkyImage image = uniform(64, 32, vec3(0));
    image.radiance[64 * 5 + 5] = vec3(1e6f);
    const double before = flux(image).x;
    const std::vector<SkySun> suns = take_suns(image);
    ASSERT_EQ(suns.size(), 1u);
    EXPECT_NEAR(static_cast<double>(suns[0].illuminance.x) / before, 1, 1e-6);
    EXPECT_NEAR(flux(image).x, 0, 1e-9);
    SkyImage tiny = uniform(2, 1, vec3(3));
    EXPECT_TRUE(take_suns(tiny).empty());
}

// Magnitudes of daylight: a clear sky gives level ground 5 to 40 klx (what is measured outdoors is 8 to 20;
// the model is known to be bright for high suns), the sun at noon 60 to 110 klx, and both less in the
// evening.
TEST(Sky, IsAsBrightAsDaylight) {
    const auto level = [](const SkyImage& image) {
        double sum = 0;
        for (std::uint32_t y = 0; y < image.height / 2; ++y) {
            for (std::uint32_t x = 0; x < image.width; ++x) {
                const vec3 d =
                    sky_direction({(static_cast<float>(x) + 0.5f) / static_cast<float>(image.width),
                                   (static_cast<float>(y) + 0.5f) / static_cast<float>(image.height)});
                const vec3 c = image.at(x, y);
                sum += static_cast<double>(glm::dot(c, vec3(0.2126f, 0.7152f, 0.0722f)) * d.y) *
                       image.pixel_solid_angle(y);
            }
        }
        return sum;
    };
    const vec3 noon = glm::normalize(vec3(1, 1.5f, 0.5f)), evening = glm::normalize(vec3(1, 0.1f, 0));
    EXPECT_GT(level(clear_sky(noon)), 5000);
    EXPECT_LT(level(clear_sky(noon)), 40000);
    EXPECT_LT(level(clear_sky(evening)), level(clear_sky(noon)));
    const Light sun = clear_sun(noon), low = clear_sun(evening);
    EXPECT_GT(sun.intensity, 60000);
    EXPECT_LT(sun.intensity, 110000);
    EXPECT_LT(low.intensity * low.colour.z, 0.5f * sun.intensity * sun.colour.z);
    EXPECT_LT(low.colour.z, 0.7f);  // red
}

TEST(Sky, IsFiniteAndNotNegativeWhateverTheSun) {
    for (const vec3& to_sun : {vec3(0, 1, 0), vec3(0, -1, 0), vec3(1, 0, 0)}) {
        for (const float turbidity : {0.0f, 2.0f, 10.0f, 50.0f}) {
            const SkyImage image = clear_sky(to_sun, turbidity, 16);
            for (const vec3& c : image.radiance) {
                ASSERT_TRUE(std::isfinite(c.x + c.y + c.z));
                ASSERT_GE(std::min({c.x, c.y, c.z}), 0);
            }
            EXPECT_TRUE(std::isfinite(clear_sun(to_sun, turbidity).intensity));
        }
    }
}

}  // namespace
}  // namespace lanthorn

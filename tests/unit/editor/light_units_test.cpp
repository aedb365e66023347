// Lights in lumen, lux and kelvin.
#include <gtest/gtest.h>

#include <cmath>

#include "lanthorn/core/colour.h"
#include "tools/editor/core/light_units.h"
#include "tools/editor/core/lights_table.h"

namespace lanthorn::editor {
namespace {

TEST(LightUnits, APointLightSendsFourPiTimesItsCandela) {
    Light light;
    light.intensity = 65;
    EXPECT_NEAR(lumen(light), 816.8, 0.1);  // a household bulb
    EXPECT_NEAR(candela_for_lumen(light, 800), 63.66, 0.01);
    EXPECT_DOUBLE_EQ(lux_at_one_metre(light), 65);
    EXPECT_NEAR(reach_of_one_lux(light), std::sqrt(65.0), 1e-9);
}

// What KHR_lights_punctual recommends, summed over directions.
TEST(LightUnits, ASpotSendsWhatItsConeLetsThrough) {
    Light light;
    light.type = LightType::spot;
    light.intensity = 100;
    light.inner_cone = 0.3f;
    light.outer_cone = 0.6f;
    const double outer = std::cos(0.6f), scale = 1 / (std::cos(0.3f) - outer);
    double flux = 0;
    constexpr int kRings = 200000;
    for (int i = 0; i < kRings; ++i) {
        const double cosine = 1 - (i + 0.5) * (1 - outer) / kRings;
        const double part = std::clamp((cosine - outer) * scale, 0.0, 1.0);
        flux += 100 * part * part * 2 * 3.14159265358979 * (1 - outer) / kRings;
    }
    EXPECT_NEAR(lumen(light), flux, 1e-4 * flux);
    light.intensity = candela_for_lumen(light, 500);
    EXPECT_NEAR(lumen(light), 500, 1e-3);
}

TEST(LightUnits, ColourCounts) {
    Light light;
    light.colour = vec3(0, 1, 0);
    light.intensity = 10;
    EXPECT_NEAR(lux_at_one_metre(light), 7.152, 1e-5);
    light.intensity = intensity_for_lux(light, 50);
    EXPECT_NEAR(lux_at_one_metre(light), 50, 1e-4);
}

// D65 is the daylight of 6504 K, which is somewhat greener than a black body; A is one of 2856 K, at
// x = 0.44757, y = 0.40745.
TEST(Kelvin, AgreesWithTheStandardLights) {
    const Kelvin white = kelvin_of(vec3(1));
    EXPECT_NEAR(white.kelvin, 6504, 10);
    EXPECT_NEAR(white.distance, 0.0032, 3e-4);
    const dvec3 a(colour_of_kelvin(2856));
    const double x = 0.4123908 * a.x + 0.3575843 * a.y + 0.1804808 * a.z;
    const double y = 0.2126390 * a.x + 0.7151687 * a.y + 0.0721923 * a.z;
    const double z = 0.0193308 * a.x + 0.1191948 * a.y + 0.9505322 * a.z;
    EXPECT_NEAR(x / (x + y + z), 0.44757, 1e-3);
    EXPECT_NEAR(y / (x + y + z), 0.40745, 1e-3);
}

TEST(Kelvin, ComesBack) {
    for (const double kelvin : {1950.0, 2700.0, 4000.0, 6500.0, 10000.0, 19000.0}) {
        const vec3 colour = colour_of_kelvin(kelvin);
        EXPECT_NEAR(luminance(dvec3(colour)), 1, 1e-5);
        const Kelvin back = kelvin_of(colour);
        EXPECT_NEAR(back.kelvin, kelvin, 0.002 * kelvin);
        EXPECT_NEAR(back.distance, 0, 1e-4);
    }
    EXPECT_GT(kelvin_of(vec3(0.2f, 1, 0.2f)).distance, 0.02);
    EXPECT_LT(kelvin_of(vec3(1, 0.2f, 1)).distance, -0.02);
    EXPECT_EQ(kelvin_of(vec3(0)).kelvin, 0);
    EXPECT_GE(colour_of_kelvin(1000).z, 0);  // beyond Rec. 709: blue is cut off
}

}  // namespace
}  // namespace lanthorn::editor

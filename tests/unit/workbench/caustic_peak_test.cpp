#include <gtest/gtest.h>

#include <cmath>

#include "tools/workbench/measure/caustic_peak.h"

namespace lanthorn::workbench {
namespace {

constexpr ivec2 kSize(64, 48);

// A floor of a metre a pixel; one column of it is glass.
std::vector<std::optional<vec3>> floor_places() {
    std::vector<std::optional<vec3>> places;
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
            places.push_back(x == 60 ? std::nullopt : std::optional(vec3(x, 0, y)));
        }
    }
    return places;
}

TEST(CausticPeak, IsWhereABrightSpotIsNotWhereASpeckIs) {
    std::vector<double> lux;
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
            const double r2 = (x - 20) * (x - 20) + (y - 30) * (y - 30);
            lux.push_back(x == 60 ? 1e6 : 10 * std::exp(-r2 / 32));
        }
    }
    lux[10 * 64 + 40] = 15;  // of noise
    const auto place = brightest_place(lux, floor_places(), kSize);
    ASSERT_TRUE(place);
    EXPECT_NEAR(place->x, 20, 0.1);
    EXPECT_NEAR(place->z, 30, 0.1);
}

TEST(CausticPeak, ThereIsNoneWithoutLight) {
    const std::vector<double> dark(64 * 48, 0);
    EXPECT_FALSE(brightest_place(dark, floor_places(), kSize));
}

}  // namespace
}  // namespace lanthorn::workbench

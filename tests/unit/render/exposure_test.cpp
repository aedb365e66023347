#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lanthorn/render/render_settings.h"

namespace lanthorn::render {
namespace {

TEST(Exposure, ShowsTwelveTenthsOfANitAsWhiteAtNought) {
    EXPECT_FLOAT_EQ(exposure_of_ev100(0), 1 / 1.2f);
    EXPECT_FLOAT_EQ(exposure_of_ev100(3), 1 / 9.6f);
    EXPECT_DOUBLE_EQ(ev100_of_exposure(1 / 9.6), 3);
}

// Over all that render.exposure.ev100 takes.
TEST(Exposure, ComesBackFromItsFactor) {
    for (float ev = -20; ev <= 40; ev += 0.125f) {
        const float factor = exposure_of_ev100(ev);
        EXPECT_NEAR(ev100_of_exposure(static_cast<double>(factor)), static_cast<double>(ev), 1e-6);
    }
}

TEST(Exposure, IsFiniteAtExtremes) {
    using Limits = std::numeric_limits<float>;
    const double darkest = ev100_of_exposure(static_cast<double>(Limits::max()));
    const double brightest = ev100_of_exposure(static_cast<double>(Limits::min()));
    EXPECT_NEAR(darkest, -128.26, 0.01);
    EXPECT_NEAR(brightest, 125.74, 0.01);
    EXPECT_EQ(ev100_of_exposure(std::numeric_limits<double>::infinity()), darkest);
    for (const double none :
         {0.0, -1.0, -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_EQ(ev100_of_exposure(none), brightest);
    }
}

}  // namespace
}  // namespace lanthorn::render

#include "lanthorn/core/turns.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lanthorn {
namespace {

TEST(Turns, AreSineAndCosine) {
    for (double angle = -20; angle <= 20; angle += 0.01) {
        const SineCosine turn = sine_cosine(angle);
        ASSERT_NEAR(turn.sine, std::sin(angle), 4e-15) << angle;
        ASSERT_NEAR(turn.cosine, std::cos(angle), 4e-15) << angle;
    }
    EXPECT_EQ(sine_cosine(0).sine, 0);
    EXPECT_EQ(sine_cosine(0).cosine, 1);
}

TEST(Turns, AreThoseAboutTheAxes) {
    for (const double angle : {-3.0, -0.4, 0.0, 1.9}) {
        EXPECT_LT(glm::length(about_x(angle) - glm::angleAxis(angle, dvec3(1, 0, 0))), 1e-15);
        EXPECT_LT(glm::length(about_y(angle) - glm::angleAxis(angle, dvec3(0, 1, 0))), 1e-15);
        EXPECT_LT(glm::length(about_z(angle) - glm::angleAxis(angle, dvec3(0, 0, 1))), 1e-15);
    }
}

}  // namespace
}  // namespace lanthorn

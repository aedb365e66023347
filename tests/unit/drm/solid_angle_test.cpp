// The solid angles of Frisvad et al. 2005 against those of shapes that are known in closed form.
#include "gi_module/techniques/drm/solid_angle.h"

#include <gtest/gtest.h>

#include "lanthorn/core/math.h"

namespace lanthorn::gi {
namespace {

constexpr double kPiD = 3.14159265358979323846;

// Of a disc of radius R from its axis, at distance r: 2 pi (1 - r / sqrt(r^2 + R^2)).
double disc_solid_angle(double radius, double r) {
    return 2 * kPiD * (1 - r / std::hypot(r, radius));
}

// Irradiance of a disc of radiance 1 on a surface that faces it from its axis: pi R^2 / (R^2 + r^2).
double disc_irradiance(double radius, double r) {
    return kPiD * radius * radius / (radius * radius + r * r);
}

TEST(SolidAngle, Eq14IsADiscsFarAway) {
    for (const double radius : {0.01, 0.5, 20.0}) {
        const double area = kPiD * radius * radius;
        for (const double widths : {5.0, 10.0, 50.0}) {  // Lambert's rule of thumb begins at five
            const double r = widths * 2 * radius;
            const double eq14 = static_cast<double>(
                drm_solid_angle_14(1, static_cast<float>(area), static_cast<float>(r * r)));
            const double exact = disc_solid_angle(radius, r);
            // To second order A / (A + r^2) is less than 2 pi (1 - r / sqrt(r^2 + R^2)) by (pi - 3 / 4) R^2 /
            // r^2.
            const double less = (kPiD - 0.75) * radius * radius / (r * r);
            EXPECT_NEAR(eq14 / exact, 1 - less, 1.5 * less * less) << radius << " " << widths;
        }
    }
}

TEST(SolidAngle, Eq14IsBoundedWhereItMeetsTheSurface) {
    for (const float area : {1e-8f, 1.0f, 1e8f}) {
        float last = 0;
        for (float r2 = 1e6f * area; r2 > 1e-12f * area; r2 *= 0.1f) {
            const float angle = drm_solid_angle_14(0.7f, area, r2);
            EXPECT_GE(angle, last);  // nearer is wider,
            EXPECT_LE(angle, 0.7f);  // and no wider than the cosine: A / r^2 would go to infinity
            last = angle;
        }
        EXPECT_NEAR(drm_solid_angle_14(0.7f, area, 0), 0.7f, 1e-6f);
    }
}

TEST(SolidAngle, TheDiscsGivesADiscsIrradianceAtAnyDistance) {
    for (const double radius : {0.1, 3.0}) {
        const auto area = static_cast<float>(kPiD * radius * radius);
        for (const double r : {0.0, 0.01, 0.3, 1.0, 10.0, 300.0}) {
            const auto got = static_cast<double>(drm_solid_angle_disc(1, area, static_cast<float>(r * r)));
            EXPECT_NEAR(got / disc_irradiance(radius, r), 1, 1e-5) << radius << " " << r;
        }
    }
}

// Over all of a sphere eq. 12's squares of area are too many at wide texels, and right at narrow ones: the
// picture of a quarter turn has (2 tan(pi / (4 w)))^2 w^2 where a cube's face is pi * 2 / 3.
TEST(SolidAngle, Eq12IsATexelsSolidAngleWhereTexelsAreSmall) {
    const float quarter = 1.57079632679f;
    EXPECT_NEAR(drm_area_across(1, quarter, 1), 4, 1e-5);  // the face itself
    EXPECT_NEAR(drm_area_across(3, quarter, 64), 9 * std::pow(quarter / 64, 2),
                1e-5);  // b^2 times a small angle squared
    EXPECT_NEAR(drm_area_across(2, quarter, 8) / drm_area_across(1, quarter, 8), 4, 1e-5);
}

TEST(SolidAngle, Eq13SpreadsTheAreaAndIsBoundedWhereLightGrazes) {
    EXPECT_FLOAT_EQ(drm_area(2, 1), 2);
    EXPECT_FLOAT_EQ(drm_area(2, 0.5f), 4);
    for (const float cosine : {0.0f, -0.0f, -1.0f, 1e-30f}) {
        EXPECT_FLOAT_EQ(drm_area(2, cosine), 2 / kLeastCosAlpha);
    }
}

TEST(SolidAngle, Eq11SharesTheHemisphere) {
    for (const float samples : {1.0f, 9.0f, 256.0f}) {
        EXPECT_NEAR(samples * drm_solid_angle_11(samples), 2 * kPiD, 1e-5);
    }
}

TEST(SolidAngle, Eq15IsEq7AtTheScenesDiagonal) {
    EXPECT_FLOAT_EQ(drm_solid_angle_15(3, 12), 0.25f);
}

}  // namespace
}  // namespace lanthorn::gi

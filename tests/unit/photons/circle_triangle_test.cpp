// Areas of triangles cut by circles against closed forms and against counting.
#include "gi_module/shared/photons/circle_triangle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gi_module/reference/random.h"
#include "tests/support/closed_forms.h"

namespace lanthorn::gi::test {
namespace {

using glm::dvec2;
using support::kPiD;

TEST(CircleTriangle, AWholeTriangleIsItself) {
    const AreaMoment all = circle_triangle({dvec2(0, 0), dvec2(2, 0), dvec2(0, 3)}, 10);
    EXPECT_NEAR(all.area, 3, 1e-12);
    EXPECT_NEAR(all.moment, 3.0 / 6 * (4 + 9), 1e-12);  // b h (b^2 + h^2) / 12 about the right angle
}

TEST(CircleTriangle, AWholeCircleIsItself) {
    const AreaMoment all = circle_triangle({dvec2(-50, -40), dvec2(60, -40), dvec2(0, 70)}, 1.5);
    EXPECT_NEAR(all.area, kPiD * 2.25, 1e-12);
    EXPECT_NEAR(all.moment, 0.5 * kPiD * std::pow(1.5, 4), 1e-12);
}

TEST(CircleTriangle, AHalfPlaneLeavesASegment) {
    for (const double d : {-0.9, -0.3, 0.0, 0.5, 0.99}) {
        const AreaMoment got = circle_triangle({dvec2(d, -1000), dvec2(1000, 0), dvec2(d, 1000)}, 1);
        EXPECT_NEAR(got.area, std::acos(d) - d * std::sqrt(1 - d * d), 1e-5)
            << d;  // its far corner cuts a little
    }
}

TEST(CircleTriangle, AQuarterAtACorner) {
    const AreaMoment got = circle_triangle({dvec2(0, 0), dvec2(5, 0), dvec2(0, 5)}, 1);
    EXPECT_NEAR(got.area, kPiD / 4, 1e-12);
    EXPECT_NEAR(got.moment, kPiD / 8, 1e-12);
}

TEST(CircleTriangle, ApartIsNothing) {
    EXPECT_NEAR(circle_triangle({dvec2(2, 0), dvec2(3, 0), dvec2(2, 1)}, 1).area, 0, 1e-14);
    EXPECT_EQ(circle_triangle({dvec2(0, 0), dvec2(1, 0), dvec2(0, 1)}, 0).area, 0);
    EXPECT_NEAR(circle_triangle({dvec2(0, 0), dvec2(1, 0), dvec2(2, 0)}, 1).area, 0, 1e-14);  // no triangle
    EXPECT_NEAR(circle_triangle({dvec2(0.2, 0.1), dvec2(0.2, 0.1), dvec2(0.2, 0.1)}, 1).area, 0, 1e-14);
}

TEST(CircleTriangle, EitherWindingIsTheSame) {
    const AreaMoment a = circle_triangle({dvec2(-0.5, 0.1), dvec2(2, -0.4), dvec2(0.3, 1.4)}, 1);
    const AreaMoment b = circle_triangle({dvec2(-0.5, 0.1), dvec2(0.3, 1.4), dvec2(2, -0.4)}, 1);
    EXPECT_NEAR(a.area, b.area, 1e-14);
    EXPECT_NEAR(a.moment, b.moment, 1e-14);
}

// Any triangle, by points of a fine lattice that are in both.
TEST(CircleTriangle, IsWhatCountingFinds) {
    constexpr int kSide = 700;
    for (std::uint32_t trial = 0; trial < 40; ++trial) {
        const reference::RandomNumbers random(1, trial, 0);
        std::array<dvec2, 3> t;
        for (std::uint32_t i = 0; i < 3; ++i) {
            t[i] = (dvec2(random.pair(i)) - 0.5) * 4.0;
        }
        const auto side = [&](const dvec2& p, std::size_t i) {
            const dvec2 e = t[(i + 1) % 3] - t[i], d = p - t[i];
            return e.x * d.y - e.y * d.x > 0;
        };
        double area = 0, moment = 0;
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                const dvec2 p((x + 0.5) * 2 / kSide - 1, (y + 0.5) * 2 / kSide - 1);
                const bool a = side(p, 0), b = side(p, 1), c = side(p, 2);
                if (glm::dot(p, p) < 1 && a == b && b == c) {
                    area += 4.0 / (kSide * kSide);
                    moment += glm::dot(p, p) * 4.0 / (kSide * kSide);
                }
            }
        }
        const AreaMoment got = circle_triangle(t, 1);
        EXPECT_NEAR(got.area, area, 3e-3) << trial;
        EXPECT_NEAR(got.moment, moment, 3e-3) << trial;
    }
}

double area_of(const dvec2& a, const dvec2& b, const dvec2& c, double radius) {
    return circle_triangle({a, b, c}, radius).area;
}

TEST(CircleTriangle, IsTheSameBothWaysRound) {
    EXPECT_NEAR(area_of({-10, -10}, {10, -10}, {0, 20}, 1), kPiD, 1e-12);
    EXPECT_NEAR(area_of({0, 20}, {10, -10}, {-10, -10}, 1), kPiD, 1e-12);
    EXPECT_NEAR(area_of({0, 0}, {1, 0}, {0, 1}, 5), 0.5, 1e-12);
    EXPECT_NEAR(area_of({0.5, 0.5}, {0.5, 1.5}, {1.5, 0.5}, 5), 0.5, 1e-12);
}

// A right angle at the centre holds a quarter, an edge through it a half.
TEST(CircleTriangle, OfAnglesAtTheCentreIsTheirShare) {
    EXPECT_NEAR(area_of({0, 0}, {10, 0}, {0, 10}, 1), kPiD / 4, 1e-12);
    EXPECT_NEAR(area_of({-10, 0}, {10, 0}, {0, 10}, 1), kPiD / 2, 1e-12);
    EXPECT_NEAR(area_of({3, 3}, {4, 3}, {3, 4}, 1), 0, 1e-15);
    EXPECT_EQ(area_of({0, 0}, {0, 0}, {0, 0}, 1), 0);
}

TEST(SphereTriangle, APlaneAtAHeightIsASmallerCircle) {
    const AreaMoment got = sphere_triangle({dvec3(-90, 0.6, -90), dvec3(90, 0.6, -90), dvec3(0, 0.6, 90)}, 1);
    EXPECT_NEAR(got.area, kPiD * 0.64, 1e-12);
    EXPECT_NEAR(got.moment, 0.5 * kPiD * 0.64 * 0.64 + 0.36 * kPiD * 0.64, 1e-12);
}

}  // namespace
}  // namespace lanthorn::gi::test

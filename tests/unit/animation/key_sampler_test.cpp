// Sampling against values computed by hand from glTF 2.0, appendix C.
#include "engine/animation/key_sampler.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/animation/channels.h"

namespace animation_test {
namespace {

void expect_near(const std::vector<double>& found, const std::vector<double>& expected,
                 double tolerance = 1e-7) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_NEAR(found[i], expected[i], tolerance) << "number " << i;
    }
}

TEST(KeySampler, StepHoldsTheKeyBefore) {
    const auto c =
        channel(AnimationPath::translation, Interpolation::step, {1, 2, 4}, {1, 2, 3, 4, 5, 6, 7, 8, 9});
    expect_near(value_at(c, 1.0), {1, 2, 3});
    expect_near(value_at(c, 1.999), {1, 2, 3});
    expect_near(value_at(c, 2.0), {4, 5, 6});
    expect_near(value_at(c, 3.9), {4, 5, 6});
    expect_near(value_at(c, 4.0), {7, 8, 9});
}

TEST(KeySampler, LinearGoesStraight) {
    const auto c = channel(AnimationPath::scale, Interpolation::linear, {1, 3}, {0, 10, -4, 4, 30, 4});
    expect_near(value_at(c, 1.5), {1, 15, -2});
    expect_near(value_at(c, 2.0), {2, 20, 0});
}

TEST(KeySampler, OutsideTheKeysTheirValuesHold) {
    for (const auto mode : {Interpolation::step, Interpolation::linear}) {
        const auto c = channel(AnimationPath::translation, mode, {1, 3}, {1, 2, 3, 4, 5, 6});
        expect_near(value_at(c, -100), {1, 2, 3});
        expect_near(value_at(c, 0.5), {1, 2, 3});
        expect_near(value_at(c, 100), {4, 5, 6});
    }
    const auto spline = channel(AnimationPath::translation, Interpolation::cubic_spline, {1, 3},
                                {9, 9, 9, 1, 2, 3, 9, 9, 9, 9, 9, 9, 4, 5, 6, 9, 9, 9});
    expect_near(value_at(spline, 0), {1, 2, 3});
    expect_near(value_at(spline, 1), {1, 2, 3});
    expect_near(value_at(spline, 3), {4, 5, 6});
    expect_near(value_at(spline, 7), {4, 5, 6});
}

// As the importer leaves keys before 0, and two of one time.
TEST(KeySampler, KeysBeforeTheStartCountAndLeapsAreSharp) {
    const auto early = channel(AnimationPath::translation, Interpolation::linear, {-0.5f, 0.5f, 1.5f},
                               {-1, 0, 0, 0, 0, 0, 1, 0, 0});
    expect_near(value_at(early, 0), {-0.5, 0, 0});
    expect_near(value_at(early, 0.5), {0, 0, 0});
    expect_near(value_at(early, 1.4), {0.9, 0, 0});
    const float later = std::nextafter(1.0f, 2.0f);
    for (const auto mode : {Interpolation::linear, Interpolation::cubic_spline}) {
        auto leap = channel(AnimationPath::translation, mode, {0, 1, later, 2},
                            {-1.5f, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0});
        if (mode == Interpolation::cubic_spline) {
            std::vector<float> values;
            for (const float x : {-1.5f, -1.0f, 0.0f, 1.0f}) {
                values.insert(values.end(), {0, 0, 0, x, 0, 0, 0, 0, 0});
            }
            leap.values = values;
        }
        expect_near(value_at(leap, 0.5), {-1.25, 0, 0});
        expect_near(value_at(leap, 1), {-1, 0, 0});
        expect_near(value_at(leap, later), {0, 0, 0});
        expect_near(value_at(leap, 1.5), {0.5, 0, 0});
        expect_near(value_at(leap, 3), {1, 0, 0});
    }
}

TEST(KeySampler, OneKeyIsAConstant) {
    const auto linear = channel(AnimationPath::translation, Interpolation::linear, {2}, {1, 2, 3});
    const auto spline =
        channel(AnimationPath::translation, Interpolation::cubic_spline, {2}, {9, 9, 9, 1, 2, 3, 9, 9, 9});
    for (const double time : {0.0, 2.0, 5.0}) {
        expect_near(value_at(linear, time), {1, 2, 3});
        expect_near(value_at(spline, time), {1, 2, 3});
    }
}

// v0 = 0, v1 = 1, out-tangent 1, in-tangent 2, keys 2 s apart. At u = 1/2 the polynomials are
// 1/2, 1/8, 1/2, -1/8: 2 s * 1/8 * 1 + 1/2 - 2 s * 1/8 * 2 = 1/4.
TEST(KeySampler, CubicSplineAtTheMiddle) {
    const auto c = channel(AnimationPath::weights, Interpolation::cubic_spline, {0, 2}, {7, 0, 1, 2, 1, 7});
    expect_near(value_at(c, 1.0), {0.25});
    // u = 1/4: 27/32, 9/64, 5/32, -3/64.
    expect_near(value_at(c, 0.5), {2 * 9.0 / 64 + 5.0 / 32 - 2 * 2 * 3.0 / 64});
}

// Without tangents: 3u^2 - 2u^3.
TEST(KeySampler, CubicSplineWithoutTangentsIsTheSmoothStep) {
    const auto c = channel(AnimationPath::weights, Interpolation::cubic_spline, {0, 1}, {0, 0, 0, 0, 1, 0});
    for (const double u : {0.1, 0.25, 0.5, 0.9}) {
        expect_near(value_at(c, u), {3 * u * u - 2 * u * u * u});
    }
}

TEST(KeySampler, WeightsOfSeveralTargets) {
    auto c = channel(AnimationPath::weights, Interpolation::linear, {0, 1}, {0, 1, 2, 10, 11, 12});
    c.width = 3;
    expect_near(value_at(c, 0.5), {5, 6, 7});
}

AnimationChannel turn(double from, double to, double sign = 1) {
    const auto a = about_z(from);
    auto b = about_z(to);
    for (float& v : b) {
        v *= static_cast<float>(sign);
    }
    std::vector<float> values(a.begin(), a.end());
    values.insert(values.end(), b.begin(), b.end());
    return channel(AnimationPath::rotation, Interpolation::linear, {0, 1}, values);
}

void expect_angle(const std::vector<double>& q, double degrees) {
    const double half = degrees * 3.14159265358979323846 / 360;
    const double side = q[2] * std::sin(half) + q[3] * std::cos(half) < 0 ? -1 : 1;
    expect_near(q, {0, 0, side * std::sin(half), side * std::cos(half)}, 1e-6);
}

TEST(KeySampler, RotationsTurnEvenly) {
    expect_angle(value_at(turn(0, 90), 1.0 / 3), 30);
    expect_angle(value_at(turn(10, 170), 0.25), 50);
}

// q and -q are one rotation: from 0 to 90 degrees it is never the long way round.
TEST(KeySampler, RotationsGoTheShortWay) {
    expect_angle(value_at(turn(0, 90, -1), 1.0 / 3), 30);
    expect_angle(value_at(turn(0, 270), 0.5), -45);
    expect_angle(value_at(turn(170, -170), 0.5), 180);
}

TEST(KeySampler, NearlyEqualRotationsStayUnit) {
    for (const double sign : {1.0, -1.0}) {
        expect_angle(value_at(turn(30, 30, sign), 0.7), 30);
        expect_angle(value_at(turn(30, 30.00001, sign), 0.5), 30);
    }
}

TEST(KeySampler, QuantisedRotationsComeOutUnit) {
    const auto c = channel(AnimationPath::rotation, Interpolation::linear, {0, 1},
                           {0, 0, 0, 0.996f, 0, 0, 0.7007f, 0.7087f});
    for (const double time : {-1.0, 0.0, 0.3, 1.0}) {
        double square = 0;
        for (const double v : value_at(c, time)) {
            square += v * v;
        }
        EXPECT_NEAR(square, 1, 1e-12);
    }
}

// Identity to 180 degrees about z without tangents: at 1/2 the sum is (0, 0, 1/2, 1/2), normalised 90
// degrees.
TEST(KeySampler, CubicRotationsAreNormalised) {
    const auto c = channel(AnimationPath::rotation, Interpolation::cubic_spline, {0, 1},
                           {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0});
    expect_near(value_at(c, 0.5), {0, 0, std::sqrt(0.5), std::sqrt(0.5)});
}

TEST(KeySampler, ACubicRotationThroughZeroIsNoNan) {
    const auto c = channel(AnimationPath::rotation, Interpolation::cubic_spline, {0, 1},
                           {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0});
    expect_near(value_at(c, 0.5), {0, 0, 0, 1});
}

TEST(KeySampler, TheHintNeverChangesTheValue) {
    std::vector<float> times;
    std::vector<float> values;
    for (int k = 0; k < 40; ++k) {
        times.push_back(static_cast<float>(k * k) / 16);
        values.insert(values.end(),
                      {static_cast<float>(k), static_cast<float>(k % 7), static_cast<float>(-k)});
    }
    const auto c = channel(AnimationPath::translation, Interpolation::linear, times, values);
    for (double time = -1; time < 100; time += 0.37) {
        const auto expected = value_at(c, time);
        for (const std::uint32_t given : {0u, 1u, 17u, 38u, 39u, 40u, 1000u, 0xffffffffu}) {
            std::uint32_t hint = given;
            std::vector<double> value(3);
            sample(c, time, hint, value);
            EXPECT_EQ(value, expected) << time << " hint " << given;
            EXPECT_LT(hint, 40u);
        }
    }
}

}  // namespace
}  // namespace animation_test

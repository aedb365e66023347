// The equations of Frisvad et al. 2005 as the shaders evaluate them, against shapes that are known in closed
// form.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "gi_module/techniques/drm/radiance_sample.h"
#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"
#include "tests/gpu/drm/drm_bench.h"
#include "tests/support/closed_forms.h"

namespace lanthorn::gi::test {
namespace drm_equations_test {

using support::kPiD;

// A sample that a receiver at the origin looks at.
struct Question {
    RadianceSample sample{};
    vec3 normal{0, 0, 1};  // of the receiver
};

// Straight above the receiver at `r` metres, looking down.
Question above(double r, double area) {
    Question q;
    q.sample.position = vec3(0, 0, r);
    q.sample.normal = vec3(0, 0, -1);
    q.sample.area = static_cast<float>(area);
    return q;
}

std::vector<vec4> answers(const std::vector<Question>& questions, int by_area,
                          float least_distance = 1e-30f) {
    context();
    std::vector<RadianceSample> samples;
    std::vector<vec4> normals;
    for (const Question& q : questions) {
        samples.push_back(q.sample);
        normals.emplace_back(q.normal, 0);
    }
    const gpu::Buffer in = gpu::Buffer::from(samples);
    const gpu::Buffer receivers = gpu::Buffer::from(normals);
    const gpu::Buffer out(normals.size() * sizeof(vec4));
    const gpu::Program program({"tests/gpu/drm/sample_shares.comp"});
    in.bind_storage(kSamplesBinding);
    receivers.bind_storage(5);
    out.bind_storage(6);
    program.use();
    program.set("by_area", by_area);
    program.set("least_distance", least_distance);
    program.dispatch(static_cast<int>(questions.size()), 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    return out.read<vec4>(questions.size());
}

double of(float value) {
    return static_cast<double>(value);
}

// The irradiance of radiance 1: a sample's share of radiance times its area.
double irradiance(const vec4& answer, double area) {
    return of(answer.x) * area;
}

// Irradiance of a disc of radiance 1 on a surface that faces it from its axis.
double disc_irradiance(double radius, double r) {
    return kPiD * radius * radius / (radius * radius + r * r);
}

// Of a disc of radius R from its axis, at distance r: 2 pi (1 - r / sqrt(r^2 + R^2)).
double disc_solid_angle(double radius, double r) {
    return 2 * kPiD * (1 - r / std::hypot(r, radius));
}

TEST(DrmEquations, Eq14IsADiscsFarAway) {
    for (const double radius : {0.01, 0.5, 20.0}) {
        const double area = kPiD * radius * radius;
        for (const double widths : {5.0, 10.0, 50.0}) {  // Lambert's rule of thumb begins at five
            const double r = widths * 2 * radius;
            const double eq14 = irradiance(answers({above(r, area)}, 1)[0], area);
            // To second order A / (A + r^2) is less than 2 pi (1 - r / sqrt(r^2 + R^2)) by (pi - 3 / 4) R^2 /
            // r^2.
            const double less = (kPiD - 0.75) * radius * radius / (r * r);
            EXPECT_NEAR(eq14 / disc_solid_angle(radius, r), 1 - less, 1.5 * less * less + 1e-6)
                << radius << " " << widths;
        }
    }
}

TEST(DrmEquations, Eq14IsBoundedWhereItMeetsTheSurface) {
    for (const double area : {1e-8, 1.0, 1e8}) {
        std::vector<Question> questions;
        for (double r2 = 1e6 * area; r2 > 1e-12 * area; r2 *= 0.1) {
            questions.push_back(above(std::sqrt(r2), area));
            questions.back().sample.normal = vec3(0, std::sqrt(1 - 0.7f * 0.7f), -0.7f);
        }
        double last = 0;
        for (const vec4& answer : answers(questions, 1)) {
            const double now = irradiance(answer, area);
            EXPECT_GE(now, last * (1 - 1e-6));  // nearer is wider,
            EXPECT_LE(now, 0.7 * (1 + 1e-6));   // and no wider than the cosine: A / r^2 would go to infinity
            last = now;
        }
        EXPECT_NEAR(last, 0.7, 1e-5);
    }
}

TEST(DrmEquations, TheDiscsGivesADiscsIrradianceAtAnyDistance) {
    for (const double radius : {0.1, 3.0}) {
        const double area = kPiD * radius * radius;
        for (const double r : {0.01, 0.3, 1.0, 10.0, 300.0}) {
            const double got = irradiance(answers({above(r, area / kPiD)}, 1)[0], area);
            EXPECT_NEAR(got / disc_irradiance(radius, r), 1, 1e-5) << radius << " " << r;
        }
    }
}

// Both cosines, and neither side sends or gets anything behind it.
TEST(DrmEquations, GoWithTheCosinesOfBothSides) {
    const auto tilted = [](float here, float there) {
        Question q = above(2, 3);
        q.normal = vec3(std::sqrt(1 - here * here), 0, here);
        q.sample.normal = vec3(0, std::sqrt(1 - there * there), -there);
        return q;
    };
    const std::vector<Question> questions = {tilted(1, 1),        tilted(0.5f, 1),  tilted(1, 0.25f),
                                             tilted(0.5f, 0.25f), tilted(-0.5f, 1), tilted(1, -0.5f)};
    const std::vector<vec4> by_area = answers(questions, 1), by_angle = answers(questions, 0);
    for (std::size_t i = 0; i < questions.size(); ++i) {
        const double here = std::max(of(questions[i].normal.z), 0.0);
        const double there = std::max(-of(questions[i].sample.normal.z), 0.0);
        EXPECT_NEAR(of(by_area[i].x), here * there / (3 + 4), 1e-6) << i;
        EXPECT_NEAR(of(by_angle[i].x), here, 1e-6) << i << ": eqs. 11 and 15 know no cos(theta')";
    }
}

TEST(DrmEquations, WhatIsNearerThanTheLeastDistanceIsThatFar) {
    const std::vector<vec4> near = answers({above(0.001, 1)}, 0, 0.01f * 0.01f);
    EXPECT_NEAR(of(near[0].x), 0.1, 1e-5);
}

TEST(DrmEquations, Eq13SpreadsTheAreaAndIsBoundedWhereLightGrazes) {
    std::vector<Question> questions;
    const std::vector<float> cosines = {1.0f, 0.5f, 0.05f, 1e-30f, 0.0f, -0.0f, -1.0f};
    for (const float cosine : cosines) {
        questions.push_back(above(1, of(cosine)));
        questions.back().sample.across = 2;
    }
    const std::vector<vec4> got = answers(questions, 1);
    for (std::size_t i = 0; i < cosines.size(); ++i) {
        EXPECT_FLOAT_EQ(got[i].y, 2 / std::max(cosines[i], 0.05f)) << cosines[i];
    }
}

// Eq. 13's area over the squared distance is eq. 14's far away and has no bound near by.
TEST(DrmEquations, Eq13sProjectionHasNoBound) {
    for (const double r : {100.0, 1.0, 1e-3}) {
        const double area = 2;
        const double eq13 = irradiance(answers({above(r, area)}, 2)[0], area);
        const double eq14 = irradiance(answers({above(r, area)}, 1)[0], area);
        EXPECT_NEAR(eq13 * r * r / area, 1, 1e-5);
        EXPECT_NEAR(eq13 / eq14, 1 + area / (r * r), 1e-5 * (1 + area / (r * r)));
    }
}

TEST(DrmEquations, Eq11SharesTheHemisphereAndEq15TakesTheDiagonal) {
    for (const float samples : {1.0f, 9.0f, 256.0f}) {
        Question q = above(1, 1);
        q.sample.across = samples;
        q.sample.sent = vec3(3);
        const vec4 got = answers({q}, 0)[0];
        EXPECT_NEAR(of(samples * got.z), 2 * kPiD, 1e-5);
        EXPECT_FLOAT_EQ(got.w, 3 / samples);
    }
}

}  // namespace drm_equations_test
}  // namespace lanthorn::gi::test

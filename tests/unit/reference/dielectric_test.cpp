// The boundary of two dielectrics, held to Snell and Fresnel.
#include <gtest/gtest.h>

#include <cmath>

#include "gi_module/reference/dielectric.h"
#include "gi_module/reference/random.h"

namespace lanthorn::reference::test {
namespace dielectric_test {

const vec3 kUp(0, 0, 1);

vec3 at_angle(double degrees) {
    const double angle = degrees * 3.14159265358979323846 / 180;
    return vec3(dvec3(std::sin(angle), 0, std::cos(angle)));
}

// Fresnel's equations by angles instead of cosines (Born and Wolf, sec. 1.5.3).
double reflectance(double degrees, double eta) {
    const double i = degrees * 3.14159265358979323846 / 180;
    if (i == 0) {
        return std::pow((eta - 1) / (eta + 1), 2);
    }
    const double t = std::asin(std::sin(i) / eta);
    return 0.5 *
           (std::pow(std::sin(i - t) / std::sin(i + t), 2) + std::pow(std::tan(i - t) / std::tan(i + t), 2));
}

BoundarySample smooth(double degrees, float eta, float choice) {
    return sample_boundary(at_angle(degrees), kUp, kUp, eta, 0, choice, vec2(0.5f));
}

TEST(Boundary, ReflectsAsFresnelSays) {
    for (const float eta : {1.33f, 1.5f, 3.0f, 1 / 1.33f, 1 / 1.5f}) {
        for (const double degrees : {0.0, 20.0, 35.0, 41.0, 60.0, 80.0, 89.0}) {
            if (std::sin(glm::radians(degrees)) >= static_cast<double>(eta)) {
                continue;
            }
            const Incidence at(at_angle(degrees).z, eta);
            EXPECT_NEAR(at.reflectance, reflectance(degrees, static_cast<double>(eta)), 1e-4)
                << degrees << " degrees, " << eta;
        }
    }
    EXPECT_NEAR(Incidence(1, 1.5f).reflectance, 0.04, 1e-6);
    // Brewster's angle: none of the light in the plane of incidence.
    const double brewster = glm::degrees(std::atan(1.5));
    EXPECT_NEAR(Incidence(at_angle(brewster).z, 1.5f).reflectance, 0.5 * std::pow(1.25 / 3.25, 2), 1e-6);
    EXPECT_NEAR(Incidence(1e-4f, 1.5f).reflectance, 1, 1e-3) << "grazing";
}

TEST(Boundary, BendsAsSnellSays) {
    for (const float eta : {1.0f, 1.33f, 1.5f, 3.0f, 1 / 1.33f, 1 / 1.5f}) {
        for (const double degrees : {0.0, 10.0, 25.0, 40.0}) {
            const BoundarySample sample = smooth(degrees, eta, 0.9999f);
            ASSERT_TRUE(sample.through);
            EXPECT_EQ(sample.weight, 1);
            const double sine = std::sin(glm::radians(degrees)) / static_cast<double>(eta);
            EXPECT_NEAR(sample.direction.x, -sine, 1e-6) << degrees << " degrees, " << eta;
            EXPECT_LT(sample.direction.z, 0);
            EXPECT_NEAR(glm::length(sample.direction), 1, 1e-6);
        }
    }
}

TEST(Boundary, ReflectsAllBeyondTheCriticalAngle) {
    const double critical = glm::degrees(std::asin(1 / 1.5));
    EXPECT_LT(Incidence(at_angle(critical - 0.1).z, 1 / 1.5f).reflectance, 0.9f);
    for (const double degrees : {critical + 0.1, 60.0, 89.9}) {
        const BoundarySample sample = smooth(degrees, 1 / 1.5f, 0.999999f);
        EXPECT_FALSE(sample.through) << degrees;
        EXPECT_NEAR(sample.direction.x, -at_angle(degrees).x, 1e-6);
        EXPECT_NEAR(sample.direction.z, at_angle(degrees).z, 1e-6);
    }
}

TEST(Boundary, IsNotThereForAnIndexOfOne) {
    for (const double degrees : {0.0, 45.0, 89.0, 89.99}) {
        for (const float roughness : {0.0f, 0.5f}) {
            const BoundarySample sample =
                sample_boundary(at_angle(degrees), kUp, kUp, 1, roughness, 0, vec2(0.3f));
            EXPECT_TRUE(sample.through);
            EXPECT_EQ(sample.weight, 1);
            EXPECT_LT(glm::distance(sample.direction, -at_angle(degrees)), 1e-6f);
        }
    }
}

// A shading normal that would send light into the wrong side is left for the triangle's own.
TEST(Boundary, StaysOnItsSideWhateverTheShadingNormal) {
    for (int i = 0; i < 4000; ++i) {
        const RandomNumbers random(3, 0, 2 * static_cast<std::uint32_t>(i));
        const vec3 v = cosine_direction(kUp, random.pair(0));
        const vec3 n = cosine_direction(kUp, random.pair(1));
        const float eta = i % 2 == 0 ? 1.5f : 1 / 1.5f;
        const BoundarySample sample = sample_boundary(v, n, kUp, eta, 0, random.pair(2).x, vec2(0));
        ASSERT_EQ(sample.weight, 1);
        ASSERT_EQ(sample.direction.z < 0, sample.through);
    }
}

// Rough boundaries: no light is made; what is lost is what a facet would have passed to another. The rougher,
// the more, and the smoothest is as good as smooth.
TEST(Boundary, RoughOnesGainNoEnergy) {
    constexpr int kCount = 1 << 14;
    for (const float eta : {1.5f, 1 / 1.5f, 3.0f}) {
        for (const double degrees : {0.0, 30.0, 60.0, 80.0}) {
            double before = 1;
            for (const float roughness : {0.05f, 0.3f, 0.6f, 1.0f}) {
                double sum = 0, through = 0;
                for (int i = 0; i < kCount; ++i) {
                    const RandomNumbers random(7, 0, 2 * static_cast<std::uint32_t>(i));
                    const BoundarySample sample = sample_boundary(at_angle(degrees), kUp, kUp, eta, roughness,
                                                                  random.pair(0).x, random.pair(1));
                    ASSERT_LE(sample.weight, 1);
                    sum += static_cast<double>(sample.weight) / kCount;
                    through += sample.through ? 1.0 / kCount : 0;
                }
                EXPECT_LE(sum, before + 2e-3) << roughness << " at " << degrees << ", " << eta;
                EXPECT_GT(sum, roughness < 0.1f   ? 0.99
                               : roughness < 0.5f ? 0.85
                                                  : 0.3)
                    << roughness << " at " << degrees << ", " << eta;
                if (roughness < 0.1f) {
                    const Incidence at(at_angle(degrees).z, eta);
                    EXPECT_NEAR(through, 1 - at.reflectance, 0.02) << degrees << ", " << eta;
                }
                before = sum;
            }
        }
    }
}

}  // namespace dielectric_test
}  // namespace lanthorn::reference::test

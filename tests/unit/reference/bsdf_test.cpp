// Every BSDF by integration: energy, reciprocity, and that directions are drawn with the density that is
// said.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "gi_module/reference/bsdf.h"
#include "gi_module/reference/random.h"
#include "gi_module/reference/sampling.h"
#include "lanthorn/scene/diffuse_reflectance.h"

namespace lanthorn::reference::test {
namespace {

const vec3 kUp(0, 0, 1);

vec3 at_angle(float degrees) {
    const float angle = glm::radians(degrees);
    return {std::sin(angle), 0, std::cos(angle)};
}

SurfaceMaterial surface(float base, float metallic, float roughness, float f0, float transmission = 0) {
    SurfaceMaterial m;
    m.base_colour = vec3(base);
    m.metallic = metallic;
    m.roughness = roughness;
    m.f0 = f0;
    m.transmission = transmission;
    return m;
}

// Share of the light towards `v` that is scattered at all, by drawing directions.
double albedo(const Bsdf& bsdf, int count = 1 << 15) {
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        const RandomNumbers random(7, 0, 2 * static_cast<std::uint32_t>(i));
        const vec3 l = bsdf.sample(random.pair(0).x, random.pair(1));
        const float density = bsdf.density(l);
        if (density > 0) {
            sum += static_cast<double>(bsdf.evaluate(l).x / density);
        }
    }
    return sum / count;
}

// The same, and the integral of the density, by even steps over the whole sphere, finest about the pole.
struct Integrals {
    double albedo = 0;
    double density = 0;
};
Integrals integrate(const Bsdf& bsdf) {
    constexpr int kRings = 1500, kSectors = 720;
    Integrals result;
    for (int i = 0; i < kRings; ++i) {
        const double theta = kPi * (i + 0.5) / kRings;
        const double weight = std::sin(theta) * (kPi / kRings) * (2.0 * kPi / kSectors);
        for (int k = 0; k < kSectors; ++k) {
            const double phi = 2.0 * kPi * (k + 0.5) / kSectors;
            const vec3 l(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
            result.albedo += weight * static_cast<double>(bsdf.evaluate(l).x);
            result.density += weight * static_cast<double>(bsdf.density(l));
        }
    }
    return result;
}

TEST(Bsdf, LambertReflectsItsBaseColour) {
    for (const float angle : {0.0f, 45.0f, 85.0f}) {
        const Bsdf bsdf(surface(0.7f, 0, 0.5f, 0), kUp, kUp, at_angle(angle), false);
        EXPECT_NEAR(albedo(bsdf), 0.7, 1e-3);
    }
}

TEST(Bsdf, MetalsGainNoEnergy) {
    for (const float roughness : {0.0f, 0.1f, 0.3f, 0.6f, 1.0f}) {
        for (const float angle : {0.0f, 30.0f, 60.0f, 80.0f, 89.0f}) {
            const Bsdf bsdf(surface(1, 1, roughness, 0.04f), kUp, kUp, at_angle(angle), false);
            const double reflected = albedo(bsdf);
            EXPECT_LE(reflected, 1 + 2e-3) << roughness << " at " << angle;
            EXPECT_GT(reflected, roughness < 0.2f ? 0.9 : 0.3) << roughness << " at " << angle;
        }
    }
}

// The diffuse part keeps what Fresnel leaves on the way in and on the way out.
TEST(Bsdf, DielectricsGainNoEnergy) {
    for (const float roughness : {0.0f, 0.3f, 0.6f, 1.0f}) {
        double mean = 0, most = 0;
        constexpr int kAngles = 32;
        for (int i = 0; i < kAngles; ++i) {
            const float cosine = (static_cast<float>(i) + 0.5f) / kAngles;
            const vec3 v(std::sqrt(1 - cosine * cosine), 0, cosine);
            const double a = albedo(Bsdf(surface(1, 0, roughness, 0.04f), kUp, kUp, v, false), 1 << 12);
            mean += 2 * a * static_cast<double>(cosine) / kAngles;
            most = std::max(most, a);
        }
        std::printf("white dielectric, roughness %.1f: hemispherical albedo %.4f, largest directional %.4f\n",
                    static_cast<double>(roughness), mean, most);
        EXPECT_LE(most, 1 + 2e-3) << roughness;
        EXPECT_GT(mean, 0.8) << roughness;
    }
}

// What techniques and diffuse transport bounce on is the BSDF's own mean over even light.
TEST(Bsdf, ReflectsOfEvenLightWhatMaterialReflectanceSays) {
    double farthest = 0;
    for (const float metallic : {0.0f, 1.0f}) {
        for (const float roughness : {0.0f, 0.3f, 0.45f, 0.6f, 0.8f, 1.0f}) {
            for (const float ior : {1.0f, 1.33f, 1.5f, 2.4f}) {
                for (const float base : {0.1f, 0.9f}) {
                    Material m;
                    m.base_colour = vec4(vec3(base), 1);
                    m.metallic = metallic;
                    m.roughness = roughness;
                    m.ior = ior;
                    const MaterialReflectance reflects = MaterialReflectance::of(m);
                    const float said = base * base_reflectance(metallic, 0, roughness, reflects.transmittance,
                                                               reflects.evenly) +
                                       reflects.boundary;
                    if (is_mirror(m)) {
                        EXPECT_EQ(said, 0) << "caustic photons follow it";
                        continue;
                    }
                    const float f0 = (ior - 1) * (ior - 1) / ((ior + 1) * (ior + 1));
                    double mean = 0;
                    constexpr int kAngles = 32;
                    for (int i = 0; i < kAngles; ++i) {
                        const float cosine = (static_cast<float>(i) + 0.5f) / kAngles;
                        const vec3 v(std::sqrt(1 - cosine * cosine), 0, cosine);
                        const Bsdf bsdf(surface(base, metallic, roughness, f0), kUp, kUp, v, false);
                        mean += 2 * albedo(bsdf, 1 << 11) * static_cast<double>(cosine) / kAngles;
                    }
                    // A metal's edge is taken to be of its base colour, too.
                    const double grazing = metallic > 0 ? 0.03 * (1 - static_cast<double>(base)) : 0;
                    EXPECT_NEAR(static_cast<double>(said), mean, 0.006 + grazing)
                        << "metallic " << metallic << ", roughness " << roughness << ", ior " << ior
                        << ", base " << base;
                    farthest = std::max(farthest, std::abs(static_cast<double>(said) - mean));
                }
            }
        }
    }
    std::printf("reflected of even light: at most %.4f from the BSDF's mean\n", farthest);
}

TEST(Bsdf, ThinTransmissionGainsNoEnergy) {
    for (const float roughness : {0.1f, 0.5f, 1.0f}) {
        for (const float angle : {0.0f, 45.0f, 80.0f}) {
            const Bsdf rough(surface(1, 0, roughness, 0.04f, 1), kUp, kUp, at_angle(angle), false);
            EXPECT_LE(albedo(rough), 1 + 2e-3) << roughness << " at " << angle;
        }
    }
    const Bsdf smooth(surface(1, 0, 0, 0.04f, 1), kUp, kUp, at_angle(0), true);
    EXPECT_NEAR(albedo(smooth) + static_cast<double>(smooth.straight_through().x), 1, 2e-3);
}

class EveryLobe : public testing::TestWithParam<SurfaceMaterial> {};

TEST_P(EveryLobe, IsDrawnFromWithTheDensityThatIsSaid) {
    for (const float angle : {5.0f, 40.0f, 70.0f}) {
        const Bsdf bsdf(GetParam(), kUp, kUp, at_angle(angle), false);
        const Integrals exact = integrate(bsdf);
        EXPECT_LE(exact.density, 1.002) << "not more than certain, at " << angle;
        EXPECT_GE(exact.density, 0.45) << "the rest goes below the horizon, at " << angle;
        EXPECT_NEAR(albedo(bsdf) / exact.albedo, 1, 0.01) << "at " << angle;
    }
}

TEST_P(EveryLobe, IsReciprocal) {
    const vec3 a = at_angle(20), b = glm::normalize(vec3(-0.5f, 0.6f, 0.4f));
    const Bsdf from_a(GetParam(), kUp, kUp, a, false), from_b(GetParam(), kUp, kUp, b, false);
    EXPECT_NEAR(from_a.evaluate(b).x / b.z, from_b.evaluate(a).x / a.z, 1e-4f);
}

INSTANTIATE_TEST_SUITE_P(Materials, EveryLobe,
                         testing::Values(surface(0.8f, 0, 1, 0), surface(0.8f, 0, 0.4f, 0.04f),
                                         surface(0.8f, 0, 0.25f, 0.16f), surface(0.9f, 1, 0.3f, 0.04f),
                                         surface(0.9f, 1, 1, 0.04f), surface(0.9f, 0.5f, 0.5f, 0.04f),
                                         surface(0.9f, 0, 0.5f, 0.04f, 0.7f)));

}  // namespace
}  // namespace lanthorn::reference::test

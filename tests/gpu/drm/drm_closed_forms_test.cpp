// `drm` against light that is known on paper, its approximations' own errors included.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/gpu/drm/drm_bench.h"
#include "tests/support/closed_forms.h"

namespace lanthorn::gi::test {
namespace drm_closed_forms_test {

using support::kPiD;

constexpr ivec2 kSize(64);
constexpr float kAlbedo = 0.6f;
constexpr double kWhole = 100 * 0.6;  // kSphereLux, reflected once: lux inside of closed_sphere(kAlbedo)

// Inside of a sphere cos theta cos theta' / r^2 is the same between any two points, so that eq. 10 becomes
// the mean of r^2 / (A + r^2) over the sphere, of which r^2 is evenly spread over 0..4 R^2: 1 - a ln(1 + 1 /
// a) with a = A / (4 R^2) = pi / samples. With eq. 15 and eq. 11 cos theta = r / (2 R) alone is left, whose
// mean is 2 / 3, and with eq. 13 1 / (4 R^2), which makes it exact for any number of samples; the diagonal of
// the sphere's box is 2 sqrt(3) R.
double sphere_share(SolidAngle kind, double samples) {
    const double a = (kind == SolidAngle::disc ? 1 : kPiD) / samples;
    switch (kind) {
        case SolidAngle::eq_14:
        case SolidAngle::disc:
            return 1 - a * std::log(1 + 1 / a);
        case SolidAngle::eq_15:
            return 4.0 / 12 * 2 / 3;
        case SolidAngle::eq_11:
            return 2 * 2.0 / 3;
        case SolidAngle::eq_13:
            return 1;
    }
    return 0;
}

class SphereBySamples : public ::testing::TestWithParam<std::tuple<SolidAngle, int>> {};

TEST_P(SphereBySamples, IsWhatTheEquationSays) {
    const auto [kind, side] = GetParam();
    DrmBench bench;
    bench.drm().solid_angle = kind;
    bench.drm().samples = side;
    bench.drm().mips = DrmMips::none;  // samples on the sphere itself
    const double share = sphere_share(kind, side * side);
    const Deviation a = deviation_of(bench.frame(closed_sphere(kAlbedo), kSize), share * kWhole);
    std::printf(
        "drm, closed sphere, M = %d, solid angle %d: %.4f of the light by the equation; mean %.4f of that\n",
        side, static_cast<int>(kind), share, a.mean);
    EXPECT_NEAR(a.mean, 1, side >= 5 ? 0.02 : 0.2);
    EXPECT_EQ(bench.now().samples, side * side);
}

INSTANTIATE_TEST_SUITE_P(All, SphereBySamples,
                         ::testing::Combine(::testing::Values(SolidAngle::eq_14, SolidAngle::disc,
                                                              SolidAngle::eq_15, SolidAngle::eq_11),
                                            ::testing::Values(2, 5, 8, 16)));

// Where the number of samples does not matter, few are as good as many, until some come so near to what they
// light that the triangles of the sphere are seen for what they are.
INSTANTIATE_TEST_SUITE_P(Eq13, SphereBySamples,
                         ::testing::Combine(::testing::Values(SolidAngle::eq_13), ::testing::Values(2, 5)));

// More samples are smaller: of what eq. 14 leaves out less is left out each time, from M = 1 to 16.
TEST(DrmClosedForms, EverySampleMoreBringsTheSphereNearerToItsLight) {
    DrmBench bench;
    const FrameScene scene = closed_sphere(kAlbedo);
    FrameScene held = scene;
    double last = 0;
    for (int side = 1; side <= 16; ++side) {
        bench.drm().samples = side;
        const double mean = deviation_of(bench.frame(held, kSize), kWhole).mean;
        EXPECT_GT(mean, last) << side;
        EXPECT_LT(mean, 1.005) << side;
        EXPECT_EQ(bench.now().samples, side * side);
        last = mean;
        hold_still(held);
    }
    EXPECT_GT(last, 0.95);
}

// What all samples send on together is what the light sends out, times the walls' albedo.
double sent_lumen(DrmBench& bench) {
    double sum = 0;
    for (const RadianceSample& s : bench.at_work().map().read()) {
        sum += static_cast<double>(s.sent.y) * kPiD;
    }
    return sum;
}

FrameScene closed_room(std::vector<LightInstance> lights, std::vector<Mesh> more = {},
                       std::vector<Material> materials = {}) {
    std::vector<Mesh> meshes{box(vec3(-2, 0, -1.5f), vec3(2, 3, 1.5f), true, 0)};
    meshes.insert(meshes.end(), more.begin(), more.end());
    materials.insert(materials.begin(), lambertian(vec3(kAlbedo)));
    return scene_of(std::move(meshes), std::move(materials), std::move(lights), vec3(1.5f, 1.5f, 1.2f),
                    vec3(0, 1, 0));
}

TEST(DrmClosedForms, NoLumenIsLostOnTheWayToTheSamples) {
    const float candela = 70;
    const float inner = 0.4f, outer = 0.9f, wide = 1.4f;
    // KHR_lights_punctual's square of a ramp in the cosine has a third of the light between the cones.
    const auto cone = [&](float in, float out) {
        const double a = std::cos(static_cast<double>(in)), b = std::cos(static_cast<double>(out));
        return 2 * kPiD * 70 * (1 - a + (a - b) / 3);
    };
    const vec3 at(0.3f, 1.2f, -0.2f), towards(0.2f, -1, 0.1f);
    const Mesh panel = quad({-0.2f, 2.8f, -0.1f}, {0.4f, 0, 0}, {0, 0, 0.2f}, 1);  // 0.08 m^2, faces down
    struct Case {
        const char* name;
        FrameScene scene;
        double lumen;
    };
    const Case cases[] = {
        {"point", closed_room({point_light(at, candela)}), 4 * kPiD * 70},
        {"spot", closed_room({support::spot_light(at, towards, candela, inner, outer)}), cone(inner, outer)},
        {"wide spot", closed_room({support::spot_light(at, towards, candela, inner, wide)}),
         cone(inner, wide)},
        {"panel", closed_room({}, {panel}, {support::lamp(vec3(500))}), kPiD * 500 * 0.08}};
    for (const Case& c : cases) {
        for (const int side : {1, 3, 16}) {
            DrmBench bench;
            bench.drm().samples = side;
            bench.drm().texels = 64;
            bench.frame(c.scene, kSize);
            const double share = sent_lumen(bench) / (c.lumen * static_cast<double>(kAlbedo));
            std::printf("drm, %s, M = %d: %.4f of the lumen that it sends\n", c.name, side, share);
            EXPECT_NEAR(share, 1, 0.015) << c.name << " " << side;
        }
    }
}

// The areas of a sphere's samples are the sphere's.
TEST(DrmClosedForms, TheSamplesCoverWhatIsLit) {
    DrmBench bench;
    bench.drm().samples = 6;
    bench.drm().texels = 96;
    bench.drm().solid_angle = SolidAngle::eq_14;
    bench.frame(closed_sphere(kAlbedo, 3), kSize);
    double area = 0;
    for (const RadianceSample& s : bench.at_work().map().read()) {
        area += static_cast<double>(s.area);
        EXPECT_NEAR(glm::length(s.normal), 1, 1e-4f);
        EXPECT_GT(s.across, 0);
        EXPECT_LE(s.across, s.area * 1.0001f);
    }
    EXPECT_NEAR(area / (4 * kPiD * 9), 1, 0.01);
}

// A flat part and one that rises by 60 degrees, of which a sun straight above lights three quarters and one:
// the mean radiance of both, on the place and the area in the middle, which is flat, has lost an eighth of
// the light; the mean light has not.
TEST(DrmClosedForms, TheMeanRadianceAloneLosesLight) {
    const float rise = 0.5f * std::sqrt(3.0f);
    FrameScene scene = scene_of(
        {quad({-1, 0, 1}, {1.5f, 0, 0}, {0, 0, -2}, 0), quad({0.5f, 0, 1}, {0.5f, rise, 0}, {0, 0, -2}, 0)},
        {lambertian(vec3(1))}, {support::directional_light(vec3(0, -1, 0), 100)}, vec3(0, 3, 0.1f), vec3(0));
    const double lumen = 4 * 100;
    const auto sent = [&](DrmMips mips) {
        DrmBench bench;
        bench.drm().samples = 1;
        bench.drm().mips = mips;
        bench.drm().solid_angle = SolidAngle::eq_14;
        bench.frame(scene, kSize);
        return sent_lumen(bench) / lumen;
    };
    EXPECT_NEAR(sent(DrmMips::radiance), 0.875, 0.01);
    EXPECT_NEAR(sent(DrmMips::light), 1, 0.01);
    EXPECT_NEAR(sent(DrmMips::all), 1, 0.01);
}

// From a plate that the sun lights to one that faces it: E = rho E0 F, F by Lambert's sum over the edges.
TEST(DrmClosedForms, ParallelPlates) {
    const double albedo = 0.8, lux = 1000;
    const float apart = 1;
    FrameScene scene = scene_of({quad({-0.5f, 0, 0.5f}, {1, 0, 0}, {0, 0, -1}, 0),
                                 quad({-0.5f, apart, -0.5f}, {1, 0, 0}, {0, 0, 1}, 1)},
                                {lambertian(vec3(static_cast<float>(albedo))), lambertian(vec3(0))},
                                {support::directional_light(vec3(1.2f, -1, 0), static_cast<float>(lux))},
                                vec3(0, 1, 0), vec3(0));
    look_closely(scene, vec3(0, 0.5f * apart, 0), vec3(0, apart, 0), 0.5f);
    const double lit = lux / std::hypot(1.2, 1.0);
    const std::array<dvec3, 4> corners{dvec3(-0.5, 0, 0.5), dvec3(0.5, 0, 0.5), dvec3(0.5, 0, -0.5),
                                       dvec3(-0.5, 0, -0.5)};
    const dmat4 to_world = glm::inverse(dmat4(scene.camera.view));
    std::vector<double> expected;
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
            const dvec3 p(to_world * dvec4((x + 0.5) / kSize.x - 0.5, 0.5 - (y + 0.5) / kSize.y, -0.5, 1));
            expected.push_back(albedo * lit * support::polygon_factor(corners, p, dvec3(0, -1, 0)));
        }
    }
    for (const SolidAngle kind : {SolidAngle::disc, SolidAngle::eq_14}) {
        DrmBench bench;
        bench.drm().samples = 16;
        bench.drm().texels = 128;
        bench.drm().solid_angle = kind;
        const Deviation d = deviation_of(bench.frame(scene, kSize), expected);
        std::printf("drm, parallel plates, solid angle %d: mean %.4f, relRMSE %.4f\n", static_cast<int>(kind),
                    d.mean, d.rel_rmse);
        EXPECT_NEAR(d.mean, 1, 0.02);
        EXPECT_LT(d.rel_rmse, 0.03);
    }
}

}  // namespace drm_closed_forms_test
}  // namespace lanthorn::gi::test

// One reflection off an evenly lit square plate: at a point of a second plate E = rho E0 F, F the
// configuration factor of the square (Lambert's sum over its edges); over the whole plate the mean of F is
// C-11 for parallel plates and C-14 for plates at right angles (Howell, "A Catalog of Radiation Heat Transfer
// Configuration Factors").
//
// A twentieth to a tenth of the photons that the sun sends meets the second plate. Its mean is asked of many
// photons and full-size splats; its noise of the defaults.
#include <gtest/gtest.h>

#include "lanthorn/emc/emc_settings.h"
#include "tests/gpu/gi/test_scene.h"
#include "tests/support/closed_forms.h"

namespace lanthorn::gi::test {
namespace {

constexpr double kAlbedo = 0.8;
constexpr float kLux = 1000;
constexpr int kSide = 192;

// The lit plate: 1 m x 1 m about the origin, facing up.
Mesh lit_plate() {
    return quad({-0.5f, 0, 0.5f}, {1, 0, 0}, {0, 0, -1}, 0);
}

// A black plate that receives, and how it is looked at.
struct Receiver {
    Mesh mesh;
    vec3 middle;
    vec3 normal;
    vec3 sun;     // direction of the light, that neither plate's shadow touches
    float reach;  // metres in front of it from which the camera looks
};

struct PlateDeviation {
    Deviation whole;
    double middle = 0;  // mean / expected of the plate's middle half
    double factor = 0;  // mean of the expected factors
};

PlateDeviation deviation_with(const Receiver& receiver, const GiSettings& settings) {
    FrameScene scene = scene_of({lit_plate(), receiver.mesh},
                                {lambertian(vec3(static_cast<float>(kAlbedo))), lambertian(vec3(0))},
                                {support::directional_light(receiver.sun, kLux)}, vec3(0, 1, 0), vec3(0));
    look_closely(scene, receiver.middle + receiver.reach * receiver.normal, receiver.middle, 0.5f);
    Bench bench;
    bench.settings = settings;
    bench.settings.edit<EmcSettings>().final_stage = EmcFinal::splat;
    bench.settings.bounces = 1;
    const ImageF image = bench.frame(scene, ivec2(kSide));

    const double lit = static_cast<double>(kLux * -glm::normalize(receiver.sun).y);
    const std::array<dvec3, 4> corners{dvec3(-0.5, 0, 0.5), dvec3(0.5, 0, 0.5), dvec3(0.5, 0, -0.5),
                                       dvec3(-0.5, 0, -0.5)};
    const dmat4 to_world = glm::inverse(dmat4(scene.camera.view));
    std::vector<double> expected;
    double middle_got = 0;
    double middle_expected = 0;
    double factors = 0;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const double u = (x + 0.5) / kSide - 0.5;
            const double v = 0.5 - (y + 0.5) / kSide;
            const dvec3 point(to_world * dvec4(u, v, -static_cast<double>(receiver.reach), 1));
            const double factor = support::polygon_factor(corners, point, dvec3(receiver.normal));
            factors += factor / (kSide * kSide);
            expected.push_back(kAlbedo * lit * factor);
            if (std::max(std::abs(u), std::abs(v)) < 0.25) {
                middle_got += static_cast<double>(image.pixels[3 * (expected.size() - 1)]);
                middle_expected += expected.back();
            }
        }
    }
    return {deviation_of(image, expected), middle_got / middle_expected, factors};
}

Receiver parallel(float distance) {
    return {quad({-0.5f, distance, -0.5f}, {1, 0, 0}, {0, 0, 1}, 1), vec3(0, distance, 0), vec3(0, -1, 0),
            vec3(1.2f / distance, -1, 0), 0.5f * distance};
}

Receiver perpendicular() {
    return {quad({-0.5f, 0, -0.5f}, {1, 0, 0}, {0, 1, 0}, 1), vec3(0, 0.5f, -0.5f), vec3(0, 0, 1),
            vec3(0, -1, -1), 0.5f};
}

// Where the expected factors' mean is not the catalogue's, the test itself is wrong.
void check(const char* name, const Receiver& receiver, double catalogue, double mean_tolerance,
           double noise_limit) {
    GiSettings settings;
    const PlateDeviation ordinary = deviation_with(receiver, settings);
    ASSERT_NEAR(ordinary.factor / catalogue, 1, 1e-3);
    settings.photons = 200000;
    settings.edit<EmcSettings>().splat_base = SplatBase::full;
    const PlateDeviation many = deviation_with(receiver, settings);
    std::printf("%s: relRMSE %.4f; of 200000 photons, mean %.4f, of the middle %.4f\n", name,
                ordinary.whole.rel_rmse, many.whole.mean, many.middle);
    EXPECT_LT(ordinary.whole.rel_rmse, noise_limit) << name;
    EXPECT_NEAR(many.whole.mean, 1, mean_tolerance) << name;
    EXPECT_NEAR(many.middle, 1, 2 * mean_tolerance) << name;
}

TEST(FormFactor, ParallelPlates) {
    check("0.25 m apart", parallel(0.25f), support::parallel_plates(1, 1, 0.25), 0.02, 0.33);
    check("0.5 m apart", parallel(0.5f), support::parallel_plates(1, 1, 0.5), 0.015, 0.22);
    check("1 m apart", parallel(1), support::parallel_plates(1, 1, 1), 0.015, 0.19);
    check("2 m apart", parallel(2), support::parallel_plates(1, 1, 2), 0.035, 0.45);
}

TEST(FormFactor, PerpendicularPlates) {
    check("at right angles", perpendicular(), support::perpendicular_plates(1, 1, 1), 0.03, 0.26);
}

}  // namespace
}  // namespace lanthorn::gi::test

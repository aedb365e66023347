// Form factors between two plates: the mean irradiance of one that the other, glowing, gives is pi L F
// (Howell, "A Catalog of Radiation Heat Transfer Configuration Factors", C-11 and C-14).
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/reference/scenes.h"

namespace lanthorn::reference::test {
namespace {

constexpr double kPiD = 3.14159265358979323846;
constexpr float kNits = 100;

// From plate 0 to the lamp, seen by a camera that takes in plate 0 exactly; the lamp's back is not seen.
double form_factor(const Mesh& plate, const Mesh& lamp_mesh, const vec3& eye, const vec3& middle,
                   float half) {
    FrameScene scene =
        scene_of({plate, lamp_mesh}, {lambertian(vec3(0.5f)), lamp(vec3(kNits))}, {}, eye, middle);
    look_closely(scene, eye, middle, half);
    PathSettings settings;
    settings.antialias = true;  // the mean over the plate, not over pixel centres
    settings.spp = 128;
    return mean_of(scene, settings, PathAov::direct, ivec2(16)) / (0.5 * kNits);
}

// C-11: equal, opposite, a x b at distance c.
double parallel_plates(double a, double b, double c) {
    const double x = a / c, y = b / c, x2 = 1 + x * x, y2 = 1 + y * y;
    return 2 / (kPiD * x * y) *
           (0.5 * std::log(x2 * y2 / (1 + x * x + y * y)) + x * std::sqrt(y2) * std::atan(x / std::sqrt(y2)) +
            y * std::sqrt(x2) * std::atan(y / std::sqrt(x2)) - x * std::atan(x) - y * std::atan(y));
}

// C-14: at right angles with a common edge of length l; from the plate of width w to the one of height h.
double perpendicular_plates(double h, double w, double l) {
    const double H = h / l, W = w / l, h2 = H * H, w2 = W * W, s = h2 + w2;
    const double logs = std::log((1 + w2) * (1 + h2) / (1 + s)) +
                        w2 * std::log(w2 * (1 + s) / ((1 + w2) * s)) +
                        h2 * std::log(h2 * (1 + s) / ((1 + h2) * s));
    return (W * std::atan(1 / W) + H * std::atan(1 / H) - std::sqrt(s) * std::atan(1 / std::sqrt(s)) +
            0.25 * logs) /
           (kPiD * W);
}

TEST(FormFactor, ParallelPlates) {
    for (const float distance : {0.1f, 0.5f, 1.0f, 3.0f}) {
        const Mesh plate = quad({-0.5f, 0, 0.5f}, {1, 0, 0}, {0, 0, -1}, 0);
        const Mesh above = quad({-0.5f, distance, -0.5f}, {1, 0, 0}, {0, 0, 1}, 1);
        const double expected = parallel_plates(1, 1, static_cast<double>(distance));
        EXPECT_NEAR(form_factor(plate, above, vec3(0, 5, 0), vec3(0), 0.5f) / expected, 1, 5e-3) << distance;
    }
}

TEST(FormFactor, UnitCubeFacesAsTheTextbooksHaveThem) {
    EXPECT_NEAR(parallel_plates(1, 1, 1), 0.1998, 1e-4);  // Incropera et al. 2007, table 13.2 and figure 13.4
    EXPECT_NEAR(perpendicular_plates(1, 1, 1), 0.2000, 1e-4);
}

TEST(FormFactor, PerpendicularPlatesWithACommonEdge) {
    for (const float height : {0.25f, 1.0f, 4.0f}) {
        const Mesh plate = quad({-0.5f, 0, 0.5f}, {1, 0, 0}, {0, 0, -1}, 0);
        const Mesh wall = quad({-0.5f, 0, -0.5f}, {1, 0, 0}, {0, height, 0}, 1);
        const double expected = perpendicular_plates(static_cast<double>(height), 1, 1);
        EXPECT_NEAR(form_factor(plate, wall, vec3(0, 5, 0), vec3(0), 0.5f) / expected, 1, 5e-3) << height;
    }
}

}  // namespace
}  // namespace lanthorn::reference::test

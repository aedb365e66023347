// Form factors between two plates: the mean irradiance of one that the other, glowing, gives is pi L F
// (Howell, "A Catalog of Radiation Heat Transfer Configuration Factors", C-11 and C-14).
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/closed_forms.h"
#include "tests/unit/reference/scenes.h"

namespace lanthorn::reference::test {
namespace {

using support::parallel_plates;
using support::perpendicular_plates;

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

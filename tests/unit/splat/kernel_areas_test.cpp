// The density of photons that lie evenly on a plane, as each kernel estimates it: right everywhere with the
// correction of boundaries, short of it near edges without (Lavignotte and Paulin 2003, sec. 4.1).
#include "gi_module/techniques/splat/kernel_areas.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gi_module/reference/random.h"
#include "gi_module/techniques/splat/splat_lists.h"
#include "tests/support/closed_forms.h"
#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace lanthorn::gi::test {
namespace {

using support::kPiD;

constexpr ivec2 kSize(40);
constexpr std::size_t kPhotons = 200'000;
constexpr float kH = 0.25f;

// A floor 2 x 2, pixels evenly over it, photons too.
struct Plane {
    reference::TileWorkers workers{2};
    SplatSurfaces surfaces;
    PictureSurfaces picture;
    RecordRun run;

    Plane() {
        const FrameScene scene =
            support::scene_of({support::quad(vec3(-1, 0, -1), vec3(0, 0, 2), vec3(2, 0, 0), 0)},
                              {support::lambertian(vec3(0.5f))}, {}, vec3(0, 3, 0), vec3(0));
        surfaces.follow(scene, workers);
        std::vector<PixelSurface> pixels;
        for (int y = 0; y < kSize.y; ++y) {
            for (int x = 0; x < kSize.x; ++x) {
                const vec2 p = (vec2(x, y) + 0.5f) / vec2(kSize) * 2.0f - 1.0f;
                pixels.push_back({vec3(p.x, 0, p.y), 0});
            }
        }
        picture.set(kSize, pixels);
        for (std::uint32_t i = 0; i < kPhotons; ++i) {
            const vec2 u = reference::RandomNumbers(1, 0, 2 * i).pair(0);
            run.records.push_back({vec3(2 * u.x - 1, 0, 2 * u.y - 1), PhotonRecord::pack({1, 1, 1}, 0)});
        }
        arrange(run);
    }

    // Photons per square metre over those that there are, by pixel; through the tiles' lists.
    std::vector<double> density(PhotonKernel kernel, bool boundaries) {
        const std::vector<float> h(2, kH);
        const SplatLists lists = splat_lists(run.blocks, picture, h, {}, workers);
        const std::vector<float> areas =
            inverse_kernel_areas(picture, surfaces, h, kernel, boundaries, {}, workers);
        std::vector<double> result;
        for (int y = 0; y < kSize.y; ++y) {
            for (int x = 0; x < kSize.x; ++x) {
                const auto i = static_cast<std::size_t>(y * kSize.x + x);
                const auto tile = static_cast<std::size_t>(y / 8 * picture.tiles().x + x / 8);
                double sum = 0;
                for (std::uint32_t e = lists.firsts[tile]; e < lists.firsts[tile + 1]; ++e) {
                    const SplatEntry& entry = lists.entries[e];
                    for (std::uint32_t p = entry.first; p < entry.first + entry.count; ++p) {
                        const vec3 d = run.records[p].position - picture.pixels()[i].position;
                        const auto d2 = static_cast<double>(glm::dot(d, d) / entry.square);
                        sum += d2 < 1 ? (kernel == PhotonKernel::constant ? 1 : 1 - d2) : 0;
                    }
                }
                result.push_back(sum * static_cast<double>(areas[i]) * 4 / kPhotons);
            }
        }
        return result;
    }
};

class Density : public testing::TestWithParam<PhotonKernel> {};

TEST_P(Density, IsRightEverywhereWithTheCorrection) {
    Plane plane;
    for (const double d : plane.density(GetParam(), true)) {
        EXPECT_NEAR(d, 1, 0.03);
    }
}

// At a distance s from an edge a constant kernel lacks the segment beyond it, at a corner two of them.
TEST_P(Density, LacksWhatLiesBeyondTheEdgeWithoutIt) {
    Plane plane;
    const std::vector<double> got = plane.density(GetParam(), false);
    const double s = 1.0 / kSize.x / static_cast<double>(kH);  // of the first pixel, in h
    double expected = 0;
    constexpr int kSteps = 2000;
    double whole = 0, corner = 0;
    for (int i = 0; i < kSteps; ++i) {
        for (int k = 0; k < kSteps; ++k) {
            const double x = 2 * (i + 0.5) / kSteps - 1, y = 2 * (k + 0.5) / kSteps - 1, d2 = x * x + y * y;
            const double weight = d2 < 1 ? (GetParam() == PhotonKernel::constant ? 1 : 1 - d2) : 0;
            whole += weight;
            expected += x > -s ? weight : 0;
            corner += x > -s && y > -s ? weight : 0;
        }
    }
    EXPECT_NEAR(got[20 * kSize.x + 20], 1, 0.02);
    EXPECT_NEAR(got[20 * kSize.x], expected / whole, 0.02);
    EXPECT_NEAR(got[0], corner / whole, 0.02);
    EXPECT_LT(got[0], 0.4);
}

// A sum over a surface of what all photons are seen as there is how many there are: nothing is lost at edges.
TEST_P(Density, EnergyIsKeptToTheCorrectionsOwnBias) {
    Plane plane;
    double sum = 0;
    for (const double d : plane.density(GetParam(), true)) {
        sum += d;
    }
    EXPECT_NEAR(sum / (kSize.x * kSize.y), 1, 3e-3);
}

INSTANTIATE_TEST_SUITE_P(Kernels, Density,
                         testing::Values(PhotonKernel::constant, PhotonKernel::epanechnikov));

TEST(Bandwidths, AreTheSquareRootOfAPhotonsAreaTimesC) {
    Plane plane;
    const std::vector<std::uint64_t> photons{10'000, 0};
    const std::vector<float> h = bandwidths(plane.surfaces, photons, 20);
    EXPECT_NEAR(h[0], 20 * std::sqrt(4.0 / 10'000), 1e-5);
    EXPECT_EQ(h[1], 0);
    // Of few photons each lights all of its surface, and no splat is larger than that.
    const std::vector<std::uint64_t> one{1, 1};
    EXPECT_NEAR(bandwidths(plane.surfaces, one, 20)[0], 2 * std::sqrt(2.0), 0.01);
}

TEST(KernelAreas, AreZeroWhereThereIsNoKernelAndNoSurface) {
    Plane plane;
    const std::vector<float> none(2, 0);
    for (const float a : inverse_kernel_areas(plane.picture, plane.surfaces, none, PhotonKernel::constant,
                                              true, {}, plane.workers)) {
        EXPECT_EQ(a, 0);
    }
    plane.picture.set(ivec2(3, 2), std::vector<PixelSurface>(6));
    const std::vector<float> some(2, 1);
    for (const float a : inverse_kernel_areas(plane.picture, plane.surfaces, some, PhotonKernel::constant,
                                              true, {}, plane.workers)) {
        EXPECT_EQ(a, 0);
    }
    EXPECT_TRUE(plane.picture.patches().empty());
}

}  // namespace
}  // namespace lanthorn::gi::test

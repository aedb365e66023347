// Estimates where the density of the photons is known.
#include "gi_module/techniques/vertex-map/radiance_estimate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "gi_module/techniques/vertex-map/kept_tree.h"
#include "gi_module/techniques/vertex-map/surface_shares.h"

namespace lanthorn::gi {
namespace {

// Photons spread evenly over [-1, 1]^2 of the plane z = 0, which together bring `lux` there.
struct Plane {
    explicit Plane(std::size_t count, float lux = 100, std::uint32_t seed = 1) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> number(-1, 1);
        store.reset(count, 1);
        for (std::size_t i = 0; i < count; ++i) {
            StoredPhoton photon;
            photon.position = vec3(number(random), number(random), 0);
            photon.normal = vec3(0, 0, 1);
            photon.flux = vec3(lux * 4 / static_cast<float>(count));
            photon.used = true;
            store.replace(i, std::span(&photon, 1));
        }
        tree.update(store, true);
        settings.nearest = 50;
    }

    SurfaceShares shares(const vec3& p) const {
        const std::vector<vec3> corners{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
        const std::vector<std::uint32_t> indices{0, 1, 2, 0, 2, 3};
        return SurfaceTriangles(corners, indices, settings.distance).about(p, vec3(0, 0, 1), false);
    }
    LightEstimate at(const vec3& p) const {
        return RadianceEstimate().at({p, vec3(0, 0, 1), 0}, shares(p), tree, store, settings, 0);
    }

    PhotonStore store;
    KeptTree tree;
    EstimateSettings settings;
};

// The mean over many sets of photons at one place, over what it should be.
double mean_at(const vec3& p, EstimateKernel kernel, std::size_t nearest, float distance) {
    double sum = 0;
    constexpr int kSets = 400;
    for (int set = 0; set < kSets; ++set) {
        Plane plane(1000, 100, static_cast<std::uint32_t>(set));
        plane.settings.kernel = kernel;
        plane.settings.nearest = nearest;
        plane.settings.distance = distance;
        sum += static_cast<double>(plane.at(p).irradiance.x) / 100;
    }
    return sum / kSets;
}

class DensityByKernel : public ::testing::TestWithParam<EstimateKernel> {};

// 50 of 1000 photons: each estimate is off by 1 / sqrt(48) or so, the mean of 400 by 0.007; the kernel that
// falls to its edge by a quarter more.
TEST_P(DensityByKernel, IsRightInTheMiddle) {
    EXPECT_NEAR(mean_at(vec3(0.1f, -0.2f, 0), GetParam(), 50, 1), 1, 0.02);
}

TEST_P(DensityByKernel, IsRightAtAnEdgeAndInACorner) {
    EXPECT_NEAR(mean_at(vec3(1, 0.1f, 0), GetParam(), 50, 1), 1, 0.02);
    EXPECT_NEAR(mean_at(vec3(0.95f, 0.1f, 0), GetParam(), 50, 1), 1, 0.02);
    EXPECT_NEAR(mean_at(vec3(-1, 1, 0), GetParam(), 50, 1), 1, 0.02);
}

// Fewer than m within the distance.
TEST_P(DensityByKernel, IsRightWherePhotonsAreFew) {
    EXPECT_NEAR(mean_at(vec3(0.3f, 0.3f, 0), GetParam(), 500, 0.2f), 1, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Kernels, DensityByKernel,
                         ::testing::Values(EstimateKernel::constant, EstimateKernel::epanechnikov));

// The thesis's circle: half the light at an edge, a quarter in a corner.
TEST(RadianceEstimate, WithoutTheSurfacesSharesEdgesAreDark) {
    double edge = 0, corner = 0;
    for (std::uint32_t set = 0; set < 200; ++set) {
        const Plane plane(1000, 100, set);
        const auto at = [&](const vec3& p) {
            return static_cast<double>(
                RadianceEstimate()
                    .at({p, vec3(0, 0, 1), 0}, {}, plane.tree, plane.store, plane.settings, 0)
                    .irradiance.x);
        };
        edge += at(vec3(1, 0, 0)) / 200;
        corner += at(vec3(1, 1, 0)) / 200;
    }
    EXPECT_NEAR(edge, 50, 2);
    EXPECT_NEAR(corner, 25, 1.5);
}

TEST(RadianceEstimate, TheNearestAreThoseOfALookAtAll) {
    const Plane plane(3000);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> number(-1, 1);
    for (int i = 0; i < 100; ++i) {
        const EstimatePoint point{vec3(number(random), number(random), 0.1f * number(random)), vec3(0, 0, 1),
                                  0};
        EstimateSettings settings = plane.settings;
        settings.nearest = 1 + static_cast<std::size_t>(i);
        std::vector<std::pair<float, std::uint32_t>> all;
        for (std::uint32_t k = 0; k < 3000; ++k) {
            const vec3 span = plane.store[k].position - point.position;
            all.emplace_back(glm::dot(span, span), k);
        }
        std::ranges::sort(all);
        all.resize(settings.nearest);
        for (const float first : {0.001f, 0.1f, 5.0f}) {  // wherever it looks first
            std::vector<NearPhoton> found;
            nearest_photons(point, plane.tree, plane.store, settings, first, found);
            std::ranges::sort(found, [](const NearPhoton& a, const NearPhoton& b) {
                return std::pair(a.distance2, a.place) < std::pair(b.distance2, b.place);
            });
            ASSERT_EQ(found.size(), all.size());
            for (std::size_t k = 0; k < all.size(); ++k) {
                ASSERT_EQ(found[k].place, all[k].second);
            }
        }
    }
}

TEST(RadianceEstimate, WhereItLooksFirstChangesNothing) {
    const Plane plane(2000);
    const EstimatePoint point{vec3(0.3f, 0.4f, 0), vec3(0, 0, 1), 0};
    const auto from = [&](float first) {
        return RadianceEstimate().at(point, {}, plane.tree, plane.store, plane.settings, first);
    };
    const LightEstimate wanted = from(0);
    for (const float first : {1e-6f, 0.05f, 0.3f, 100.0f}) {
        EXPECT_EQ(from(first).irradiance, wanted.irradiance);
        EXPECT_EQ(from(first).radius, wanted.radius);
    }
}

TEST(RadianceEstimate, PhotonsOfOtherSurfacesAndOfTheBackDoNotCount) {
    const Plane plane(1000);
    KeptTree together(TreeSurfaces::together);
    together.update(plane.store, true);
    const auto at = [&](const EstimatePoint& point, bool any) {
        EstimateSettings settings = plane.settings;
        settings.any_surface = any;
        return RadianceEstimate()
            .at(point, {}, any ? together : plane.tree, plane.store, settings, 0)
            .irradiance.x;
    };
    EXPECT_EQ(at({vec3(0), vec3(0, 0, 1), 1}, false), 0);
    EXPECT_EQ(at({vec3(0), vec3(0, 0, -1), 0}, false), 0);
    EXPECT_GT(at({vec3(0), vec3(0, 0, -1), 1}, true), 50);
}

// The area about them is none: light without bounds, unless it is told that there is none.
TEST(RadianceEstimate, PhotonsAllInOnePointAreNotInfinitelyBright) {
    PhotonStore store;
    store.reset(500, 1);
    StoredPhoton photon;
    photon.normal = vec3(0, 0, 1);
    photon.flux = vec3(1);
    photon.used = true;
    for (std::size_t i = 0; i < 500; ++i) {
        store.replace(i, std::span(&photon, 1));
    }
    KeptTree tree;
    tree.update(store, true);
    EstimateSettings settings;
    for (const EstimateKernel kernel : {EstimateKernel::constant, EstimateKernel::epanechnikov}) {
        settings.kernel = kernel;
        for (const vec3& p : {vec3(0), vec3(0.1f, 0, 0)}) {
            const LightEstimate e =
                RadianceEstimate().at({p, vec3(0, 0, 1), 0}, {}, tree, store, settings, 0);
            // As if they lay on a circle of a hundredth of the distance, brightest in its middle by the
            // kernel.
            EXPECT_LE(e.irradiance.x, 200 / (3.14f * 1e-4f));
            EXPECT_TRUE(e.irradiance.x > 0 || p != vec3(0));
        }
    }
}

TEST(RadianceEstimate, NoPhotonsAreNoLight) {
    PhotonStore store;
    store.reset(0, 1);
    KeptTree tree;
    tree.update(store, true);
    const LightEstimate e = RadianceEstimate().at({}, {}, tree, store, {}, 0);
    EXPECT_EQ(e.irradiance, vec3(0));
    EXPECT_EQ(e.photons, 0u);
}

}  // namespace
}  // namespace lanthorn::gi

// What is counted and kept of photons, by kind, surface and group of lights.
#include "gi_module/techniques/splat/photon_collection.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace lanthorn::gi::test {
namespace {

constexpr std::uint64_t kWalks = 30'000;

// A closed box lit by point lights of these colours.
FrameScene room(const std::vector<vec3>& colours, const vec3& albedo) {
    std::vector<LightInstance> lamps;
    for (std::size_t i = 0; i < colours.size(); ++i) {
        lamps.push_back(support::point_light(vec3(0.1f * static_cast<float>(i) - 0.7f, 0.2f, 0), 10));
        lamps.back().light.colour = colours[i];
    }
    return support::scene_of({support::box(vec3(-1), vec3(1), true, 0)}, {support::lambertian(albedo)}, lamps,
                             vec3(0), vec3(0, 0, 1));
}

struct Collected {
    FrameScene frame;
    reference::TileWorkers workers{2};
    PhotonScene scene;
    SplatSurfaces surfaces;
    PhotonCollection photons;

    explicit Collected(FrameScene lit, std::uint64_t walks = kWalks) : frame(std::move(lit)) {
        scene.follow(frame, PhotonScattering::even);
        surfaces.follow(frame, workers);
        EXPECT_TRUE(photons.grow(scene, surfaces, {.bounces = 2, .seed = 1}, walks, workers));
    }
    std::uint64_t of_sides() const {
        const auto all = photons.photons(false);
        return std::accumulate(all.begin(), all.end(), std::uint64_t{0});
    }
};

// Photons that a green wall makes of red light stand for hundreds of copies of the little green that the lamp
// has: many records each, but one photon, and bandwidths are of photons.
TEST(PhotonCollection, CountsPhotonsNotTheirRecords) {
    Collected c(room({vec3(1, 0.004f, 0)}, vec3(0.004f, 1, 0)));
    const PhotonRun traced = c.scene.tracer({.bounces = 2, .seed = 1}).trace(0, kWalks, c.workers);
    const auto indirect = static_cast<std::uint64_t>(
        std::ranges::count_if(traced.photons, [](const Photon& p) { return p.indirect(); }));
    EXPECT_EQ(c.photons.all(false), indirect);
    EXPECT_EQ(c.of_sides(), indirect);
    EXPECT_GT(c.photons.store().records(), 5 * indirect);
    EXPECT_EQ(c.photons.all(true), 0u);
}

TEST(PhotonCollection, LampsOfManyColoursShareTheirRuns) {
    std::vector<vec3> colours;
    for (int i = 0; i < 14; ++i) {
        colours.emplace_back(1, 0.05f * static_cast<float>(i + 1), 0.5f);
    }
    Collected many(room(colours, vec3(0.7f))), one(room({vec3(1)}, vec3(0.7f)));
    ASSERT_EQ(many.scene.sources().groups().size(), 14u);
    EXPECT_EQ(many.photons.store().runs(), one.photons.store().runs());
    // Each block is of one group, and each group's power is there as often as its photons carry it.
    std::vector<std::uint64_t> red(14, 0);
    many.photons.store().each([&](const RecordRun& run) {
        for (const PhotonBlock& block : run.blocks) {
            for (std::uint32_t i = block.first; i < block.first + block.count; ++i) {
                red[block.group] += run.records[i].copies(0);
            }
        }
    });
    const std::vector<std::uint64_t> paths = many.scene.sources().paths(kWalks);
    for (std::size_t g = 0; g < 14; ++g) {  // of each walk 0.7 + 0.7^2 are met again
        EXPECT_NEAR(static_cast<double>(red[g]) / static_cast<double>(paths[g]), 0.7 + 0.49, 0.08) << g;
    }
}

TEST(PhotonCollection, GrowingInStepsIsGrowingAtOnce) {
    Collected at_once(room({vec3(1), vec3(1, 0.5f, 0.2f)}, vec3(0.7f)));
    Collected steps(room({vec3(1), vec3(1, 0.5f, 0.2f)}, vec3(0.7f)), kWalks / 3);
    for (int i = 0; i < 2; ++i) {
        EXPECT_TRUE(steps.photons.grow(steps.scene, steps.surfaces, {.bounces = 2, .seed = 1}, kWalks / 3,
                                       steps.workers));
    }
    EXPECT_EQ(steps.photons.walks(), kWalks);
    EXPECT_EQ(steps.of_sides(), at_once.of_sides());
    EXPECT_EQ(steps.photons.store().records(), at_once.photons.store().records());
}

}  // namespace
}  // namespace lanthorn::gi::test

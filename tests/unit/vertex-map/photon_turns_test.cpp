// Which photons are shot in which frame, and what they carry.
#include "gi_module/techniques/vertex-map/photon_turns.h"

#include <gtest/gtest.h>

#include "gi_module/techniques/vertex-map/shot_scene.h"
#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace lanthorn::gi {
namespace {

// A lamp of 100 cd in the middle of a closed box: 400 pi lumen.
struct Room {
    Room() {
        frame =
            support::scene_of({support::box(vec3(0), vec3(4), true, 0)}, {support::lambertian(vec3(0.5f))},
                              {support::point_light(vec3(2), 100)}, vec3(1), vec3(2));
        settings.total = 1000;
        settings.per_frame = 100;
        store.reset(1000, 3);
        scene.follow(frame, 0);
    }
    PhotonTurns::Shot shoot(std::uint64_t count, bool direct = true) {
        settings.direct = direct;
        return turns.shoot(scene.tracer({2, 1, PhotonScattering::even}), scene.sources(), frame, count,
                           settings, store, workers);
    }
    double flux(std::size_t level) const {
        double sum = 0;
        for (std::size_t i = 0; i < store.total(); ++i) {
            sum += static_cast<double>(store[store.place(i, level)].flux.x);
        }
        return sum;
    }
    std::vector<vec3> positions() const {
        std::vector<vec3> all;
        for (const StoredPhoton& p : store.places()) {
            all.push_back(p.position);
        }
        return all;
    }

    FrameScene frame;
    VertexMapSettings settings;
    reference::TileWorkers workers{1};
    ShotScene scene;
    PhotonStore store;
    PhotonTurns turns;
};

class ByDistribution : public ::testing::TestWithParam<PhotonDistribution> {};

// All of the lamp's flux arrives, then half of it, then a quarter (half of the photons, with all they had).
TEST_P(ByDistribution, AllPhotonsTogetherCarryTheLampsFlux) {
    Room room;
    room.settings.distribution = GetParam();
    room.shoot(1000);
    const double flux = 400 * static_cast<double>(kPi);
    EXPECT_NEAR(room.flux(0) / flux, 1, 1e-4);
    EXPECT_NEAR(room.flux(1) / flux, 0.5, GetParam() == PhotonDistribution::per_frame ? 0.15 : 0.05);
    EXPECT_NEAR(room.flux(2) / flux, 0.25, GetParam() == PhotonDistribution::per_frame ? 0.12 : 0.05);
    EXPECT_EQ(room.turns.left(room.settings), 0u);
}

INSTANTIATE_TEST_SUITE_P(Distributions, ByDistribution,
                         ::testing::Values(PhotonDistribution::random, PhotonDistribution::per_frame,
                                           PhotonDistribution::total));

TEST(PhotonTurns, WithoutDirectLightTheFirstHitIsNotUsed) {
    Room room;
    room.shoot(1000, false);
    EXPECT_EQ(room.flux(0), 0);
    EXPECT_GT(room.flux(1), 0);
}

TEST(PhotonTurns, TheOldestGoFirst) {
    Room room;
    room.settings.distribution = PhotonDistribution::random;
    room.shoot(1000);
    const std::vector<vec3> before = room.positions();
    room.turns.outdate();
    EXPECT_EQ(room.turns.left(room.settings), 1000u);
    EXPECT_EQ(room.shoot(300).photons, 300u);
    EXPECT_EQ(room.turns.left(room.settings), 700u);
    const std::vector<vec3> now = room.positions();
    for (std::size_t i = 0; i < 1000; ++i) {
        EXPECT_EQ(now[i] != before[i], i < 300) << i;
    }
    room.shoot(800);  // no more than are left
    EXPECT_EQ(room.turns.left(room.settings), 0u);
    EXPECT_EQ(room.shoot(10).photons, 0u);
}

// A still scene: the same photons again, or not.
TEST(PhotonTurns, DistributionsRepeatAsTheySay) {
    for (const auto& [distribution, repeats] :
         {std::pair(PhotonDistribution::random, false), std::pair(PhotonDistribution::per_frame, true),
          std::pair(PhotonDistribution::total, true)}) {
        Room room;
        room.settings.distribution = distribution;
        room.shoot(1000);
        const std::vector<vec3> before = room.positions();
        room.turns.outdate();
        for (int i = 0; i < 10; ++i) {
            room.shoot(100);
        }
        EXPECT_EQ(room.positions() == before, repeats);
    }
    Room room;
    room.settings.distribution = PhotonDistribution::per_frame;
    room.shoot(1000);
    for (std::size_t i = 100; i < 1000; ++i) {  // the same hundred, ten times
        ASSERT_EQ(room.store[i].position, room.store[i % 100].position);
    }
}

TEST(PhotonTurns, NoLightShootsNothing) {
    Room room;
    room.frame.lights[0].light.intensity = 0;
    room.frame.changes.lights = true;
    room.scene.follow(room.frame, 0);
    room.shoot(1000);
    EXPECT_EQ(room.store.used(), 0u);
}

TEST(ShotScene, MeetsCoarserShapesButLosesNoLight) {
    Room room;
    FrameScene& frame = room.frame;
    frame = support::scene_of(
        {support::box(vec3(0), vec3(4), true, 0), support::sphere(vec3(1, 1, 1), 0.5f, 5, false, 0)},
        {support::lambertian(vec3(0.5f))}, {support::point_light(vec3(2), 100)}, vec3(1), vec3(2));
    ShotScene whole, coarse;
    whole.follow(frame, 0);
    EXPECT_TRUE(coarse.follow(frame, 0.02f));
    EXPECT_LT(4 * coarse.triangles(), whole.triangles());
    room.settings.direct = true;
    room.turns.shoot(coarse.tracer({2, 1, PhotonScattering::even}), coarse.sources(), frame, 1000,
                     room.settings, room.store, room.workers);
    EXPECT_NEAR(room.flux(0) / (400 * static_cast<double>(kPi)), 1, 1e-4);
    // Another time nothing is built.
    frame.changes = {};
    frame.changes.assets = frame.changes.geometry = frame.changes.lights = false;
    EXPECT_FALSE(coarse.follow(frame, 0.02f));
    EXPECT_EQ(coarse.builds(), 1u);
}

}  // namespace
}  // namespace lanthorn::gi

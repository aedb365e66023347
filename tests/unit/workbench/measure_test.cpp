// The measures of `lanthorn measure` on photons made by hand in scenes whose answers are plain.
#include <gtest/gtest.h>

#include "lanthorn/emc/emc_statistics.h"
#include "lanthorn/workbench/measure_coverage.h"
#include "lanthorn/workbench/measure_energy.h"
#include "lanthorn/workbench/measure_hits.h"
#include "tests/unit/reference/scenes.h"

namespace lanthorn::workbench {
namespace {

using namespace reference::test;

const auto kQuiet = [](std::uint64_t) {};

// A floor at y = 0 and a ceiling at y = 1 that face each other, 2 m square; the back of a third sheet far
// above to the left of them.
PhotonFlights between_plates() {
    PhotonFlights flights;
    flights.frame =
        scene_of({quad({-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, 0), quad({-1, 1, -1}, {2, 0, 0}, {0, 0, 2}, 0),
                  quad({-9, 4, -1}, {0, 0, 2}, {2, 0, 0}, 0)},
                 {lambertian(vec3(0.5f))}, {point_light({0, 0.5f, 0}, 1)}, {0, 0.5f, 5}, {0, 0.5f, 0});
    gi::PhotonStatistics photons;
    photons.flux_emitted = dvec3(100);
    flights.statistics.add(photons);
    return flights;
}

PhotonFlight flight(const vec3& from, const vec3& direction, bool arrived, float t) {
    return {from, direction, dvec3(1), arrived, from + direction * t};
}

constexpr vec3 kUp(0, 1, 0), kAside(0, 0, 1);
constexpr vec3 kFloor(0.3f, 0, 0.2f), kUnderTheBack(-8, 0, 0);

TEST(MeasureHits, EveryFlightHasItsPlace) {
    PhotonFlights flights = between_plates();
    const float d = flights.frame.diagonal();
    flights.bounces = {
        {flight(kFloor, kUp, true, 1), flight(kFloor, kUp, true, 1 + 0.015f * d),
         flight(kFloor, kUp, true, 1 - 0.03f * d), flight(kFloor, kUp, true, 1 + 0.3f * d),
         flight(kFloor, kUp, false, 0), flight(kFloor, kAside, true, 1), flight(kFloor, kAside, false, 0),
         flight(kUnderTheBack, kUp, false, 0), flight(kUnderTheBack, kUp, true, 4)},
        {flight(kFloor, kUp, true, 1)}};
    std::uint64_t looked_at = 0;
    const auto bounces = measure_hits(flights, [&](std::uint64_t done) { looked_at = done; });
    EXPECT_EQ(looked_at, 10u);
    ASSERT_EQ(bounces.size(), 2u);
    const HitCounts& c = bounces[0];
    EXPECT_EQ(c.segments, 7u);
    EXPECT_EQ(c.agree, 2u);
    EXPECT_EQ(c.near, 1u);
    EXPECT_EQ(c.far, 1u);
    EXPECT_EQ(c.missed, 1u);
    EXPECT_EQ(c.invented, 2u) << "what shows its back stores nothing";
    EXPECT_EQ(c.left, 2u);
    EXPECT_EQ(c.behind[3], 1u) << "1 to 2 %";
    EXPECT_EQ(c.before[4], 1u) << "2 to 5 %";
    EXPECT_EQ(c.behind[7], 1u) << "above 20 %";
    EXPECT_DOUBLE_EQ(c.share(c.agree), 2.0 / 7);
    EXPECT_EQ(bounces[1].agree, 1u);
    EXPECT_DOUBLE_EQ(HitCounts().share(0), 0);
}

TEST(MeasureEnergy, WhatComesInIsStoredOrLostAndWhatIsStoredAbsorbedOrReflected) {
    PhotonFlights flights = between_plates();
    flights.flux_without_surface = dvec3(10);
    flights.flux_reflected = {dvec3(4), dvec3(1)};
    flights.bounces = {{flight(kFloor, kUp, true, 1), flight(kFloor, kUp, true, 1),
                        flight(kFloor, kUp, false, 0), flight(kFloor, kAside, false, 0)}};
    const EnergyBalance balance = measure_energy(flights, kQuiet);
    EXPECT_EQ(balance.first.stored, dvec3(90));
    EXPECT_EQ(balance.first.absorbed, dvec3(86));
    ASSERT_EQ(balance.bounces.size(), 1u);
    const EnergyStep& s = balance.bounces[0];
    EXPECT_EQ(s.incoming, dvec3(4));
    EXPECT_EQ(s.stored, dvec3(2));
    EXPECT_EQ(s.lost, dvec3(2));
    EXPECT_EQ(s.lost_true, dvec3(1)) << "the one that leaves between the plates";
    EXPECT_EQ(s.stored_exact, dvec3(3));
    EXPECT_EQ(s.absorbed, dvec3(1));
    EXPECT_NEAR(luminous(dvec3(1)), 1, 1e-12);
}

// Two closed spheres apart from each other, a light in the left one.
PhotonFlights two_spheres(const std::vector<vec3>& maps) {
    PhotonFlights flights;
    flights.frame =
        scene_of({sphere({-2, 0, 0}, 1, 3, true, 0), sphere({2, 0, 0}, 1, 3, true, 0)},
                 {lambertian(vec3(0.5f))}, {point_light({-2, 0, 0}, 10)}, {-2, 0, 0.5f}, {-2, 0, 0});
    flights.statistics.plan.bounces = 2;
    flights.map_centres = maps;
    return flights;
}

TEST(MeasureCoverage, IsOfWhatLightReachesAlone) {
    const auto f = measure_coverage(two_spheres({{-2.3f, 0.2f, 0}}), 2000, 1, kQuiet);
    EXPECT_NEAR(f.area, 8 * 3.14159, 0.3);
    EXPECT_NEAR(f.reached_area, f.area / 2, 0.1);
    EXPECT_EQ(f.points, 2000);
    EXPECT_GT(f.coverage, 0.995);
    EXPECT_EQ(f.seen_by_map, f.alone_by_map);
}

TEST(MeasureCoverage, AMapWhereNoLightIsCoversNothing) {
    const auto f = measure_coverage(two_spheres({{2, 0, 0}}), 500, 1, kQuiet);
    EXPECT_NEAR(f.reached, 250, 2);
    EXPECT_EQ(f.coverage, 0);
}

// Half of the candidates are where the light is.
TEST(MeasureCoverage, CandidatesDrawnAtRandomCoverWhatTheyCover) {
    PhotonFlights flights = two_spheres({{-2.3f, 0.2f, 0}});
    flights.candidates = {{-2.3f, 0.2f, 0}, {2, 0, 0}, {-1.8f, 0, 0}, {2.2f, 0, 0}};
    const auto one = measure_coverage(flights, 500, 1, kQuiet);
    EXPECT_NEAR(one.random.mean, 0.5, 0.1);
    EXPECT_NEAR(one.random.deviation, 0.5, 0.02);
    EXPECT_EQ(one.random.least, 0);
    EXPECT_GT(one.random.most, 0.995);
    EXPECT_GT(one.coverage, one.random.mean);
    flights.map_centres.resize(3);  // of any three one at least is there
    const auto three = measure_coverage(flights, 500, 1, kQuiet);
    EXPECT_GT(three.random.least, 0.995);
    EXPECT_LT(three.random.deviation, 0.01);
}

TEST(MeasureCoverage, MapsThatSeeTheSameSeeNothingAlone) {
    const auto f = measure_coverage(two_spheres({{-2, 0, 0}, {-1.8f, 0, 0}, {2, 0, 0}}), 500, 1, kQuiet);
    ASSERT_EQ(f.seen_by_map.size(), 3u);
    EXPECT_GT(f.seen_by_map[1], 0.99);
    EXPECT_LT(f.alone_by_map[0] + f.alone_by_map[1], 0.01);
    EXPECT_EQ(f.seen_by_map[2], 0);
}

TEST(MeasureCoverage, ABlackRoomReflectsToNowhere) {
    PhotonFlights flights = two_spheres({{-2, 0, 0}});
    flights.frame = scene_of({sphere({-2, 0, 0}, 1, 2, true, 0)}, {lambertian(vec3(0))},
                             {point_light({-2, 0, 0}, 10)}, {-2, 0, 0.5f}, {-2, 0, 0});
    EXPECT_EQ(measure_coverage(flights, 100, 1, kQuiet).reached, 0);
}

// A vault over a plate that hides half of it from the map: what a point sees is half of a sphere.
TEST(MeasureCoverage, ASheetThroughTheMiddleHidesTheOtherHalf) {
    PhotonFlights flights = two_spheres({{-2, 0.4f, 0}});
    Material both = lambertian(vec3(0.5f));
    both.double_sided = true;
    flights.frame = scene_of({sphere({-2, 0, 0}, 1, 3, true, 0), quad({-3, 0, -1}, {0, 0, 2}, {2, 0, 0}, 1)},
                             {lambertian(vec3(0.5f)), both},
                             {point_light({-2, 0.5f, 0}, 10), point_light({-2, -0.5f, 0}, 10)},
                             {-2, 0.3f, 0.5f}, {-2, 0, 0});
    const auto f = measure_coverage(flights, 4000, 1, kQuiet);
    const double inside = 4 * 3.14159 + 2 * 3.14159;  // the sphere, and both sides of the disc within it
    EXPECT_NEAR(f.reached_area, inside, 0.03 * inside);
    EXPECT_NEAR(f.coverage, 0.5, 0.02);
}

TEST(MeasureCoverage, LampsShineLikeLights) {
    PhotonFlights flights = two_spheres({{-2, 0, 0}});
    flights.frame = scene_of(
        {sphere({-2, 0, 0}, 1, 3, true, 0), quad({-2.1f, 0.8f, -0.1f}, {0.2f, 0, 0}, {0, 0, 0.2f}, 1)},
        {lambertian(vec3(0.5f)), lamp(vec3(100))}, {}, {-2, 0, 0.5f}, {-2, 0, 0});
    const auto f = measure_coverage(flights, 500, 1, kQuiet);
    EXPECT_GT(f.reached, 480);
}

}  // namespace
}  // namespace lanthorn::workbench

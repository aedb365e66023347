// What caustic photons cost: one budget for all that mirrors, and only what changed is traced again.
#include <gtest/gtest.h>

#include "gi_module/techniques/emc/emc_technique.h"
#include "tests/gpu/gi/caustics_scene.h"

namespace lanthorn::gi::test {
namespace {

TEST_F(Caustics, ThousandsOfThingsShareTheBudget) {
    std::vector<Mesh> things;
    for (int i = 0; i < 2000; ++i) {
        const vec3 p(-1.9f + 0.2f * static_cast<float>(i % 20),
                     -1.9f + 0.4f * static_cast<float>(i / 20 % 10),
                     -1.9f + 0.19f * static_cast<float>(i / 200) * 2);
        things.push_back(box(p, p + vec3(0.05f), false, 1));
    }
    const FrameScene scene =
        room_with(things, {metal(vec3(1), 0)},
                  {point_light(vec3(0, 1.95f, 0), 10), point_light(vec3(1, 1.95f, 0.4f), 10)});
    CausticStatistics all;
    const double flux = stored_flux(scene, settings_of(20'000), &all);
    EXPECT_LE(all.emitted, 20'000u);
    EXPECT_GT(all.emitted, 10'000u);
    EXPECT_GT(flux, 0);
    // All of it as one thing: the same light.
    Mesh one;
    one.material = 1;
    for (const Mesh& thing : things) {
        const auto first = static_cast<std::uint32_t>(one.vertices.size());
        one.vertices.insert(one.vertices.end(), thing.vertices.begin(), thing.vertices.end());
        for (const std::uint32_t i : thing.indices) {
            one.indices.push_back(first + i);
        }
        one.bounds.add(thing.bounds);
    }
    const double whole =
        stored_flux(room_with({one}, {metal(vec3(1), 0)}, scene.lights), settings_of(20'000));
    std::printf("2000 things: flux %.4f of that of one thing with their shape\n", flux / whole);
    EXPECT_NEAR(flux / whole, 1, 0.06);
}

TEST_F(Caustics, OnlyWhatChangedIsTraced) {
    FrameScene scene = room_with({support::sphere(vec3(0), 0.4f, 4, false, 1)}, {metal(vec3(1), 0)},
                                 {point_light(vec3(0, 1.2f, 0), 10), point_light(vec3(1.2f, 0, 0), 10)});
    Bench bench;
    bench.settings = settings_of(10'000);
    bench.frame(scene, kSize);
    const auto& caustics = dynamic_cast<const EmcTechnique&>(bench.technique()).caustics();
    const CausticStatistics first = caustics.statistics();
    EXPECT_EQ(first.traced, first.emitted);
    hold_still(scene);
    bench.frame(scene, kSize);
    EXPECT_EQ(caustics.version(), 1u);
    scene.lights[1].position.y += 0.01f;
    scene.changes.lights = true;
    bench.frame(scene, kSize);
    const CausticStatistics moved = caustics.statistics();
    EXPECT_EQ(caustics.version(), 2u);
    EXPECT_EQ(moved.emitted, first.emitted);
    EXPECT_EQ(2 * moved.traced, moved.emitted);
    // As if it had been there from the start.
    Bench fresh;
    fresh.settings = bench.settings;
    fresh.frame(scene, kSize);
    const auto& anew = dynamic_cast<const EmcTechnique&>(fresh.technique()).caustics();
    ASSERT_EQ(anew.hits().size(), caustics.hits().size());
    for (std::size_t i = 0; i < anew.hits().size(); ++i) {
        ASSERT_EQ(anew.hits()[i].position, caustics.hits()[i].position);
        ASSERT_EQ(anew.hits()[i].radius, caustics.hits()[i].radius);
    }
}

TEST_F(Caustics, GoWhenTheyAreTurnedOff) {
    FrameScene scene = room_with({support::sphere(vec3(0), 0.4f, 4, false, 1)}, {metal(vec3(1), 0)},
                                 {point_light(vec3(0, 1.2f, 0), 10)});
    Bench bench, without;
    bench.settings = settings_of(10'000);
    without.settings = settings_of(0);
    bench.frame(scene, kSize);
    without.frame(scene, kSize);
    hold_still(scene);
    bench.settings.edit<EmcSettings>().caustic_photons = 0;
    EXPECT_EQ(bench.frame(scene, kSize).pixels, without.frame(scene, kSize).pixels);
    bench.settings.edit<EmcSettings>().caustic_photons = 10'000;
    EXPECT_NE(bench.frame(scene, kSize).pixels, without.frame(scene, kSize).pixels);
}

}  // namespace
}  // namespace lanthorn::gi::test

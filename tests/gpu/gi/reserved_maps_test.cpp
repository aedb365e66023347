// Environment maps reserved for what the picture sees and no candidate does: a niche as narrow as none may
// stand in.
#include <gtest/gtest.h>

#include <algorithm>

#include "gi_module/shared/rays/embree_rays.h"
#include "gi_module/techniques/emc/emc_technique.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/emc/emc_statistics.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace {

constexpr ivec2 kSize(96);
// A centre of the selection keeps 1 % of the diagonal from all surfaces: 5.5 cm here. The niche is 9 cm wide.
constexpr float kNiche = 0.09f;

// A room with a block that leaves a niche before the wall x = 4, seen along it, and a lamp.
FrameScene room_with_niche() {
    FrameScene scene = scene_of(
        {box(vec3(0), vec3(4, 2.4f, 3), true, 0), box(vec3(3, 0, 2), vec3(4 - kNiche, 1.2f, 3), false, 0)},
        {lambertian(vec3(0.6f))}, {point_light(vec3(2.6f, 1.9f, 0.5f), 100)}, vec3(3.96f, 0.7f, 1),
        vec3(3.955f, 0.6f, 3));
    scene.camera.camera.y_fov = 0.5f;
    return scene;
}

GiSettings settings_of(int reserved) {
    GiSettings settings;
    settings.edit<EmcSettings>().final_stage = EmcFinal::gather;
    settings.edit<EmcSettings>().gather_points = 1;
    settings.edit<EmcSettings>().gather_grid = 2;
    settings.edit<EmcSettings>().rays = EmcRays::bvh;
    settings.edit<EmcSettings>().reserved = reserved;
    settings.edit<EmcSettings>().gather_endless = false;
    return settings;
}

struct Seen {
    GatherStatistics gather;
    EmcStatistics maps;
    std::vector<vec3> centres;
};

Seen seen_after(Bench& bench, FrameScene scene, int frames) {
    bench.frame(scene, kSize);
    hold_still(scene);
    for (int f = 1; f < frames; ++f) {
        bench.frame(scene, kSize);
    }
    const GiStatistics statistics = bench.technique().statistics(false);
    Seen seen{statistics.of<GatherStatistics>(), statistics.of<EmcStatistics>(), {}};
    const EnvironmentMaps& maps = dynamic_cast<const EmcTechnique&>(bench.technique()).maps();
    for (const int member : maps.selected()) {
        seen.centres.push_back(maps.centre(member));
    }
    return seen;
}

TEST(ReservedMaps, ANicheThatNoCandidateSeesGetsOne) {
    add_embree_rays();
    Bench without;
    without.settings = settings_of(0);
    const Seen before = seen_after(without, room_with_niche(), 24);
    Bench bench;
    bench.settings = settings_of(2);
    const Seen after = seen_after(bench, room_with_niche(), 24);
    std::printf(
        "niche: blind points %lu and %lu of %lu, unknown %.5f and %.5f of the rays, maps %d and %d + %d\n",
        static_cast<unsigned long>(before.gather.blind_points),
        static_cast<unsigned long>(after.gather.blind_points),
        static_cast<unsigned long>(after.gather.points), before.gather.unknown_share,
        after.gather.unknown_share, before.maps.k, after.maps.k, after.maps.reserved);
    EXPECT_EQ(before.maps.reserved, 0);
    EXPECT_GT(before.gather.blind_points, 100u);
    EXPECT_GE(after.maps.reserved, 1);
    EXPECT_EQ(after.gather.blind_points, 0u);
    EXPECT_TRUE(
        std::ranges::any_of(after.centres, [](const vec3& c) { return c.x > 4 - kNiche && c.z > 2; }));
}

TEST(ReservedMaps, StayWhereTheyAre) {
    add_embree_rays();
    Bench bench;
    bench.settings = settings_of(2);
    const FrameScene scene = room_with_niche();
    const Seen first = seen_after(bench, scene, 24);
    // The camera moves by a hair in each frame: rays are shot and surveys made on and on.
    FrameScene walking = scene;
    hold_still(walking);
    for (int f = 0; f < 40; ++f) {
        const float aside = 0.0002f * static_cast<float>(f % 2);
        support::look(walking, vec3(3.96f - aside, 0.7f, 1), vec3(3.955f - aside, 0.6f, 3));
        walking.changes.camera = true;
        bench.frame(walking, kSize);
    }
    EXPECT_EQ(seen_after(bench, walking, 1).centres, first.centres);
}

TEST(ReservedMaps, AnOpenRoomHasNone) {
    add_embree_rays();
    Bench bench;
    bench.settings = settings_of(2);
    const Seen seen =
        seen_after(bench,
                   scene_of({box(vec3(0), vec3(4, 2.4f, 3), true, 0)}, {lambertian(vec3(0.6f))},
                            {point_light(vec3(2, 1.9f, 1.5f), 100)}, vec3(0.3f, 1.2f, 0.3f), vec3(3, 1, 2)),
                   20);
    EXPECT_EQ(seen.maps.reserved, 0);
    EXPECT_GT(seen.gather.points, 1000u);
    EXPECT_EQ(seen.gather.blind_points, 0u);
    EXPECT_LT(seen.gather.unknown_share, 1e-3);
}

}  // namespace
}  // namespace lanthorn::gi::test

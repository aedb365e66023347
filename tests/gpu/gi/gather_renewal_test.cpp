// gi.emc.final = gather: what it remembers, and what it forgets when lamps, settings and sizes change.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "gi_module/techniques/emc/gather/remembered_hits.h"
#include "lanthorn/emc/emc_settings.h"
#include "tests/gpu/gi/gather_scene.h"
#include "tests/gpu/gi/path_truth.h"

namespace lanthorn::gi::test {
namespace gather_renewal_test {

constexpr ivec2 kSize(128);
constexpr int kAllFrames = RememberedHits::kFrames;

bool has_span(const Bench& bench, const std::string& name) {
    return std::ranges::any_of(bench.spans, [&](const auto& span) { return span.name == name; });
}

TEST(Gather, TheSameSceneGivesTheSameBits) {
    Bench a;
    Bench b;
    a.settings = b.settings = gathered_by_rays(3);
    EXPECT_EQ(still_picture(a, room_with_block(), 3, kSize).pixels,
              still_picture(b, room_with_block(), 3, kSize).pixels);
}

// Hits are remembered, not light: the frame after a lamp goes out is the one of a room where it never was,
// but for where guided rays went.
TEST(Gather, ALampThatGoesOutLeavesNothing) {
    for (const bool guide : {false, true}) {
        Bench lit;
        lit.settings = gathered_by_rays(3);
        lit.settings.edit<EmcSettings>().gather_guide = guide;
        const ImageF before = still_picture(lit, room_with_block(), kAllFrames, kSize);
        FrameScene dimmed = room_with_block(100, 0);
        hold_still(dimmed);
        dimmed.changes.lights = true;
        const ImageF after = lit.frame(dimmed, kSize, true);
        EXPECT_FALSE(has_span(lit, "gather_rays") || has_span(lit, "lit_rays"));
        EXPECT_EQ(lit.technique().statistics(true).of<GatherStatistics>().rays, 0u);

        Bench never;
        never.settings = lit.settings;
        const ImageF expected = still_picture(never, room_with_block(100, 0), kAllFrames, kSize);
        EXPECT_NE(after.pixels, before.pixels);
        if (guide) {
            const Deviation d = against(after, expected.pixels);
            std::printf("guided by a lamp that went out: flux %.4f, relRMSE %.4f\n", d.mean, d.rel_rmse);
            EXPECT_NEAR(d.mean, 1, 0.005);
            EXPECT_LT(d.rel_rmse, 0.05);
        } else {
            EXPECT_EQ(after.pixels, expected.pixels);
        }
    }
}

TEST(Gather, AStillSceneRunsNothingOnceAllIsRemembered) {
    Bench bench;
    bench.settings = gathered_by_rays();
    FrameScene scene = room_with_block();
    const ImageF last = still_picture(bench, scene, kAllFrames, kSize);
    EXPECT_TRUE(bench.technique().statistics(false).plan.on("gather"));
    hold_still(scene);
    EXPECT_EQ(bench.frame(scene, kSize, true).pixels, last.pixels);
    for (const char* pass : {"lit_maps", "gather", "filter", "upsampling", "emission", "bounces", "splats"}) {
        EXPECT_FALSE(has_span(bench, pass)) << pass;
        EXPECT_FALSE(bench.technique().statistics(false).plan.on(pass)) << pass;
    }
}

// Other settings and sizes begin anew, with the bits of a fresh start.
TEST(Gather, OtherSettingsBeginAnew) {
    Bench kept;
    kept.settings = gathered_by_rays(1);  // no rays from the lit maps, that outlast what the picture's do not
    FrameScene scene = room_with_block();
    still_picture(kept, scene, 3, kSize);
    hold_still(scene);
    ivec2 size = kSize;
    const auto expect_fresh = [&](const char* what) {
        Bench fresh;
        fresh.settings = kept.settings;
        FrameScene all_new = scene;
        all_new.changes = room_with_block().changes;
        EXPECT_EQ(kept.frame(scene, size).pixels, fresh.frame(all_new, size).pixels) << what;
    };
    kept.settings.edit<EmcSettings>().gather_rays = 3;
    expect_fresh("rays");
    kept.settings.edit<EmcSettings>().gather_grid = 5;
    expect_fresh("grid");
    size = ivec2(90, 61);
    expect_fresh("size");
    kept.settings.bounces = 3;
    expect_fresh("bounces");
}

TEST(Gather, SplatsAreWhatTheyWereAfterADetour) {
    const FrameScene scene = room_with_block();
    FrameScene still = scene;
    hold_still(still);
    Bench bench;
    const auto first = bench.frame(scene, kSize);
    bench.settings.edit<EmcSettings>().final_stage = EmcFinal::gather;
    const auto gathered = bench.frame(still, kSize);
    EXPECT_NE(gathered.pixels, first.pixels);
    bench.settings.edit<EmcSettings>().final_stage = EmcFinal::splat;
    EXPECT_EQ(bench.frame(still, kSize).pixels, first.pixels);
}

}  // namespace gather_renewal_test
}  // namespace lanthorn::gi::test

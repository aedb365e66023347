// Rays of the gather that lit texels guide: the same light with less noise.
#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>

#include "gi_module/techniques/emc/gather/remembered_hits.h"
#include "lanthorn/emc/emc_settings.h"
#include "tests/gpu/gi/gather_scene.h"
#include "tests/support/closed_forms.h"

namespace lanthorn::gi::test {
namespace guided_rays_test {

constexpr ivec2 kSize(128);
constexpr int kAllFrames = RememberedHits::kFrames;

constexpr double kGuided = 0.7;  // measured: 0.57

// Wherever the lamp hangs in a closed sphere, the light that was reflected once is the same on all of it.
// With the lamp near the wall it comes from there for the most part: guided rays go there, and must count for
// less.
TEST(Gather, GuidedRaysFindTheSameLightWithLessNoise) {
    FrameScene scene = closed_sphere(0.5f);
    scene.lights.front().position = vec3(0, 0.85f, 0);
    const double expected = support::sphere_irradiance(kSphereLux, 1, 0.5, 1);
    for (const int frames : {1, kAllFrames}) {
        double noise[2] = {0, 0};
        for (const bool guide : {false, true}) {
            Bench bench;
            bench.settings = gathered_by_rays(1);
            bench.settings.edit<EmcSettings>().gather_guide = guide;
            const Deviation d = deviation_of(still_picture(bench, scene, frames, kSize), expected);
            std::printf("lamp by the wall, guide %d, %d frames: mean %.5f, relRMSE %.5f\n", guide, frames,
                        d.mean, d.rel_rmse);
            EXPECT_NEAR(d.mean, 1, frames == 1 ? 0.015 : 0.01);
            noise[guide ? 1 : 0] = d.rel_rmse;
        }
        EXPECT_LT(noise[1], kGuided * noise[0]) << frames;
    }
}

// What guided rays in another view tells nothing of this one: the first frame after a cut finds its own
// guides, as the very first does.
TEST(Gather, AfterACutRaysAreGuidedAtOnce) {
    FrameScene scene = closed_sphere(0.5f);
    scene.lights.front().position = vec3(0, 0.85f, 0);
    const double expected = support::sphere_irradiance(kSphereLux, 1, 0.5, 1);
    Bench cut, fresh;
    cut.settings = fresh.settings = gathered_by_rays(1);
    support::look(scene, vec3(0), vec3(0, 0, -1));
    still_picture(cut, scene, 4, kSize);
    hold_still(scene);
    support::look(scene, vec3(0), vec3(0, 0, 1));
    scene.changes.camera = true;
    const Deviation there = deviation_of(cut.frame(scene, kSize), expected);
    scene.changes = closed_sphere(0.5f).changes;
    const Deviation first = deviation_of(fresh.frame(scene, kSize), expected);
    std::printf("after a cut: relRMSE %.5f; first frame %.5f\n", there.rel_rmse, first.rel_rmse);
    EXPECT_LT(there.rel_rmse, 1.15 * first.rel_rmse);
}

// What is shot stays as it was: rays that are exchanged flicker while a lamp moves.
TEST(Gather, GuidedRaysOfAStillViewAreShotOnce) {
    Bench bench;
    bench.settings = gathered_by_rays(1);
    FrameScene scene = room_with_block();
    std::uint64_t rays[kAllFrames] = {};
    for (std::uint64_t& shot : rays) {
        bench.frame(scene, kSize);
        hold_still(scene);
        shot = bench.technique().statistics(false).of<GatherStatistics>().rays;
    }
    const std::uint64_t slot = rays[1];
    EXPECT_EQ(rays[0], 5 * slot) << "four, and one that they are guided by";
    EXPECT_EQ(std::accumulate(rays, rays + kAllFrames, 0ul), (RememberedHits::kFrames + 1) * slot);
}

}  // namespace guided_rays_test
}  // namespace lanthorn::gi::test

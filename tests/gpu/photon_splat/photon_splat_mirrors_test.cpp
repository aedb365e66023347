// Mirrors under `splat`: what one shows is what a camera behind it sees, and what the path tracer finds.
#include <gtest/gtest.h>

#include "tests/gpu/gi/mirror_room.h"
#include "tests/gpu/photon_splat/photon_splat_bench.h"

namespace lanthorn::gi::test {
namespace {

const Material kMirror = metal(vec3(1), 0);

TEST(PhotonSplatMirrors, ShowWhatACameraBehindThemSees) {
    Splat before, behind;
    expect_the_view_from_behind("splat", before, behind, kSize);
    EXPECT_GT(before.now().mirror_rays, 5000u);
    EXPECT_EQ(behind.now().mirror_rays, 0u);
}

// What is mirrored has been reflected once less than what is seen.
TEST(PhotonSplatMirrors, ShowTheWallsThatThePathTracerFinds) {
    const FrameScene scene = mirror_room_with_a_lamp(kMirror);
    Splat bench(400'000);
    bench.own().caustic_bandwidth = 12;
    const Deviation d =
        against_path(radiance_of(bench, scene, kSize), scene, bench.settings.bounces + 1, 256);
    bench.settings.specular_roughness = 0;
    const Deviation without =
        against_path(radiance_of(bench, scene, kSize), scene, bench.settings.bounces + 1, 256);
    EXPECT_EQ(bench.technique().traced_lobes().roughness, 0);
    EXPECT_FALSE(bench.technique().statistics(false).plan.on("mirrors"));
    std::printf("splat, mirror and path: flux %.4f, relRMSE %.4f; without rays %.4f, %.4f\n", d.mean,
                d.rel_rmse, without.mean, without.rel_rmse);
    EXPECT_NEAR(d.mean, 1, 0.03);
    EXPECT_LT(d.rel_rmse, 0.06);
    EXPECT_GT(without.rel_rmse, 5 * d.rel_rmse);
}

TEST(PhotonSplatMirrors, ALampThatMovesIsSeenInThemWithoutRays) {
    Splat kept(20'000), fresh(20'000);
    expect_a_lamp_to_be_followed(kept, fresh, kSize, [&] { EXPECT_EQ(kept.now().mirror_rays, 0u); });
}

}  // namespace
}  // namespace lanthorn::gi::test

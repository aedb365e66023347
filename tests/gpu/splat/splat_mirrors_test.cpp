// Mirrors under `splat`: what one shows is what a camera behind it sees, and what the path tracer finds.
#include <gtest/gtest.h>

#include "tests/gpu/gi/mirror_room.h"
#include "tests/gpu/splat/splat_bench.h"

namespace lanthorn::gi::test {
namespace {

TEST(PhotonSplatMirrors, ShowWhatACameraBehindThemSees) {
    Splat before, behind;
    expect_the_view_from_behind("splat", before, behind, kSize);
    EXPECT_GT(before.now().mirror_rays, 5000u);
    EXPECT_EQ(behind.now().mirror_rays, 0u);
}

TEST(PhotonSplatMirrors, ShowTheWallsThatThePathTracerFinds) {
    Splat bench(400'000);
    bench.own().caustic_bandwidth = 12;
    expect_the_walls_that_the_path_tracer_finds("splat", bench, kSize, 1);
}

TEST(PhotonSplatMirrors, ALampThatMovesIsSeenInThemWithoutRays) {
    Splat kept(20'000), fresh(20'000);
    expect_a_lamp_to_be_followed(kept, fresh, kSize, [&] { EXPECT_EQ(kept.now().mirror_rays, 0u); });
}

}  // namespace
}  // namespace lanthorn::gi::test

// A window that answers its user within a frame: the picture is the same bit for bit, and it is asked more
// often the more pixels there are.
#include <gtest/gtest.h>

#include "engine/gpu/pass_end.h"
#include "lanthorn/emc/emc_settings.h"
#include "tests/gpu/gi/gather_scene.h"

namespace lanthorn::gi::test {
namespace {

// Of two frames of a point a pixel.
ImageF picture(ivec2 size) {
    Bench bench;
    EmcSettings& emc = bench.settings.edit<EmcSettings>();
    emc.final_stage = EmcFinal::gather;
    emc.gather_grid = 1;
    emc.gather_rays = 1;
    return still_picture(bench, room_with_block(), 2, size);
}

TEST(PassEnds, AreToldWithinLongFiltersAndChangeNothing) {
    constexpr ivec2 kSmall(64, 48), kLarge(288, 232);
    const ImageF alone = picture(kLarge);
    int small = 0, large = 0;
    {
        const gpu::PassEnd heard([&] { ++small; });
        picture(kSmall);
    }
    {
        const gpu::PassEnd heard([&] { ++large; });
        EXPECT_EQ(picture(kLarge).pixels, alone.pixels);
    }
    EXPECT_GT(large, small);
    std::printf("%d answers in a frame of %dx%d, %d in one of %dx%d\n", small / 2, kSmall.x, kSmall.y,
                large / 2, kLarge.x, kLarge.y);
}

}  // namespace
}  // namespace lanthorn::gi::test

// Lists of photons by tile: what happens where there is no room for them.
#include <gtest/gtest.h>

#include "lanthorn/gi/emc/emc_technique.h"
#include "lanthorn/gi/emc/splatting.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace {

using Picture = std::vector<float>;

// A frame with photons, which any Splatting may splat.
struct Lit {
    Lit() {
        bench.settings.photons = 3000;
        bench.frame(scene, ivec2(160, 128));
    }
    Picture splat(Splatting& splatting) {
        const ecs::World& world = bench.app.world();
        const Renderer& renderer = world.resource<Renderer>();
        const auto& technique = static_cast<const EmcTechnique&>(bench.technique());
        return splatting
            .irradiance(renderer.frame->inputs(world.resource<FrameScene>(), *renderer.timer),
                        technique.maps(), technique.photons().arrived(), bench.settings, true, bad_values)
            .read_floats(4);
    }

    Bench bench;
    FrameScene scene = scene_of({box(vec3(0), vec3(4, 2.6f, 4), true, 0)}, {lambertian(vec3(0.6f))},
                                {point_light(vec3(2, 2, 2), 100)}, vec3(3.6f, 1.6f, 3.6f), vec3(1, 0.8f, 1));
    gpu::Buffer bad_values = gpu::Buffer(sizeof(std::uint32_t));
};

double largest_difference(const Picture& a, const Picture& b) {
    double largest = 0, highest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest = std::max(largest, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
        highest = std::max(highest, static_cast<double>(a[i]));
    }
    return largest / highest;
}

TEST(SplatLists, WithoutRoomLoseNothingAndHaveRoomInTheNextFrame) {
    Lit lit;
    Splatting roomy;
    const Picture picture = lit.splat(roomy);
    lit.splat(roomy);
    const auto entries = static_cast<std::size_t>(roomy.statistics().entries);
    EXPECT_GT(entries, 3000u);
    EXPECT_GE(roomy.statistics().capacity, entries);
    EXPECT_EQ(roomy.statistics().overflows, 0u);
    for (const std::size_t room : {std::size_t{1}, entries / 2, entries - 1}) {
        Splatting tight(room, 0), again(room, 0);
        const Picture first = lit.splat(tight);
        EXPECT_LT(largest_difference(picture, first), 1e-5) << room;
        EXPECT_EQ(first, lit.splat(again)) << "in every run the same";
        EXPECT_EQ(tight.statistics().overflows, 0u) << "not known yet";
        EXPECT_EQ(lit.splat(tight), picture);
        EXPECT_EQ(tight.statistics().overflows, 1u);
        EXPECT_EQ(tight.statistics().entries, entries);
        EXPECT_GE(tight.statistics().capacity, entries);
        EXPECT_EQ(lit.splat(tight), picture);
        EXPECT_EQ(tight.statistics().overflows, 1u);
    }
}

}  // namespace
}  // namespace lanthorn::gi::test

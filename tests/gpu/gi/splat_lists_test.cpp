// Lists of photons by tile: what happens where there is no room for them.
#include <gtest/gtest.h>

#include "gi_module/techniques/emc/emc_technique.h"
#include "gi_module/techniques/emc/faster.h"
#include "gi_module/techniques/emc/splat/splatting.h"
#include "lanthorn/emc/emc_settings.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace {

using Picture = std::vector<float>;

// A frame with photons, which any Splatting may splat.
struct Lit {
    explicit Lit(bool orthographic = false, Bandwidth bandwidth = Bandwidth::variable) {
        if (orthographic) {
            scene.camera.camera.orthographic = true;
            scene.camera.camera.x_mag = scene.camera.camera.y_mag = 1.2f;
        }
        bench.settings.photons = 3000;
        bench.settings.edit<EmcSettings>().splat_bandwidth = bandwidth;
        bench.frame(scene, kSize);
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

    static constexpr ivec2 kSize{160, 128};
    Bench bench;
    FrameScene scene = scene_of({box(vec3(0), vec3(4, 2.6f, 4), true, 0)}, {lambertian(vec3(0.6f))},
                                {point_light(vec3(2, 2, 2), 100)}, vec3(3.6f, 1.6f, 3.6f), vec3(1, 0.8f, 1));
    gpu::Buffer bad_values = gpu::Buffer(sizeof(std::uint32_t));
};

SplatTiles::Options room_for(std::size_t entries) {
    return {.entries = entries, .entries_a_photon = 0, .binning = SplatBinning::by_tile};
}

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
    Splatting roomy({}, SplatKernel::batches);
    const Picture picture = lit.splat(roomy);
    lit.splat(roomy);
    const auto entries = static_cast<std::size_t>(roomy.statistics().entries);
    EXPECT_GT(entries, 3000u);
    EXPECT_GE(roomy.statistics().capacity, entries);
    EXPECT_EQ(roomy.statistics().overflows, 0u);
    for (const std::size_t room : {std::size_t{1}, entries / 2, entries - 1}) {
        Splatting tight(room_for(room), SplatKernel::batches), again(room_for(room), SplatKernel::batches);
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

// Projected spheres leave out no photon that counts: where there is no room, every pixel tries all photons.
TEST(SplatLists, HaveAllThatReachTheirTiles) {
    for (const bool orthographic : {false, true}) {
        Lit lit(orthographic);
        Splatting listed({}, SplatKernel::batches), all(room_for(1), SplatKernel::batches);
        const Picture picture = lit.splat(listed);
        EXPECT_LT(largest_difference(picture, lit.splat(all)), 1e-5) << orthographic;
    }
}

TEST(SplatLists, AreTheSameHoweverPhotonsFindTheirTiles) {
    for (const bool orthographic : {false, true}) {
        Lit lit(orthographic);
        Splatting by_tile({.binning = SplatBinning::by_tile}, SplatKernel::batches);
        Splatting by_photon({.binning = SplatBinning::by_photon}, SplatKernel::batches);
        EXPECT_EQ(lit.splat(by_tile), lit.splat(by_photon)) << orthographic;
        lit.splat(by_tile), lit.splat(by_photon);
        EXPECT_EQ(by_tile.statistics().entries, by_photon.statistics().entries);
        Splatting tight({.entries = 1000, .entries_a_photon = 0, .binning = SplatBinning::by_photon},
                        SplatKernel::batches);
        Splatting as_tight(room_for(1000), SplatKernel::batches);
        EXPECT_EQ(lit.splat(tight), lit.splat(as_tight));
    }
}

TEST(SplatKernels, GiveTheSamePicture) {
    for (const Bandwidth bandwidth : {Bandwidth::variable, Bandwidth::fixed}) {
        Lit lit(false, bandwidth);
        for (const SplatBase base : {SplatBase::full, SplatBase::quarter, SplatBase::sixteenth}) {
            lit.bench.settings.edit<EmcSettings>().splat_base = base;
            Splatting batches({}, SplatKernel::batches), pixels({}, SplatKernel::pixels);
            const Picture picture = lit.splat(batches);
            const Picture other = lit.splat(pixels);
            EXPECT_LT(largest_difference(picture, other), 1e-3) << static_cast<int>(base);
            EXPECT_EQ(pixels.kernel(), SplatKernel::pixels);
            EXPECT_EQ(lit.splat(pixels), other) << "in every run the same";
            Splatting tight(room_for(1), SplatKernel::pixels);
            EXPECT_LT(largest_difference(other, lit.splat(tight)), 1e-5);
        }
    }
}

TEST(SplatKernels, AreChosenOnceForADevice) {
    Lit lit;
    Splatting one, other;
    lit.splat(one);
    lit.splat(other);
    ASSERT_TRUE(one.kernel() && one.binning());
    EXPECT_EQ(one.kernel(), other.kernel());
    EXPECT_EQ(one.binning(), other.binning());
    int runs = 0;
    const auto count = [&] { ++runs; };
    const bool faster = other_is_faster("nothing", count, count);
    const int measured = runs;
    EXPECT_GT(measured, 2);
    EXPECT_EQ(other_is_faster("nothing", count, count), faster);
    EXPECT_EQ(runs, measured) << "known";
}

}  // namespace
}  // namespace lanthorn::gi::test

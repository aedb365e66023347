// Direct light by photons (Jozwowski 2002, sec. 5.4): shadows without shadow maps.
#include "tests/gpu/gi/block_room.h"
#include "tests/gpu/gi/mirror_room.h"
#include "tests/gpu/gi/sensor_room.h"
#include "tests/gpu/vertex-map/vertex_map_bench.h"
#include "tests/support/closed_forms.h"

namespace lanthorn::gi::test {
namespace {

using render::Aov;

// All of a scene's photons at once, as many of them as shadows take.
struct Lamps : VertexMap {
    Lamps() {
        own().direct = true;
        own().total = own().per_frame = 200'000;
        own().nearest = 300;
    }
};

// A lamp at the centre of a sphere gives every point of it the same, which the sphere reflects evenly.
TEST(VertexMapDirect, IsTheLampsOwnInASphere) {
    constexpr float kAlbedo = 0.5f;
    for (const int levels : {1, 3}) {
        Lamps bench;
        bench.own().max_level = levels;
        const FrameScene scene = closed_sphere(kAlbedo);
        const ImageF indirect = bench.frame(scene, kSize);
        const Deviation direct = deviation_of(bench.renderer().read(Aov::direct),
                                              static_cast<double>(kSphereLux * kAlbedo) / support::kPiD);
        std::printf("vertex-map, lamps by photons of %d hits, closed sphere: mean %.4f, relRMSE %.4f\n",
                    levels, direct.mean, direct.rel_rmse);
        EXPECT_NEAR(direct.mean, 1, 0.01);
        EXPECT_LT(direct.rel_rmse, 0.1);
        EXPECT_TRUE(bench.technique().traced_lobes().lamps);
        if (levels == 1) {
            EXPECT_EQ(*std::ranges::max_element(indirect.pixels), 0);
        } else {  // the estimates tell the two apart
            EXPECT_NEAR(deviation_of(indirect, support::sphere_irradiance(kSphereLux, 1, kAlbedo, 2)).mean, 1,
                        0.02);
        }
    }
}

// What the path tracer finds, direct and indirect light together; the lamp's shadow is blurred.
TEST(VertexMapDirect, HasTheFluxThatThePathTracerFinds) {
    const FrameScene scene = room_with_block(2);
    Lamps bench;
    const Deviation by_photons = against_path(radiance_of(bench, scene, kSize, 3), scene, 2, 32);
    const ImageF blurred = bench.renderer().read(Aov::direct);
    bench.own().direct = false;
    const Deviation by_maps = against_path(radiance_of(bench, scene, kSize, 3), scene, 2, 32);
    EXPECT_FALSE(bench.technique().traced_lobes().lamps);
    const ImageF sharp = bench.renderer().read(Aov::direct);
    double in_shadow = 0, in_light = 0;
    std::size_t shadowed = 0, lit = 0;
    for (std::size_t i = 0; i < sharp.pixels.size(); ++i) {
        (sharp.pixels[i] == 0 ? in_shadow : in_light) += static_cast<double>(blurred.pixels[i]);
        ++(sharp.pixels[i] == 0 ? shadowed : lit);
    }
    in_shadow /= static_cast<double>(shadowed);
    in_light /= static_cast<double>(lit);
    std::printf(
        "vertex-map, radiance: lamps by photons flux %.4f, relRMSE %.4f; by light maps %.4f, %.4f; %zu of "
        "%zu in "
        "shadow, which has %.5f of the light beside it\n",
        by_photons.mean, by_photons.rel_rmse, by_maps.mean, by_maps.rel_rmse, shadowed, shadowed + lit,
        in_shadow / in_light);
    EXPECT_NEAR(by_photons.mean, 1, 0.02);
    EXPECT_LT(by_photons.rel_rmse, 0.1);
    EXPECT_GT(shadowed, sharp.pixels.size() / 20);
    EXPECT_LT(in_shadow, 0.01 * in_light);
}

// Mirrors show it once, and light sensors have the engine's own direct light.
TEST(VertexMapDirect, IsNotCountedTwice) {
    Lamps before, behind;
    for (Lamps* bench : {&before, &behind}) {
        bench->own().density = 0;
    }
    expect_the_view_from_behind("vertex-map, lamps by photons", before, behind, kSize);
    EXPECT_GT(before.now().mirror_rays, 10'000u);
    const FrameScene scene = lantern_room(1.9f, 1);
    Lamps with, without;
    without.own().direct = false;
    const double expected = reading_of(without, scene);
    EXPECT_NEAR(reading_of(with, scene), expected, 0.2 * expected);
}

}  // namespace
}  // namespace lanthorn::gi::test

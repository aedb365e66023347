// Mirrors under `drm`: what one shows is what a camera behind it sees, with the room's indirect light.
#include <gtest/gtest.h>

#include "gi_module/shared/rays/embree_rays.h"
#include "lanthorn/render/brdf_table.h"
#include "tests/gpu/drm/drm_bench.h"
#include "tests/gpu/gi/mirror_room.h"

namespace lanthorn::gi::test {
namespace drm_mirrors_test {

constexpr ivec2 kSize(96);

class DrmMirrorView : public ::testing::Test {
  protected:
    static void SetUpTestSuite() { add_embree_rays(); }
    static ImageF radiance(DrmBench& bench, const FrameScene& scene) {
        return radiance_of(bench, scene, kSize);
    }
};

TEST_F(DrmMirrorView, ShowsWhatACameraBehindItSees) {
    DrmBench before, behind;
    expect_the_view_from_behind("drm", before, behind, kSize);
}

// Frisvad et al. 2005, Fig. 8: without indirect light a mirror is too dark, and the trick hides some of that.
TEST_F(DrmMirrorView, WithoutIndirectLightItIsDarker) {
    const auto brightness = [](DrmMirrors shows) {
        DrmBench bench;
        bench.drm().mirrors = shows;
        return mean_of(radiance(bench, mirror_room(metal(vec3(1), 0))));
    };
    const double all = brightness(DrmMirrors::all), direct = brightness(DrmMirrors::direct),
                 trick = brightness(DrmMirrors::trick);
    std::printf("drm, mirror: direct light alone shows %.3f of the light, the trick %.3f\n", direct / all,
                trick / all);
    EXPECT_LT(direct, 0.95 * all);
    EXPECT_GT(trick, direct);
}

TEST_F(DrmMirrorView, ALampThatMovesIsSeenInItWithoutRays) {
    DrmBench kept, fresh;
    expect_a_lamp_to_be_followed(kept, fresh, kSize, [&] {
        EXPECT_EQ(
            kept.technique().statistics(false).plan.entries[static_cast<std::size_t>(DrmPass::mirrors)].size,
            "no ray");
    });
}

// Within a sphere that sends the same light from everywhere a lobe of any width reflects its share of it. The
// plate is seen edge-on from the lamp: no direct light.
TEST_F(DrmMirrorView, LobesReflectTheirShareOfEvenLight) {
    constexpr float kAlbedo = 0.6f;
    for (const float roughness : {0.35f, 0.5f, 0.7f}) {
        FrameScene scene =
            scene_of({inward_sphere(1, 4, 0), quad({0.4f, 0, 0.1f}, {0.2f, 0, 0}, {0, 0, -0.2f}, 1)},
                     {lambertian(vec3(kAlbedo)), metal(vec3(1), roughness)},
                     {point_light(vec3(0), kSphereLux)}, vec3(0.5f, 0.4f, 0.15f), vec3(0.5f, 0, 0));
        scene.camera.camera.y_fov = 0.2f;
        DrmBench bench;
        bench.settings.specular_roughness = 0;
        bench.drm().samples = 16;
        const double got = mean_of(radiance(bench, scene));
        EXPECT_TRUE(bench.technique().statistics(false).plan.on("lobes"));
        const vec2 share = render::brdf_share(std::cos(std::atan2(0.15f, 0.4f)), roughness);
        const double expected = static_cast<double>(kSphereLux * kAlbedo * (share.x + share.y)) / 3.14159265;
        std::printf("drm, lobe of roughness %g: %.3f of even light's share\n", static_cast<double>(roughness),
                    got / expected);
        EXPECT_NEAR(got / expected, 1, 0.1);
    }
}

}  // namespace drm_mirrors_test
}  // namespace lanthorn::gi::test

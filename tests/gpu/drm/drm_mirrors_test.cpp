// Mirrors under `drm`: what one shows is what a camera behind it sees, with the room's indirect light.
#include <gtest/gtest.h>

#include "lanthorn/coarse/embree_rays.h"
#include "lanthorn/render/brdf_table.h"
#include "tests/gpu/drm/drm_bench.h"

namespace lanthorn::gi::test {
namespace {

constexpr ivec2 kSize(96);

Material metal(const vec3& colour, float roughness) {
    Material m;
    m.base_colour = vec4(colour, 1);
    m.roughness = roughness;
    return m;
}

// A room with a mirror at x = 3.99, before the wall. Both are not there from behind.
FrameScene room(const Material& mirror) {
    FrameScene scene = scene_of(
        {quad({0, 0, 3}, {4, 0, 0}, {0, 0, -3}, 0), quad({0, 2.6f, 0}, {4, 0, 0}, {0, 0, 3}, 0),
         quad({0, 0, 0}, {4, 0, 0}, {0, 2.6f, 0}, 1), quad({0, 0, 3}, {0, 0, -3}, {0, 2.6f, 0}, 2),
         quad({4, 0, 3}, {-4, 0, 0}, {0, 2.6f, 0}, 0), box({0.5f, 0, 0.5f}, {1.1f, 0.9f, 1.1f}, false, 2),
         quad({4, 0, 0}, {0, 0, 3}, {0, 2.6f, 0}, 0), quad({3.99f, 0, 0}, {0, 0, 3}, {0, 2.6f, 0}, 3)},
        {lambertian(vec3(0.7f)), lambertian(vec3(0.2f, 0.3f, 0.7f)), lambertian(vec3(0.7f, 0.3f, 0.2f)),
         mirror},
        {point_light(vec3(2, 2.1f, 0.6f), 60)}, vec3(2, 1.3f, 2), vec3(4, 1, 1.2f));
    scene.camera.camera.y_fov = 0.6f;
    return scene;
}

class DrmMirrorView : public ::testing::Test {
  protected:
    static void SetUpTestSuite() { add_embree_rays(); }
    static ImageF radiance(DrmBench& bench, const FrameScene& scene) {
        bench.show(scene, kSize);
        EXPECT_EQ(bench.technique().statistics(false).nan_count, 0u);
        return bench.renderer().read(render::Aov::radiance);
    }
    static double mean(const ImageF& image) {
        double sum = 0;
        for (const float v : image.pixels) {
            sum += static_cast<double>(v);
        }
        return sum / static_cast<double>(image.pixels.size());
    }
};

TEST_F(DrmMirrorView, ShowsWhatACameraBehindItSees) {
    DrmBench before, behind;
    const ImageF shown = radiance(before, room(metal(vec3(1), 0)));
    FrameScene scene = room(metal(vec3(1), 0));
    const auto mirrored = [](const vec3& p) { return vec3(2 * 3.99f - p.x, p.y, p.z); };
    support::look(scene, mirrored({2, 1.3f, 2}), mirrored({4, 1, 1.2f}));
    const ImageF seen = radiance(behind, scene);
    double squares = 0, sum = 0;
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
            for (int c = 0; c < 3; ++c) {
                const auto a =
                    static_cast<double>(shown.pixels[static_cast<std::size_t>(3 * (y * kSize.x + x) + c)]);
                const auto b = static_cast<double>(
                    seen.pixels[static_cast<std::size_t>(3 * (y * kSize.x + kSize.x - 1 - x) + c)]);
                squares += (a - b) * (a - b);
                sum += b;
            }
        }
    }
    const double n = static_cast<double>(seen.pixels.size());
    const double error = std::sqrt(squares / n) / (sum / n);
    std::printf("drm, mirror: mean %.4f of what a camera behind it sees, relRMSE %.4f\n",
                mean(shown) / mean(seen), error);
    EXPECT_NEAR(mean(shown) / mean(seen), 1, 0.01);
    EXPECT_LT(error, 0.08);  // edges fall between other pixels
}

// Frisvad et al. 2005, Fig. 8: without indirect light a mirror is too dark, and the trick hides some of that.
TEST_F(DrmMirrorView, WithoutIndirectLightItIsDarker) {
    const auto brightness = [](DrmMirrors shows) {
        DrmBench bench;
        bench.drm().mirrors = shows;
        return mean(radiance(bench, room(metal(vec3(1), 0))));
    };
    const double all = brightness(DrmMirrors::all), direct = brightness(DrmMirrors::direct),
                 trick = brightness(DrmMirrors::trick);
    std::printf("drm, mirror: direct light alone shows %.3f of the light, the trick %.3f\n", direct / all,
                trick / all);
    EXPECT_LT(direct, 0.95 * all);
    EXPECT_GT(trick, direct);
}

TEST_F(DrmMirrorView, ALampThatMovesIsSeenInItWithoutRays) {
    DrmBench kept;
    FrameScene scene = room(metal(vec3(1), 0));
    radiance(kept, scene);
    hold_still(scene);
    scene.lights[0].position = vec3(1.2f, 1.9f, 2);
    scene.changes.lights = true;
    const ImageF followed = radiance(kept, scene);
    const GiPlan plan = kept.technique().statistics(false).plan;
    EXPECT_TRUE(plan.on("mirrors"));
    EXPECT_EQ(plan.entries[3].size, "no ray");
    FrameScene anew = room(metal(vec3(1), 0));
    anew.lights[0].position = scene.lights[0].position;
    DrmBench fresh;
    EXPECT_EQ(followed.pixels, radiance(fresh, anew).pixels);
    hold_still(scene);
    kept.show(scene, kSize);
    EXPECT_FALSE(kept.technique().statistics(false).plan.on("mirrors"));
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
        const double got = mean(radiance(bench, scene));
        EXPECT_TRUE(bench.technique().statistics(false).plan.on("lobes"));
        const vec2 share = render::brdf_share(std::cos(std::atan2(0.15f, 0.4f)), roughness);
        const double expected = static_cast<double>(kSphereLux * kAlbedo * (share.x + share.y)) / 3.14159265;
        std::printf("drm, lobe of roughness %g: %.3f of even light's share\n", static_cast<double>(roughness),
                    got / expected);
        EXPECT_NEAR(got / expected, 1, 0.1);
    }
}

}  // namespace
}  // namespace lanthorn::gi::test

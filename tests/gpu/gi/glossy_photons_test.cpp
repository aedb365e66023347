// Photons at glossy surfaces: scattered by their BSDF on the way, and shown by it in the picture, as the
// reference does.
#include <gtest/gtest.h>

#include <cmath>

#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/emc/emc_statistics.h"
#include "lanthorn/reference/path_tracer.h"
#include "lanthorn/render/brdf_table.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace {

constexpr ivec2 kSize(64);

// By the reference, everything that materials say: indirect irradiance, or radiance.
std::vector<float> by_path(const FrameScene& scene, int bounces, int spp, bool radiance) {
    reference::PathSettings settings;
    settings.transport = reference::Transport::full;
    settings.bounces = bounces;
    settings.spp = spp;
    reference::PathTracer tracer(scene, kSize, settings, {.indirect = !radiance, .radiance = radiance});
    tracer.render({});
    return tracer.image(radiance ? reference::PathAov::radiance : reference::PathAov::indirect);
}

struct Picture {
    double mean = 0;   // over the reference's
    double error = 0;  // relRMSE, of means of 2 x 2 pixels: less of it is the reference's noise
};

Picture against(const ImageF& image, const std::vector<float>& expected) {
    double sum = 0, wanted = 0, squares = 0;
    int count = 0;
    for (int y = 0; y + 1 < kSize.y; y += 2) {
        for (int x = 0; x + 1 < kSize.x; x += 2) {
            double got = 0, right = 0;
            for (int k = 0; k < 4; ++k) {
                const auto at = static_cast<std::size_t>(3 * ((y + k / 2) * kSize.x + x + k % 2));
                EXPECT_TRUE(std::isfinite(image.pixels[at]));
                got += static_cast<double>(image.pixels[at]) / 4;
                right += static_cast<double>(expected[at]) / 4;
            }
            sum += got;
            wanted += right;
            squares += (got - right) * (got - right);
            ++count;
        }
    }
    return {sum / wanted, std::sqrt(squares / count) / (wanted / count)};
}

void splats(Bench& bench, int photons, int bounces, GlossyBandwidth glossy) {
    bench.settings.bounces = bounces;
    bench.settings.photons = photons;
    bench.settings.edit<EmcSettings>().final_stage = EmcFinal::splat;
    bench.settings.edit<EmcSettings>().rays = EmcRays::maps;
    bench.settings.edit<EmcSettings>().caustic_photons = 0;
    bench.settings.edit<EmcSettings>().splat_glossy = glossy;
}

// A room of grey walls, a metal floor of that roughness, and a lamp that shines on the floor from the left:
// its lobe lies on the wall at the right.
FrameScene floor_of_metal(float roughness) {
    std::vector<Mesh> meshes{
        quad({0, 0, 3}, {4, 0, 0}, {0, 0, -3}, 1),         quad({0, 2.6f, 0}, {4, 0, 0}, {0, 0, 3}, 0),
        quad({0, 0, 0}, {4, 0, 0}, {0, 2.6f, 0}, 0),       quad({0, 0, 3}, {0, 0, -3}, {0, 2.6f, 0}, 0),
        quad({4, 0, 0}, {0, 0, 3}, {0, 2.6f, 0}, 0),       quad({4, 0, 3}, {-4, 0, 0}, {0, 2.6f, 0}, 0),
        box({2.9f, 0, 1.2f}, {3.3f, 0.6f, 1.8f}, false, 0)};
    FrameScene scene = scene_of(meshes, {lambertian(vec3(0.5f)), metal(vec3(0.9f), roughness)},
                                {spot_light(vec3(0.4f, 1.6f, 1.5f), vec3(1.5f, -1.6f, 0), 400, 0.35f)},
                                vec3(1, 1.3f, 1.5f), vec3(4, 1.1f, 1.5f));
    return scene;
}

// Before photons knew the BSDF they left metal as they leave plaster.
TEST(GlossyPhotons, MetalSendsThemWhereTheReferenceDoes) {
    for (const float roughness : {0.42f, 0.6f}) {
        const FrameScene scene = floor_of_metal(roughness);
        Bench bench;
        splats(bench, 60'000, 2, GlossyBandwidth::none);
        const ImageF seen = bench.frame(scene, kSize);
        const Picture p = against(seen, by_path(scene, 2, 256, false));
        std::printf("light by a floor of metal, roughness %.2f: flux %.4f, relRMSE %.4f\n",
                    static_cast<double>(roughness), p.mean, p.error);
        EXPECT_EQ(bench.technique().statistics(false).nan_count, 0u);
        EXPECT_NEAR(p.mean, 1, 0.05);
        EXPECT_LT(p.error, 0.22);
    }
}

// In a closed sphere of metal around a lamp every place is like every other: the mean irradiance is the
// reference's, and no bounce makes light.
TEST(GlossyPhotons, ASphereOfMetalKeepsTheReferencesEnergy) {
    for (const float roughness : {0.45f, 1.0f}) {
        FrameScene scene = scene_of({inward_sphere(1, 5, 0)}, {metal(vec3(0.9f), roughness)},
                                    {point_light(vec3(0), kSphereLux)}, vec3(0.3f, 0, 0), vec3(1, 0, 0));
        for (const int bounces : {1, 4}) {
            Bench bench;
            splats(bench, 60'000, bounces, GlossyBandwidth::none);
            bench.frame(scene, kSize);
            const PhotonStatistics photons = bench.technique().statistics(true).of<PhotonStatistics>();
            double flux = 0, wanted = 0;
            for (const dvec3& stored : photons.flux_stored) {
                flux += stored.x;
            }
            const std::vector<float> truth = by_path(scene, bounces, 16, false);
            for (const float lux : truth) {
                wanted += static_cast<double>(lux) / static_cast<double>(truth.size());
            }
            const double mean = flux / (4 * static_cast<double>(kPi)) / wanted;
            const vec2 share = render::brdf_share(1, roughness);
            const double kept = photons.flux_stored[0].x / photons.flux_emitted.x;
            std::printf(
                "sphere of metal, roughness %.2f, %d bounces: %.4f of the light; first bounce keeps %.4f, by "
                "its BRDF %.4f\n",
                static_cast<double>(roughness), bounces, mean, kept,
                static_cast<double>(0.9f * share.x + share.y));
            EXPECT_NEAR(kept, static_cast<double>(0.9f * share.x + share.y), 2e-3);
            EXPECT_NEAR(mean, 1, 0.02);
            EXPECT_LT(photons.lost, 600u);
            double before = photons.flux_emitted.x;
            for (const dvec3& flux : photons.flux_stored) {
                EXPECT_LE(flux.x, before * 1.0001);
                before = flux.x;
            }
        }
    }
}

// A plate of metal that shows a lit wall and a pillar: what photons make of it, beside the reference.
TEST(GlossyPhotons, APlateOfMetalShowsWhatThePathTracerFinds) {
    std::vector<Mesh> meshes{
        quad({0, 0, 3}, {4, 0, 0}, {0, 0, -3}, 1),         quad({0, 2.6f, 0}, {4, 0, 0}, {0, 0, 3}, 0),
        quad({0, 0, 0}, {4, 0, 0}, {0, 2.6f, 0}, 2),       quad({0, 0, 3}, {0, 0, -3}, {0, 2.6f, 0}, 0),
        quad({4, 0, 0}, {0, 0, 3}, {0, 2.6f, 0}, 0),       quad({4, 0, 3}, {-4, 0, 0}, {0, 2.6f, 0}, 0),
        box({2.2f, 0, 0.6f}, {2.5f, 1.0f, 0.9f}, false, 3)};
    // The lamp lights the wall z = 0 alone: the plate has no highlight of it.
    FrameScene scene = scene_of(meshes,
                                {lambertian(vec3(0.5f)), metal(vec3(0.8f), 0.4f),
                                 lambertian(vec3(0.7f, 0.5f, 0.3f)), lambertian(vec3(0.1f))},
                                {spot_light(vec3(2, 2.3f, 2.2f), vec3(0, -1, -2), 300, 0.4f)},
                                vec3(2, 1.4f, 2.6f), vec3(2.1f, 0, 1.1f));
    scene.camera.camera.y_fov = 0.6f;
    const std::vector<float> truth = by_path(scene, 3, 512, true);
    double errors[3] = {};
    for (const GlossyBandwidth glossy :
         {GlossyBandwidth::none, GlossyBandwidth::variable, GlossyBandwidth::fixed}) {
        Bench bench;
        splats(bench, 200'000, 3, glossy);
        bench.settings.specular_roughness = glossy == GlossyBandwidth::none ? 0.0f : 0.5f;
        bench.frame(scene, kSize);
        const Picture p = against(bench.renderer().read(render::Aov::radiance), truth);
        static constexpr const char* kNames[] = {"irradiance alone", "variable splats", "fixed splats"};
        std::printf("plate of metal, %s: flux %.4f, relRMSE %.4f\n", kNames[static_cast<int>(glossy)], p.mean,
                    p.error);
        EXPECT_EQ(bench.technique().statistics(false).nan_count, 0u);
        errors[static_cast<int>(glossy)] = p.error;
        if (glossy == GlossyBandwidth::variable) {
            EXPECT_NEAR(p.mean, 1, 0.06);
        }
    }
    EXPECT_LT(errors[1], 0.2);
    EXPECT_LT(errors[1], errors[2]);  // Fig. 8
    EXPECT_LT(errors[1], 0.3 * errors[0]);
}

}  // namespace
}  // namespace lanthorn::gi::test

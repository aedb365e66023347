#include "tests/gpu/gi/caustics_scene.h"

#include <utility>

#include "gi_module/shared/rays/embree_rays.h"

namespace lanthorn::gi::test {

GiSettings settings_of(int photons, EmcFinal final_stage, EmcRays rays) {
    GiSettings settings;
    settings.edit<EmcSettings>().final_stage = final_stage;
    settings.edit<EmcSettings>().rays = rays;
    settings.photons = 2000;
    settings.edit<EmcSettings>().caustic_photons = photons;
    settings.edit<EmcSettings>().gather_endless = false;
    if (rays == EmcRays::bvh) {
        // Caustic photons meet triangles: few and coarse maps leave them the same to the last bit, and are
        // drawn in a fraction of the time.
        settings.edit<EmcSettings>().candidates = 8;
        settings.edit<EmcSettings>().resolution = 16;
    }
    return settings;
}

GiSettings with_usual_maps(GiSettings settings) {
    const EmcSettings usual;
    settings.edit<EmcSettings>().candidates = usual.candidates;
    settings.edit<EmcSettings>().resolution = usual.resolution;
    return settings;
}

Material glass(float ior) {
    Material m;
    m.metallic = 0;
    m.roughness = 0;
    m.transmission = 1;
    m.ior = ior;
    m.thickness = 0.1f;
    return m;
}

void Caustics::SetUp() {
    add_embree_rays();
}

ImageF Caustics::caustics_of(const FrameScene& scene, int photons, EmcFinal final_stage, EmcRays rays) {
    Bench with, without;
    with.settings = settings_of(photons, final_stage, rays);
    without.settings = settings_of(0, final_stage, rays);
    ImageF image = with.frame(scene, kSize);
    const ImageF base = without.frame(scene, kSize);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        image.pixels[i] -= base.pixels[i];
    }
    return image;
}

vec3 Caustics::place(int x, int y, vec2 in_pixel) {
    return {Floor::kHalf * (1 - 2 * (static_cast<float>(x) + in_pixel.x) / kSize.x), 0,
            Floor::kHalf * (1 - 2 * (static_cast<float>(y) + in_pixel.y) / kSize.y)};
}

FrameScene room_with(std::vector<Mesh> things, std::vector<Material> materials,
                     std::vector<LightInstance> lights) {
    things.insert(things.begin(), box(vec3(-2), vec3(2), true, 0));
    materials.insert(materials.begin(), lambertian(vec3(0.5f)));
    return scene_of(things, materials, std::move(lights), vec3(1.8f, 1.7f, 1.6f), vec3(0));
}

double stored_flux(const FrameScene& scene, const GiSettings& settings, CausticStatistics* all) {
    Bench bench;
    bench.settings = settings;
    bench.frame(scene, kSize);
    const GiStatistics statistics = bench.technique().statistics(false);
    EXPECT_EQ(statistics.nan_count, 0u);
    const auto& caustics = statistics.of<CausticStatistics>();
    if (all != nullptr) {
        *all = caustics;
    }
    return caustics.flux_stored.y;
}

}  // namespace lanthorn::gi::test

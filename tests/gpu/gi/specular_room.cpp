#include "tests/gpu/gi/specular_room.h"

#include <utility>

#include "gi_module/shared/rays/embree_rays.h"

namespace lanthorn::gi::test {

Material glass(float ior, float thickness) {
    Material m;
    m.metallic = 0;
    m.roughness = 0;
    m.transmission = 1;
    m.ior = ior;
    m.thickness = thickness;
    return m;
}

FrameScene room(std::vector<Mesh> more, std::vector<Material> materials, const vec3& eye, const vec3& target,
                bool wall) {
    std::vector<Mesh> meshes{
        quad({0, 0, 3}, {4, 0, 0}, {0, 0, -3}, 0),  // floor
        quad({0, 2.6f, 0}, {4, 0, 0}, {0, 0, 3}, 0),       quad({0, 0, 0}, {4, 0, 0}, {0, 2.6f, 0}, 1),
        quad({0, 0, 3}, {0, 0, -3}, {0, 2.6f, 0}, 2),      quad({4, 0, 3}, {-4, 0, 0}, {0, 2.6f, 0}, 0),
        box({0.5f, 0, 0.5f}, {1.1f, 0.9f, 1.1f}, false, 2)};
    std::vector<Material> all{lambertian(vec3(0.7f)), lambertian(vec3(0.2f, 0.3f, 0.7f)),
                              lambertian(vec3(0.7f, 0.3f, 0.2f))};
    if (wall) {  // at x = 4
        meshes.push_back(quad({4, 0, 0}, {0, 0, 3}, {0, 2.6f, 0}, 0));
    }
    for (Mesh& mesh : more) {
        mesh.material += 3;
        meshes.push_back(std::move(mesh));
    }
    all.insert(all.end(), materials.begin(), materials.end());
    FrameScene scene =
        scene_of(std::move(meshes), std::move(all), {point_light(vec3(2, 2.1f, 0.6f), 60)}, eye, target);
    scene.camera.camera.y_fov = 0.6f;  // the lamp's own reflection is not in the picture
    return scene;
}

void Specular::SetUpTestSuite() {
    add_embree_rays();
}

GiSettings Specular::settings() const {
    GiSettings s;
    s.edit<EmcSettings>().rays = GetParam();
    // Two pictures of one room are alike as far as their lit maps are: rays have the same there, photons
    // noise.
    s.edit<EmcSettings>().gather_source = GatherSource::rays;
    s.edit<EmcSettings>().gather_points = 1;
    s.edit<EmcSettings>().gather_grid = 2;
    // A mirror's own light on the room is not what these tests are about.
    s.edit<EmcSettings>().caustic_photons = 0;
    s.edit<EmcSettings>().gather_endless = false;
    return s;
}

ImageF Specular::picture(FrameScene scene, int bounces, int grid) const {
    constexpr ivec2 size = kSize;
    Bench bench;
    bench.settings = settings();
    bench.settings.bounces = bounces;
    bench.settings.edit<EmcSettings>().specular_grid = grid;
    bench.frame(scene, size);
    hold_still(scene);
    for (int f = 1; f < 12; ++f) {
        bench.frame(scene, size);
    }
    EXPECT_EQ(bench.technique().statistics(false).nan_count, 0u);
    return bench.renderer().read(render::Aov::radiance);
}

vec3 middle_of(const ImageF& image) {
    dvec3 sum(0);
    int count = 0;
    for (int y = image.height / 4; y < 3 * image.height / 4; ++y) {
        for (int x = image.width / 4; x < 3 * image.width / 4; ++x) {
            const auto at = static_cast<std::size_t>(3 * (y * image.width + x));
            sum += dvec3(image.pixels[at], image.pixels[at + 1], image.pixels[at + 2]);
            ++count;
        }
    }
    return vec3(sum / static_cast<double>(count));
}

}  // namespace lanthorn::gi::test

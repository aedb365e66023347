// Light that a mirror sends on (light paths L S D D of Frisvad et al. 2005, sec. 4), and light sensors,
// beside the path tracer.
#include <gtest/gtest.h>

#include "engine/render/light_sensors.h"
#include "gi_module/shared/rays/embree_rays.h"
#include "lanthorn/core/colour.h"
#include "tests/gpu/drm/drm_bench.h"
#include "tests/gpu/gi/path_truth.h"

namespace lanthorn::gi::test {
namespace drm_mirrored_light_test {

constexpr ivec2 kSize(64);
constexpr float kMirror = 0.0f;  // x of its plane

// A floor and a wall, seen from beside a mirror that faces the wall.
std::vector<Mesh> floor_and_wall() {
    return {quad({0, 0, 2}, {4, 0, 0}, {0, 0, -4}, 0), quad({4, 0, -2}, {0, 0, 4}, {0, 3, 0}, 1)};
}
const std::vector<Material> kMaterials = {lambertian(vec3(0.6f)), lambertian(vec3(0.7f, 0.3f, 0.2f)),
                                          metal(vec3(1), 0)};
const vec3 kEye(0.4f, 2.4f, 1.7f), kLooksAt(3.2f, 0.6f, -0.3f);

// Lit by a spot whose whole beam the mirror sends to the wall; `turned`: the beam meets it aslant.
FrameScene mirrored(float turned) {
    std::vector<Mesh> meshes = floor_and_wall();
    meshes.push_back(quad({kMirror, 0.4f, 1.5f}, {0, 0, -3}, {0, 2.2f, 0}, 2));
    return scene_of(meshes, kMaterials, {spot_light({2, 1.5f, -2 * turned}, {-1, 0, turned}, 500, 0.2f)},
                    kEye, kLooksAt);
}

// The same light without a mirror: from the lamp's image behind it.
FrameScene from_its_image(float turned) {
    return scene_of(floor_and_wall(), kMaterials,
                    {spot_light({2 * kMirror - 2, 1.5f, -2 * turned}, {1, 0, turned}, 500, 0.2f)}, kEye,
                    kLooksAt);
}

class DrmMirroredLight : public ::testing::TestWithParam<float> {
  protected:
    static void SetUpTestSuite() { add_embree_rays(); }
};

TEST_P(DrmMirroredLight, IsThatOfTheLampsImage) {
    const Truth truth = path_traced(from_its_image(GetParam()), kSize, 1, 512);
    const auto deviation = [&](const FrameScene& scene, int side) {
        DrmBench bench;
        bench.drm().samples = side;
        bench.drm().texels = 128;
        return against(bench.frame(scene, kSize), truth);
    };
    const Deviation mirror = deviation(mirrored(GetParam()), 16),
                    image = deviation(from_its_image(GetParam()), 16);
    std::printf(
        "drm, light over a mirror, turned by %g: flux %.3f, relRMSE %.3f; from the lamp's image %.3f, %.3f\n",
        static_cast<double>(GetParam()), mirror.mean, mirror.rel_rmse, image.mean, image.rel_rmse);
    EXPECT_NEAR(mirror.mean, 1, 0.05);
    EXPECT_LT(mirror.rel_rmse, 0.15);
    EXPECT_NEAR(mirror.mean / image.mean, 1, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Turned, DrmMirroredLight, ::testing::Values(0.0f, 0.2f));

// A matt black plate in the mirror's place sends nothing on; a mirror that the beam misses lets the technique
// look for light over mirrors.
TEST(DrmMirrorsAway, ABlackPlateSendsNothingOn) {
    add_embree_rays();
    FrameScene scene = mirrored(0);
    std::vector<Material> materials = kMaterials;
    materials[2] = lambertian(vec3(0));
    materials.push_back(metal(vec3(1), 0));
    std::vector<Mesh> meshes = floor_and_wall();
    meshes.push_back(quad({kMirror, 0.4f, 1.5f}, {0, 0, -3}, {0, 2.2f, 0}, 2));
    meshes.push_back(quad({kMirror, 0.4f, -1.6f}, {0, 0, -0.4f}, {0, 2.2f, 0}, 3));
    scene = scene_of(meshes, materials, scene.lights, kEye, kLooksAt);
    DrmBench bench;
    for (const float v : bench.frame(scene, kSize).pixels) {
        EXPECT_EQ(v, 0);
    }
    EXPECT_TRUE(bench.technique().statistics(false).plan.on("mirrors"));
    EXPECT_EQ(bench.now().mirrored, 0);
}

// What the sensors of a scene read of indirect light: luminance, lux.
std::vector<double> readings(DrmBench& bench, const FrameScene& scene) {
    bench.show(scene, kSize);
    const render::LightMaps& maps = bench.renderer().light_maps();
    const auto read = [&](bool indirect) {
        render::LightSensors sensors;
        EXPECT_TRUE(sensors.wants(scene, maps, bench.technique().light_version()));
        const auto targets = sensors.measure_direct(scene, maps);
        if (indirect) {
            bench.add_irradiance(scene, targets);
        }
        sensors.send(scene.frame);
        std::vector<double> result;
        for (const render::SensorLight& light : sensors.finish()) {
            result.push_back(luminance(dvec3(light.illuminance)));
        }
        return result;
    };
    std::vector<double> all = read(true);
    const std::vector<double> direct = read(false);
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i] -= direct[i];
    }
    return all;
}

// The same by the path tracer, one bounce: the mean of a sensor's square.
double traced(FrameScene scene, const SensorInstance& sensor) {
    scene.sensors.clear();
    look_closely(scene, sensor.position + 0.3f * sensor.direction, sensor.position, sensor.radius);
    const Truth truth = path_traced(scene, ivec2(16), 1, 512);
    double sum = 0, n = 0;
    for (const auto& half : truth.halves) {
        for (std::size_t i = 0; i < half.size(); i += 3) {
            sum += luminance(dvec3(half[i], half[i + 1], half[i + 2]));
            n += 1;
        }
    }
    return sum / n;
}

TEST(DrmSensors, ReadTheRoomsIndirectLight) {
    FrameScene scene =
        scene_of({box(vec3(0), vec3(4, 2.6f, 3), true, 0)}, {lambertian(vec3(0.6f, 0.5f, 0.3f))},
                 {point_light(vec3(0.9f, 1.7f, 1.5f), 100)}, vec3(3.7f, 1.5f, 2.8f), vec3(1, 1, 1));
    scene.sensors = {{7, {2.6f, 0, 1.1f}, {0, 1, 0}, 0.05f},
                     {8, {4, 1.3f, 1.5f}, {-1, 0, 0}, 0.05f},
                     {9, {2, 2.6f, 2.2f}, {0, -1, 0}, 0.05f}};
    DrmBench bench;
    bench.drm().samples = 16;
    const std::vector<double> got = readings(bench, scene);
    ASSERT_EQ(got.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        const double want = traced(scene, scene.sensors[i]);
        std::printf("drm, sensor %zu: %.3f lux, path %.3f\n", i, got[i], want);
        EXPECT_NEAR(got[i] / want, 1, 0.05) << i;
    }
}

TEST(DrmSensors, ReadLightThatAMirrorSendsOn) {
    add_embree_rays();
    FrameScene scene = mirrored(0);
    scene.sensors = {{7, {2.5f, 0, 0.3f}, {0, 1, 0}, 0.05f}};
    DrmBench bench;
    bench.drm().samples = 16;
    bench.drm().texels = 128;
    const double got = readings(bench, scene).at(0), want = traced(from_its_image(0), scene.sensors[0]);
    std::printf("drm, sensor, light over a mirror: %.3f lux, path %.3f\n", got, want);
    EXPECT_NEAR(got / want, 1, 0.05);
    EXPECT_GT(want, 0.1);
}

}  // namespace drm_mirrored_light_test
}  // namespace lanthorn::gi::test

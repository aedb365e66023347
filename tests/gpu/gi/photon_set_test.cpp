// Photons are used whoever has traced them: a PhotonSet is all that splats and sensors ask for.
#include "gi_module/techniques/emc/photons/photon_set.h"

#include <gtest/gtest.h>

#include "gi_module/techniques/emc/emc_technique.h"
#include "gi_module/techniques/emc/photons/sensor_photons.h"
#include "gi_module/techniques/emc/splat/splatting.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace {

constexpr std::uint32_t kUp = 0;  // octahedral: +Z

PhotonSet set_of(const std::vector<PhotonHit>& hits, std::uint32_t count, float h_max) {
    PhotonSet photons;
    photons.allocate(static_cast<int>(hits.size()));
    photons.hits.write(0, std::span<const PhotonHit>(hits));
    photons.count.write(0, std::span<const std::uint32_t>(&count, 1));
    photons.h_max = h_max;
    return photons;
}

TEST(PhotonSet, OfAnotherSourceGivesTheSamePicture) {
    const FrameScene scene =
        scene_of({box(vec3(0), vec3(4, 2.6f, 4), true, 0)}, {lambertian(vec3(0.6f))},
                 {point_light(vec3(2, 2, 2), 100)}, vec3(3.6f, 1.6f, 3.6f), vec3(1, 0.8f, 1));
    Bench bench;
    bench.settings.photons = 3000;
    bench.frame(scene, ivec2(64));
    const auto& technique = static_cast<const EmcTechnique&>(bench.technique());
    const PhotonSet& traced = technique.photons().arrived();
    std::vector<PhotonHit> hits = traced.read();
    const auto count = static_cast<std::uint32_t>(hits.size());
    PhotonHit glaring = hits.front();
    glaring.radius = traced.h_max;
    glaring.power = vec3(1e6f);
    hits.insert(hits.end(), 500, glaring);  // beyond those that are there

    const PhotonSet other = set_of(hits, count, traced.h_max);
    EXPECT_EQ(other.read().size(), count);
    const ecs::World& world = bench.app.world();
    const Renderer& renderer = world.resource<Renderer>();
    Splatting splatting;
    const gpu::Buffer bad_values(sizeof(std::uint32_t));
    const std::vector<float> picture =
        splatting
            .irradiance(renderer.frame->inputs(world.resource<FrameScene>(), *renderer.timer),
                        technique.maps(), other, bench.settings, true, bad_values)
            .read_floats(4);
    EXPECT_EQ(picture, world.resource<render::IndirectLight>().irradiance->read_floats(4));
    EXPECT_EQ(bad_values.read<std::uint32_t>(1).front(), 0u);
}

TEST(PhotonSet, SensorsCountWhatIsThere) {
    context();
    render::SensorData disc{};
    disc.radius = 0.5f;
    disc.normal = vec3(0, 0, 1);
    const gpu::Buffer sensors = gpu::Buffer::from(std::vector{disc});
    const gpu::Buffer irradiances(sizeof(vec4));
    const PhotonHit on{vec3(0.1f, 0.2f, 0), 0.1f, vec3(1, 2, 3), kUp};
    const PhotonHit beside{vec3(0.6f, 0, 0), 0.1f, vec3(1), kUp};
    const PhotonHit none{vec3(0), 0, vec3(1), kUp};
    SensorPhotons().add(set_of({on, beside, none, on, on}, 4, 0.1f), {sensors, irradiances, 1});
    const vec4 lux = irradiances.read<vec4>(1).front();
    const float area = kPi * 0.25f;
    EXPECT_NEAR(lux.r, 2 / area, 1e-5f);
    EXPECT_NEAR(lux.g, 4 / area, 1e-5f);
    EXPECT_NEAR(lux.b, 6 / area, 1e-5f);
}

TEST(PhotonSet, WithoutRoomIsEmpty) {
    EXPECT_TRUE(PhotonSet().read().empty());
}

}  // namespace
}  // namespace lanthorn::gi::test

#include "tests/gpu/gi/sensor_room.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/colour.h"
#include "lanthorn/reference/path_tracer.h"
#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/light_sensor.h"
#include "lanthorn/scene/transforms.h"
#include "tests/support/repository.h"

namespace lanthorn::gi::test {

std::vector<render::SensorLight> measured(const FrameScene& scene, Bench& bench,
                                          render::LightSensors& sensors) {
    bench.frame(scene, kSensorPicture);
    const render::LightMaps& light_maps = bench.renderer().light_maps();
    if (sensors.wants(scene, light_maps, scene.frame)) {
        bench.add_irradiance(scene, sensors.measure_direct(scene, light_maps));
        sensors.send(scene.frame);
    }
    return sensors.finish();
}

FrameScene lantern_room(float angle, float radius) {
    ecs::World world;
    spawn(world, import_gltf(support::repository_file("assets/lantern-room.glb")));
    Transform& door = world.get_mut<LocalTransform>(find_by_name(world, "door")).value;
    door.rotation = glm::angleAxis(angle, vec3(0, 1, 0)) * door.rotation;
    const ecs::Entity sensor = find_by_name(world, "far_sensor");
    world.insert(sensor, LightSensor{.radius = radius});
    Transforms().update(world);
    return Extractor().extract(world);
}

double sensor_truth(FrameScene scene) {
    const SensorInstance& sensor = scene.sensors.at(0);
    look_closely(scene, sensor.position + 0.3f * sensor.direction, sensor.position, sensor.radius);
    constexpr int kSide = 48;
    reference::PathSettings settings;
    settings.spp = 256;
    settings.bounces = GiSettings().bounces;
    reference::PathTracer tracer(scene, ivec2(kSide), settings, {.indirect = true});
    tracer.render({});
    const std::vector<float> image = tracer.image(reference::PathAov::indirect);
    double sum = 0;
    int count = 0;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const vec2 p = (vec2(x, y) + 0.5f) * (2.0f / kSide) - 1.0f;
            const std::size_t at = 3 * static_cast<std::size_t>(y * kSide + x);
            if (glm::dot(p, p) < 1) {
                sum += 0.2126 * double(image[at]) + 0.7152 * double(image[at + 1]) +
                       0.0722 * double(image[at + 2]);
                ++count;
            }
        }
    }
    EXPECT_GT(sum / count, 0.5);
    return sum / count;
}

double reading_of(Bench& bench, const FrameScene& scene) {
    render::LightSensors sensors;
    const auto samples = measured(scene, bench, sensors);
    EXPECT_EQ(samples.size(), 1u);
    return samples.empty() ? 0 : luminance(dvec3(samples[0].illuminance));
}

void expect_the_colour_of_bounced_light(Bench& bench, double tolerance, int bounces) {
    constexpr float kRadius = 0.2f, kHeight = 0.97f;
    const vec3 red(0.8f, 0.2f, 0.1f);
    FrameScene scene = scene_of({inward_sphere(1, 4, 0)}, {lambertian(red)},
                                {point_light(vec3(0), kSphereLux)}, {0, 0, 0.5f}, {0, 0, -1});
    scene.sensors = {{7, {0, -kHeight, 0}, {0, 1, 0}, kRadius}};
    bench.settings.bounces = bounces;
    render::LightSensors sensors;
    const auto samples = measured(scene, bench, sensors);
    ASSERT_EQ(samples.size(), 1u);
    const float direct = 2 * kSphereLux / (kRadius * kRadius) * (1 - kHeight / std::hypot(kHeight, kRadius));
    for (int c = 0; c < 3; ++c) {
        float expected = direct;
        for (int b = 1; b <= bounces; ++b) {
            expected += kSphereLux * std::pow(red[c], static_cast<float>(b));
        }
        EXPECT_NEAR(samples[0].illuminance[c] / expected, 1, tolerance) << c;
    }
}

void expect_other_light_to_be_told(Bench& bench, Bench& fresh) {
    FrameScene scene = lantern_room(1.9f, 1);
    bench.frame(scene, kSensorPicture);
    const std::uint64_t before = bench.technique().light_version();
    hold_still(scene);
    bench.frame(scene, kSensorPicture);
    EXPECT_EQ(bench.technique().light_version(), before);
    scene.lights[0].light.intensity *= 2;
    scene.changes.lights = true;
    bench.frame(scene, kSensorPicture);
    EXPECT_GT(bench.technique().light_version(), before);
    FrameScene hanging = lantern_room(1.9f, 1);
    hanging.sensors[0].position += 0.5f * hanging.sensors[0].radius * hanging.sensors[0].direction;
    Bench none(TechniqueKind::none);
    EXPECT_EQ(reading_of(fresh, hanging), reading_of(none, hanging));
}

}  // namespace lanthorn::gi::test

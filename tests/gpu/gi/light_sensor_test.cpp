// Light sensors against what is known: direct light by formula, indirect light by the path tracer.
#include "engine/render/light_sensors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/runtime/sensor_plugin.h"
#include "lanthorn/scene/light_sensor.h"
#include "lanthorn/scene/spawn.h"
#include "tests/gpu/gi/sensor_room.h"

namespace lanthorn::gi::test {
namespace {

// A floor of 4 m x 4 m with a point light of 100 cd 2 m above its middle.
FrameScene floor_under_a_lamp() {
    return scene_of({quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, 0)}, {lambertian(vec3(0.5f))},
                    {point_light({0, 2, 0}, 100)}, {0, 1, 3}, vec3(0));
}

TEST(LightSensor, ReadsTheDirectLightOnItsDisc) {
    FrameScene scene = floor_under_a_lamp();
    scene.sensors = {{7, {0, 0, 0}, {0, 1, 0}, 0.01f},
                     {8, {1, 0, 0}, {0, 1, 0}, 0.01f},
                     {9, {0, 0, 0}, {0, 1, 0}, 1},
                     {10, {0, 0, 0}, {0, -1, 0}, 0.1f}};
    Bench bench(TechniqueKind::none);
    render::LightSensors sensors;
    const auto samples = measured(scene, bench, sensors);
    ASSERT_EQ(samples.size(), 4u);
    EXPECT_EQ(samples[1].id, 8u);
    // E = I h / (h^2 + x^2)^(3/2); its mean over a disc of radius 1 is 2 I (1 - h / sqrt(h^2 + 1)).
    EXPECT_NEAR(samples[0].illuminance.g, 25, 0.05);
    EXPECT_NEAR(samples[1].illuminance.g, 100 * 2 / std::pow(5, 1.5), 0.05);
    EXPECT_NEAR(samples[2].illuminance.g, 200 * (1 - 2 / std::sqrt(5)), 0.1);
    EXPECT_EQ(samples[3].illuminance, vec3(0));  // looks down
}

TEST(LightSensor, ReadsThroughTheFilterThatItsFrameHad) {
    FrameScene scene = floor_under_a_lamp();
    scene.sensors = {{7, {0, 0, 0}, {0, 1, 0}, 0.01f}, {8, {0, 0, 0}, {0, 1, 0}, 0.01f, {1, -2, 0.5f}}};
    Bench bench(TechniqueKind::none);
    render::LightSensors sensors;
    bench.frame(scene, kSensorPicture);
    const render::LightMaps& light_maps = bench.renderer().light_maps();
    ASSERT_TRUE(sensors.wants(scene, light_maps, 0));
    sensors.measure_direct(scene, light_maps);
    sensors.send(scene.frame);
    scene.sensors[1].filter = vec3(1);  // under way is what was
    sensors.wants(scene, light_maps, 0);
    const auto samples = sensors.finish();
    ASSERT_EQ(samples.size(), 2u);
    EXPECT_NEAR(samples[0].reading, 25, 0.05);
    EXPECT_NEAR(samples[1].reading, -12.5, 0.05);
}

TEST(LightSensor, MeasuresAnewOnlyWhenSomethingChanged) {
    FrameScene scene = floor_under_a_lamp();
    scene.sensors = {{7, {0, 0, 0}, {0, 1, 0}, 0.1f}};
    Bench bench(TechniqueKind::none);
    render::LightSensors sensors;
    bench.frame(scene, kSensorPicture);
    const render::LightMaps& light_maps = bench.renderer().light_maps();
    const auto measure = [&] {
        const bool wants = sensors.wants(scene, light_maps, 0);
        if (wants) {
            sensors.measure_direct(scene, light_maps);
            sensors.send(scene.frame);
        }
        return wants;
    };
    EXPECT_TRUE(measure());
    for (int i = 0; i < 2 * render::LightSensors::kInterval; ++i) {
        EXPECT_FALSE(measure()) << i;
    }
    EXPECT_EQ(sensors.finish().size(), 1u);
    scene.sensors[0].position.x = 1;
    EXPECT_TRUE(measure());
    scene.sensors[0].position.x = 0;
    for (int i = 1; i < render::LightSensors::kInterval; ++i) {
        EXPECT_FALSE(measure()) << i;  // not in every frame
    }
    EXPECT_TRUE(measure());
    EXPECT_EQ(sensors.finish().size(), 2u);
}

// 30 to 40 of the default 20 000 photons land on the disc: a sixth of noise. Ten times the photons: a
// twentieth.
TEST(LightSensor, ReadsTheIndirectLightThatThePathTracerFinds) {
    const FrameScene scene = lantern_room(1.9f, 1);
    const double expected = sensor_truth(scene);
    EXPECT_GT(expected, 0.5);
    Bench bench;
    const auto reading = [&](int photons, std::uint32_t seed) {
        bench.settings.photons = photons;
        bench.settings.seed = seed;
        return reading_of(bench, scene);
    };
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
        EXPECT_NEAR(reading(GiSettings().photons, seed), expected, 0.5 * expected) << seed;
        EXPECT_NEAR(reading(10 * GiSettings().photons, seed), expected, 0.15 * expected) << seed;
    }
}

TEST(LightSensor, SeesTheColourOfBouncedLight) {
    Bench bench;
    bench.settings.photons = 10 * GiSettings().photons;
    expect_the_colour_of_bounced_light(bench, 0.05);
}

// The lantern room lit by the gather, where sensors alone count photons, and `passes` of a still picture.
struct GatheredRoom {
    explicit GatheredRoom(int passes = 1) {
        bench.settings.edit<EmcSettings>().final_stage = EmcFinal::gather;
        bench.settings.edit<EmcSettings>().gather_source = GatherSource::rays;  // sensors alone count photons
        bench.settings.accumulate = passes;
    }
    void show() {
        bench.show(scene, kSensorPicture, true);
        hold_still(scene);
    }
    bool on(std::string_view pass) { return bench.technique().statistics(false).plan.on(pass); }
    // Until all rays of the picture are in.
    void show_all() {
        show();
        for (int i = 0; i < 200 && on("gather"); ++i) {
            show();
        }
        ASSERT_FALSE(on("gather"));
    }
    void brighten() {
        scene.lights[0].light.intensity *= 2;
        scene.changes.lights = true;
    }
    // Of the last frame.
    vec3 reading() {
        render::LightSensors sensors;
        const render::LightMaps& light_maps = bench.renderer().light_maps();
        EXPECT_TRUE(sensors.wants(scene, light_maps, 0));
        bench.add_irradiance(scene, sensors.measure_direct(scene, light_maps));
        sensors.send(scene.frame);
        const auto samples = sensors.finish();
        EXPECT_EQ(samples.size(), 1u);
        return samples.empty() ? vec3(0) : samples[0].illuminance;
    }

    Bench bench;
    FrameScene scene = lantern_room(1.9f, 1);
};

bool emits(const std::vector<gpu::PassTimer::Span>& spans) {
    return std::ranges::any_of(spans, [](const auto& span) { return span.name == "emission"; });
}

TEST(LightSensor, ThatComesIntoAStillViewIsNewLightOnce) {
    GatheredRoom room;
    const std::vector<SensorInstance> sensors = std::exchange(room.scene.sensors, {});
    room.show_all();
    const auto expect_one_change = [&] {
        const std::uint64_t before = room.bench.technique().light_version();
        room.show();
        const std::uint64_t after = room.bench.technique().light_version();
        EXPECT_GT(after, before);
        for (int i = 0; i < 3; ++i) {
            room.show();
            EXPECT_EQ(room.bench.technique().light_version(), after);
            EXPECT_FALSE(room.on("emission"));
        }
    };
    room.scene.sensors = sensors;
    expect_one_change();
    room.bench.settings.photons *= 2;
    expect_one_change();
}

TEST(LightSensor, ReadsTheSameInWhicheverFrameAfterAChange) {
    GatheredRoom early(4), late(4);
    for (GatheredRoom* room : {&early, &late}) {
        room->show_all();
        room->brighten();
        room->show();
    }
    late.show_all();
    late.show();
    EXPECT_TRUE(late.on("accumulation"));  // a later pass of the picture
    const vec3 reading = early.reading();
    EXPECT_GT(reading.g, 0.5f);
    EXPECT_EQ(reading, late.reading());
}

TEST(LightSensor, HasItsPhotonsTracedWhenItIsReadAndAnewInOtherLight) {
    GatheredRoom room;
    room.show();
    const vec3 before = room.reading();
    for (int frame = 1; frame <= 4; ++frame) {
        if (frame == 1) {
            room.bench.app.world().resource<Renderer>().timer->end_frame();
            room.brighten();
        }
        room.show();
        EXPECT_FALSE(emits(room.bench.spans)) << frame;
    }
    const vec3 after = room.reading();
    EXPECT_TRUE(emits(room.bench.app.world().resource<Renderer>().timer->end_frame()));
    GatheredRoom fresh;
    fresh.brighten();
    fresh.show();
    EXPECT_EQ(after, fresh.reading());
    EXPECT_GT(after.g, 1.5f * before.g);
}

// What a sensor with `filter` reads, in a game, 1 m below a lamp of 100 cd of that colour.
double reading_in_a_game(const vec3& lamp, const vec3& filter) {
    SceneData scene;
    scene.materials = {lambertian(vec3(0))};
    scene.meshes = {quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, 0)};
    scene.lights = {{.colour = lamp, .intensity = 100}};
    scene.cameras = {{}};
    scene.nodes.resize(4);
    scene.nodes[0].meshes = {0};
    scene.nodes[1].light = 0;
    scene.nodes[1].local.translation = {0, 1, 0};
    scene.nodes[2].camera = 0;
    scene.nodes[2].local.translation = {0, 1, 3};
    scene.nodes[3].name = "sensor";
    scene.nodes[3].local.rotation = glm::angleAxis(0.5f * kPi, vec3(1, 0, 0));  // its -Z looks up
    scene.nodes[3].extras = R"({"light_sensor":{"radius":0.05}})";
    context();
    App app;
    add_scene_plugins(app);
    app.add<SensorPlugin>();
    spawn_scene(app, scene);
    const ecs::Entity sensor = find_by_name(app.world(), "sensor");
    app.world().get_mut<LightSensor>(sensor).filter = filter;
    app.add<RenderPlugin>(false).add<GiPlugin>();
    app.view().size = kSensorPicture;
    for (int i = 0; i < 20 && app.world().get<LightSensor>(sensor).readings == 0; ++i) {
        app.step();
        app.show();
        glFinish();
    }
    EXPECT_GT(app.world().get<LightSensor>(sensor).readings, 0u);
    return static_cast<double>(app.world().get<LightSensor>(sensor).lux);
}

// Walls of reflectance a send E (a + a^2) of the E that a lamp in the middle of the sphere gives them. The
// game's own systems read the sensor, and once more when the lamp is brighter.
TEST(LightSensor, OfAGameReadsBouncedLightAndFollowsTheLamp) {
    constexpr float kRadius = 0.2f, kHeight = 0.97f, kAlbedo = 0.7f;
    SceneData scene;
    scene.materials = {lambertian(vec3(kAlbedo))};
    scene.meshes = {inward_sphere(1, 4, 0)};
    scene.lights = {{.intensity = kSphereLux}};
    scene.cameras = {{}};
    scene.nodes.resize(4);
    scene.nodes[0].meshes = {0};
    scene.nodes[1].light = 0;
    scene.nodes[1].name = "lamp";
    scene.nodes[2].camera = 0;
    scene.nodes[2].local.translation = {0, 0, 0.5f};
    scene.nodes[3].name = "sensor";
    scene.nodes[3].local.translation = {0, -kHeight, 0};
    scene.nodes[3].local.rotation = glm::angleAxis(0.5f * kPi, vec3(1, 0, 0));  // its -Z looks up
    scene.nodes[3].extras = R"({"light_sensor":{"radius":0.2}})";
    context();
    App app;
    add_scene_plugins(app);
    app.add<SensorPlugin>();
    spawn_scene(app, scene);
    app.add<RenderPlugin>(false).add<GiPlugin>();
    GiSettings settings;
    settings.photons *= 10;
    app.world().insert_resource(settings);
    app.view().size = kSensorPicture;
    const ecs::Entity sensor = find_by_name(app.world(), "sensor");
    const auto expect_a_reading_of = [&](float lux) {
        for (int i = 0; i < 4 * render::LightSensors::kInterval; ++i) {
            app.step();
            app.show();
            glFinish();
        }
        const float direct = 2 * lux / (kRadius * kRadius) * (1 - kHeight / std::hypot(kHeight, kRadius));
        const float expected = direct + lux * kAlbedo * (1 + kAlbedo);
        EXPECT_NEAR(app.world().get<LightSensor>(sensor).lux / expected, 1, 0.03);
    };
    expect_a_reading_of(kSphereLux);
    app.world().get_mut<LightComponent>(find_by_name(app.world(), "lamp")).light.intensity *= 2;
    expect_a_reading_of(2 * kSphereLux);
}

TEST(LightSensor, ReadsThroughItsFilter) {
    const vec3 red(1, 0, 0), white(1), but_not_white(1, -1.2f, -1.2f);
    EXPECT_NEAR(reading_in_a_game(white, LightSensor().filter), 100, 1);
    EXPECT_NEAR(reading_in_a_game(red, LightSensor().filter), 21.26, 0.3);
    EXPECT_NEAR(reading_in_a_game(red, but_not_white), 100, 1);
    EXPECT_NEAR(reading_in_a_game(white, but_not_white), -140, 2);
}

}  // namespace
}  // namespace lanthorn::gi::test

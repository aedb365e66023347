// Light sensors where light comes by mirrors and through glass alone, against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "engine/render/light_sensors.h"
#include "gi_module/shared/rays/embree_rays.h"
#include "lanthorn/emc/emc_settings.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace {

constexpr ivec2 kPicture(16, 12);
constexpr std::uint32_t kFloor = 0, kThing = 1;  // materials

// Dark: what it sends back into mirrors and glass is no part of the closed forms.
Mesh dark_floor() {
    return quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, kFloor);
}

GiSettings settings_of(int caustic_photons, EmcFinal final_stage = EmcFinal::gather) {
    GiSettings settings;
    settings.edit<EmcSettings>().final_stage = final_stage;
    settings.edit<EmcSettings>().rays = EmcRays::bvh;
    settings.photons = 2000;
    settings.edit<EmcSettings>().caustic_photons = caustic_photons;
    return settings;
}

// What the one sensor of `scene` reads after its first frame, by channel.
vec3 reading(const FrameScene& scene, Bench& bench) {
    bench.show(scene, kPicture);
    const render::LightMaps& light_maps = bench.renderer().light_maps();
    render::LightSensors sensors;
    EXPECT_TRUE(sensors.wants(scene, light_maps, bench.technique().light_version()));
    bench.add_irradiance(scene, sensors.measure_direct(scene, light_maps));
    sensors.send(scene.frame);
    const auto samples = sensors.finish();
    EXPECT_EQ(samples.size(), 1u);
    return samples.empty() ? vec3(0) : samples[0].illuminance;
}

// Mean of `lux` over a disc on the floor.
dvec3 mean_over(const SensorInstance& disc, const std::function<dvec3(const dvec3&)>& lux) {
    constexpr int kPoints = 1024;
    dvec3 sum(0);
    for (int i = 0; i < kPoints; ++i) {
        const double r = double(disc.radius) * std::sqrt((i + 0.5) / kPoints), angle = 2.39996323 * i;
        sum += lux(dvec3(disc.position) + r * dvec3(std::cos(angle), 0, std::sin(angle)));
    }
    return sum / double(kPoints);
}

class LightSensorCaustics : public testing::Test {
  protected:
    void SetUp() override { add_embree_rays(); }
};

constexpr float kCandela = 1000;
const vec3 kMirrorAt(0.9f, 0.4f, 0);

// A spot lamp above the sensor that shines at an upright mirror alone, which is turned about its vertical
// axis by `angle`, radians: at 0 it sends the beam to the sensor.
FrameScene spot_and_mirror(float angle) {
    const vec3 across(0.8f * std::sin(angle), 0, 0.8f * std::cos(angle)), up(0, 0.6f, 0);
    Material mirror = lambertian(vec3(1));
    mirror.metallic = 1;
    mirror.roughness = 0;
    const vec3 lamp(0, 0.8f, 0);
    FrameScene scene =
        scene_of({dark_floor(), quad(kMirrorAt - 0.5f * (across + up), across, up, kThing)},
                 {lambertian(vec3(0.02f)), mirror},
                 {support::spot_light(lamp, kMirrorAt - lamp, kCandela, 0.3f, 0.35f)}, {0, 1, 3}, vec3(0));
    scene.sensors = {{7, {0, 0, 0}, {0, 1, 0}, 0.1f}};
    return scene;
}

// The mirror is an image source. Of the default 40 000 caustic photons some 260 land on the disc.
TEST_F(LightSensorCaustics, ReadWhatAMirrorSendsThem) {
    const FrameScene scene = spot_and_mirror(0);
    const dvec3 image(1.8, 0.8, 0);
    const double expected = mean_over(scene.sensors[0], [&](const dvec3& p) {
                                const double r = glm::distance(p, image);
                                return dvec3(double(kCandela) * image.y / (r * r * r));
                            }).y;
    for (const EmcFinal final_stage : {EmcFinal::gather, EmcFinal::splat}) {
        Bench bench;
        bench.settings = settings_of(EmcSettings().caustic_photons, final_stage);
        const double few = double(reading(scene, bench).g) / expected;
        bench.settings.edit<EmcSettings>().caustic_photons *= 10;
        const double many = double(reading(scene, bench).g) / expected;
        std::printf("mirror: %.4f of the image source's light, %.4f with ten times the photons\n", few, many);
        EXPECT_NEAR(few, 1, 0.1);
        EXPECT_NEAR(many, 1, 0.02);
    }
}

TEST_F(LightSensorCaustics, ReadNothingOfAMirrorThatIsTurnedAway) {
    Bench bench;
    bench.settings = settings_of(EmcSettings().caustic_photons);
    EXPECT_LT(reading(spot_and_mirror(0.5f), bench).g, 0.5f);  // 105 lux at 0
}

// A convex polygon, seen from the side on which it is counter-clockwise.
void add_face(Mesh& mesh, const std::vector<vec3>& ring) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const vec3 normal = glm::normalize(glm::cross(ring[1] - ring[0], ring[2] - ring[0]));
    for (const vec3& p : ring) {
        Vertex vertex;
        vertex.position = p;
        vertex.normal = normal;
        mesh.vertices.push_back(vertex);
        mesh.bounds.add(p);
    }
    for (std::uint32_t i = 2; i < ring.size(); ++i) {
        mesh.indices.insert(mesh.indices.end(), {first, first + i - 1, first + i});
    }
}

// A wedge of glass above the sensor, its upper side level, in light that falls straight down: it is bent
// once, where it leaves. Its shadow hides the lamp from the sensor.
TEST_F(LightSensorCaustics, ReadWhatAPrismSendsThem) {
    constexpr float kHalf = 0.3f, kTop = 0.6f, kThin = 0.05f;
    constexpr double kIndex = 1.5, kSlope = 0.35;  // radians
    const dvec3 left(0.2, 0.8, 0.5);               // of light after 0.2 m of glass
    const auto thickness = [&](double x) { return double(kThin) + (x + double(kHalf)) * std::tan(kSlope); };

    Mesh wedge;
    wedge.material = kThing;
    const float thick = static_cast<float>(thickness(double(kHalf)));
    const auto corner = [&](float x, float z, bool top) {
        return vec3(x, top ? kTop : kTop - (x < 0 ? kThin : thick), z);
    };
    constexpr float h = kHalf;
    add_face(wedge, {corner(-h, h, true), corner(h, h, true), corner(h, -h, true), corner(-h, -h, true)});
    add_face(wedge, {corner(-h, -h, false), corner(h, -h, false), corner(h, h, false), corner(-h, h, false)});
    add_face(wedge, {corner(-h, h, false), corner(h, h, false), corner(h, h, true), corner(-h, h, true)});
    add_face(wedge, {corner(h, -h, false), corner(-h, -h, false), corner(-h, -h, true), corner(h, -h, true)});
    add_face(wedge, {corner(h, h, false), corner(h, -h, false), corner(h, -h, true), corner(h, h, true)});
    add_face(wedge, {corner(-h, -h, false), corner(-h, h, false), corner(-h, h, true), corner(-h, -h, true)});

    Material glass = lambertian(vec3(1));
    glass.specular = 1;
    glass.roughness = 0;
    glass.transmission = 1;
    glass.ior = static_cast<float>(kIndex);
    glass.thickness = 0.1f;
    glass.attenuation_colour = vec3(left);
    glass.attenuation_distance = 0.2f;

    // Snell and Fresnel at both sides.
    const double out = std::asin(kIndex * std::sin(kSlope)), bend = out - kSlope;
    const double rs = std::sin(kSlope - out) / std::sin(kSlope + out);
    const double rp = std::tan(kSlope - out) / std::tan(kSlope + out);
    const double through = (1 - std::pow((kIndex - 1) / (kIndex + 1), 2)) * (1 - 0.5 * (rs * rs + rp * rp));
    const auto lands = [&](double x) { return x + (double(kTop) - thickness(x)) * std::tan(bend); };
    const double spread = lands(1) - lands(0);

    FrameScene scene = scene_of({dark_floor(), wedge}, {lambertian(vec3(0.02f)), glass},
                                {support::directional_light({0, -1, 0}, 100)}, {0, 1, 3}, vec3(0));
    scene.sensors = {{7, {static_cast<float>(lands(0)), 0, 0}, {0, 1, 0}, 0.08f}};
    const dvec3 expected = mean_over(scene.sensors[0], [&](const dvec3& p) {
        const double metres = thickness((p.x - lands(0)) / spread);
        return 100 * through / spread * glm::pow(left, dvec3(metres / 0.2));
    });
    for (const std::uint32_t seed : {1u, 2u}) {
        Bench bench;
        bench.settings = settings_of(EmcSettings().caustic_photons);
        bench.settings.seed = seed;
        const dvec3 share = dvec3(reading(scene, bench)) / expected;
        std::printf("prism: %.4f %.4f %.4f of Snell's, Fresnel's and Beer's light\n", share.r, share.g,
                    share.b);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(share[c], 1, 0.05) << c;
        }
    }
}

// Sensors are measured anew when the caustics alone are others.
TEST_F(LightSensorCaustics, AreNewLightForThem) {
    FrameScene scene = spot_and_mirror(0);
    Bench bench;
    bench.settings = settings_of(1000);
    bench.show(scene, kPicture);
    hold_still(scene);
    bench.show(scene, kPicture);
    const std::uint64_t before = bench.technique().light_version();
    bench.show(scene, kPicture);
    EXPECT_EQ(bench.technique().light_version(), before);
    bench.settings.edit<EmcSettings>().caustic_photons = 2000;
    bench.show(scene, kPicture);
    const std::uint64_t more = bench.technique().light_version();
    EXPECT_GT(more, before);
    bench.settings.edit<EmcSettings>().caustic_photons = 0;
    bench.show(scene, kPicture);
    EXPECT_GT(bench.technique().light_version(), more);
}

}  // namespace
}  // namespace lanthorn::gi::test

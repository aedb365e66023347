// Caustic photons against closed forms: a plane mirror is an image source, a sphere a solid angle.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gi_module/shared/rays/embree_rays.h"
#include "gi_module/techniques/emc/emc_technique.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/reference/path_tracer.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace {

constexpr ivec2 kSize(96);

// Light on a floor y = 0 of 2 m x 2 m about the origin, seen straight from above, by caustics alone: what the
// picture holds more than without them.
struct Floor {
    static constexpr float kHalf = 1;
    std::vector<Mesh> meshes{quad(vec3(-kHalf, 0, -kHalf), vec3(0, 0, 2 * kHalf), vec3(2 * kHalf, 0, 0), 0)};
    // Dark: what it sends back into mirrors and glass is no part of the closed forms.
    std::vector<Material> materials{lambertian(vec3(0.02f))};
    std::vector<LightInstance> lights;

    FrameScene scene() const {
        FrameScene scene = scene_of(meshes, materials, lights, vec3(0, 1.5f, 0), vec3(0));
        look_closely(scene, vec3(0, 0.5f, 0), vec3(0), kHalf);
        return scene;
    }
};

GiSettings settings_of(int photons, EmcFinal final_stage = EmcFinal::gather, EmcRays rays = EmcRays::bvh) {
    GiSettings settings;
    settings.edit<EmcSettings>().final_stage = final_stage;
    settings.edit<EmcSettings>().rays = rays;
    settings.photons = 2000;
    settings.edit<EmcSettings>().caustic_photons = photons;
    settings.edit<EmcSettings>().gather_endless = false;
    return settings;
}

class Caustics : public testing::Test {
  protected:
    void SetUp() override { add_embree_rays(); }

    static ImageF caustics_of(const FrameScene& scene, int photons, EmcFinal final_stage = EmcFinal::gather,
                              EmcRays rays = EmcRays::bvh) {
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

    // Where a place in a pixel lies on the floor.
    static vec3 place(int x, int y, vec2 in_pixel = vec2(0.5f)) {
        return {Floor::kHalf * (1 - 2 * (static_cast<float>(x) + in_pixel.x) / kSize.x), 0,
                Floor::kHalf * (1 - 2 * (static_cast<float>(y) + in_pixel.y) / kSize.y)};
    }
};

TEST_F(Caustics, APlaneMirrorIsAnImageSource) {
    // An upright mirror at x = 0.9, its front towards -x; the lamp's image stands behind it.
    Floor floor;
    floor.meshes.push_back(quad(vec3(0.9f, 0.1f, -0.3f), vec3(0, 0, 0.6f), vec3(0, 0.3f, 0), 1));
    floor.materials.push_back(metal(vec3(1), 0));
    const vec3 lamp(0.4f, 0.8f, 0);
    const vec3 image(1.4f, 0.8f, 0);
    floor.lights = {point_light(lamp, 100)};
    for (const auto& [final_stage, rays] :
         {std::pair(EmcFinal::gather, EmcRays::bvh), std::pair(EmcFinal::splat, EmcRays::bvh),
          std::pair(EmcFinal::splat, EmcRays::maps)}) {
        const ImageF seen = caustics_of(floor.scene(), 60'000, final_stage, rays);
        double sum = 0, wanted = 0, difference = 0;
        for (int y = 0; y < kSize.y; ++y) {
            for (int x = 0; x < kSize.x; ++x) {
                float lux = 0;
                for (int i = 0; i < 16; ++i) {
                    const vec3 p = place(x, y, {0.125f + 0.25f * (i % 4), 0.125f + 0.25f * (i / 4)});
                    const vec3 d = p - image;
                    const vec3 through = image + d * ((0.9f - image.x) / d.x);
                    const bool lit =
                        p.x < 0.9f && std::abs(through.z) < 0.3f && through.y > 0.1f && through.y < 0.4f;
                    const float r2 = glm::dot(d, d);
                    lux += lit ? 100 * image.y / (r2 * std::sqrt(r2)) / 16 : 0;
                }
                const float got = seen.pixels[3 * static_cast<std::size_t>(y * kSize.x + x)];
                ASSERT_TRUE(std::isfinite(got));
                sum += got;
                wanted += lux;
                difference += std::abs(got - lux);
            }
        }
        std::printf("mirror%s: flux %.4f of the image source's, mean difference %.4f\n",
                    rays == EmcRays::maps ? ", through maps" : "", sum / wanted, difference / wanted);
        // Maps know the mirror's rim to a texel.
        EXPECT_NEAR(sum / wanted, 1, rays == EmcRays::maps ? 0.06 : 0.02);
        EXPECT_LT(difference / wanted, 0.12);
    }
}

// Upright light on a slab of glass above the floor: the mean irradiance in its middle, over what falls in.
double slab_share(Material glass, float thickness, EmcRays rays = EmcRays::bvh) {
    Floor floor;
    floor.meshes.push_back(box(vec3(-0.6f, 0.6f, -0.6f), vec3(0.6f, 0.6f + thickness, 0.6f), false, 1));
    floor.materials.push_back(glass);
    floor.lights = {support::directional_light(vec3(0, -1, 0), 100)};
    Bench bench;
    bench.settings = settings_of(40'000, EmcFinal::gather, rays);
    FrameScene scene = floor.scene();
    look_closely(scene, vec3(0, 0.5f, 0), vec3(0), 0.4f);
    const ImageF image = bench.frame(scene, kSize);
    double sum = 0;
    for (const float lux : image.pixels) {
        sum += lux;
    }
    EXPECT_EQ(bench.technique().statistics(false).nan_count, 0u);
    return sum / static_cast<double>(image.pixels.size()) / 100;
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

TEST_F(Caustics, ASlabOfGlassLetsItsShareThrough) {
    for (const double ior : {1.0, 1.5, 3.0}) {
        const double r = std::pow((ior - 1) / (ior + 1), 2);
        const double share = slab_share(glass(static_cast<float>(ior)), 0.1f);
        std::printf("slab of ior %.2f: %.4f goes through, %.4f by Fresnel\n", ior, share, (1 - r) / (1 + r));
        EXPECT_NEAR(share, (1 - r) / (1 + r), 0.015);
    }
    const double through_maps = slab_share(glass(1.5f), 0.1f, EmcRays::maps);
    std::printf("through maps: slab of ior 1.5: %.4f goes through\n", through_maps);
    EXPECT_NEAR(through_maps, 0.96 / 1.04, 0.015);
    // With Beer's law: all orders of reflection within.
    Material dark = glass(1.5f);
    dark.attenuation_distance = 0.1f;
    dark.attenuation_colour = vec3(0.5f);
    const double share = slab_share(dark, 0.1f);
    EXPECT_NEAR(share, 0.96 * 0.96 * 0.5 / (1 - 0.04 * 0.04 * 0.25), 0.01);
    // A thin wall: each of its two sides by Schlick's f0, as the reference has it.
    Material thin = glass(1.5f);
    thin.thickness = 0;
    EXPECT_NEAR(slab_share(thin, 0.02f), 0.96 * 0.96, 0.015);
}

// Beams of parallel light through a ball of glass: exactly where each meets the floor.
class CausticsBy : public Caustics, public testing::WithParamInterface<EmcRays> {};

INSTANTIATE_TEST_SUITE_P(Rays, CausticsBy, testing::Values(EmcRays::bvh, EmcRays::maps),
                         [](const testing::TestParamInfo<EmcRays>& info) {
                             return info.param == EmcRays::maps ? "maps" : "bvh";
                         });

TEST_P(CausticsBy, ABallOfGlassHasItsFocus) {
    const float radius = 0.25f, ior = 1.5f, height = 0.55f;
    const vec3 direction = glm::normalize(vec3(0.4f, -1, 0.1f));
    Floor floor;
    floor.meshes.push_back(support::sphere(vec3(0, height, 0), radius, 5, false, 1));
    floor.materials.push_back(glass(ior));
    floor.lights = {support::directional_light(direction, 100)};
    FrameScene scene = floor.scene();
    const ImageF seen = caustics_of(scene, 100'000, EmcFinal::gather, GetParam());
    // Rays by their distance b from the axis: bent twice in their plane.
    const vec3 side = glm::normalize(glm::cross(direction, vec3(0, 0, 1)));
    const vec3 other = glm::cross(direction, side);
    std::vector<double> lux(seen.pixels.size() / 3, 0);
    const int rings = 400, turns = 400;
    const float pixel = 2 * Floor::kHalf / kSize.x;
    for (int i = 0; i < rings; ++i) {
        const float b = radius * (static_cast<float>(i) + 0.5f) / rings;
        const float in = std::asin(b / radius), inside = std::asin(b / radius / ior);
        const float deviation = 2 * (in - inside), leaves = in - 2 * inside;  // at this angle beyond the axis
        const float rs = std::pow(std::sin(in - inside) / std::sin(in + inside), 2.0f);
        const float rp = std::pow(std::tan(in - inside) / std::tan(in + inside), 2.0f);
        const float through = 0.5f * ((1 - rs) * (1 - rs) + (1 - rp) * (1 - rp));
        const double flux = 100.0 * 2 * kPi * b * (radius / rings) / turns * through;
        for (int k = 0; k < turns; ++k) {
            const float phi = 2 * kPi * (static_cast<float>(k) + 0.5f) / turns;
            const vec3 out = side * std::cos(phi) + other * std::sin(phi);
            const vec3 start =
                vec3(0, height, 0) + radius * (direction * std::cos(leaves) - out * std::sin(leaves));
            const vec3 d = direction * std::cos(deviation) - out * std::sin(deviation);
            const vec3 p = start - d * (start.y / d.y);
            const int x = static_cast<int>(std::floor((Floor::kHalf - p.x) / pixel));
            const int y = static_cast<int>(std::floor((Floor::kHalf - p.z) / pixel));
            if (d.y < 0 && x >= 0 && y >= 0 && x < kSize.x && y < kSize.y) {
                lux[static_cast<std::size_t>(y * kSize.x + x)] += flux / (pixel * pixel);
            }
        }
    }
    const auto brightest = std::ranges::max_element(lux) - lux.begin();
    std::vector<float> got;
    double sum = 0, wanted = 0, near = 0, near_wanted = 0;
    const vec3 peak = place(static_cast<int>(brightest) % kSize.x, static_cast<int>(brightest) / kSize.x);
    for (std::size_t i = 0; i < lux.size(); ++i) {
        const float here = seen.pixels[3 * i];
        got.push_back(here);
        const vec3 p = place(static_cast<int>(i) % kSize.x, static_cast<int>(i) / kSize.x);
        if (glm::distance(p, peak) < 0.35f) {
            sum += here;
            wanted += lux[i];
        }
        if (glm::distance(p, peak) < 0.06f) {
            near += here;
            near_wanted += lux[i];
        }
    }
    const auto peak_seen = std::ranges::max_element(got) - got.begin();
    const float off = glm::distance(
        peak, place(static_cast<int>(peak_seen) % kSize.x, static_cast<int>(peak_seen) / kSize.x));
    std::printf(
        "ball: flux %.4f of Snell's and Fresnel's, %.4f of it within 6 cm of the focus; peak off by %.4f of "
        "the "
        "diagonal\n",
        sum / wanted, near / near_wanted, off / scene.diagonal());
    EXPECT_NEAR(sum / wanted, 1, 0.05);
    EXPECT_NEAR(near / near_wanted, 1, 0.05);
    EXPECT_LT(off / scene.diagonal(), 0.02);
}

// A ball of glass on a floor under a sky with a small bright sun in it: what the ball gathers, and where.
TEST_F(Caustics, ASkysSunIsGatheredByABallOfGlass) {
    constexpr ivec2 kPicture(48);
    Floor floor;
    floor.meshes.push_back(support::sphere(vec3(0, 0.42f, 0), 0.28f, 5, false, 1));
    floor.materials.push_back(glass(1.5f));
    FrameScene scene = floor.scene();
    SkyImage image;
    image.width = 64;
    image.height = 32;
    image.radiance.assign(std::size_t{64} * 32, vec3(50));
    image.radiance[6 * 64 + 40] = vec3(2e5f);
    scene.sky.emplace();
    scene.sky->sky.image = std::make_shared<const SkyImage>(std::move(image));

    const auto by_path = [&](bool caustics) {
        reference::PathSettings path;
        path.transport = reference::Transport::full;
        path.caustics = caustics;
        path.bounces = 1;
        path.spp = 500;
        reference::PathTracer tracer(scene, kPicture, path, {.indirect = true});
        tracer.render({});
        return tracer.image(reference::PathAov::indirect);
    };
    const std::vector<float> whole = by_path(true), rest = by_path(false);
    for (const EmcFinal final_stage : {EmcFinal::gather, EmcFinal::splat}) {
        Bench with, without;
        with.settings = settings_of(60'000, final_stage);
        without.settings = settings_of(0, final_stage);
        with.settings.bounces = without.settings.bounces = 1;
        const ImageF seen = with.frame(scene, kPicture);
        const ImageF base = without.frame(scene, kPicture);
        double sum = 0, wanted = 0, all = 0, all_wanted = 0;
        glm::dvec2 centre(0), right(0);
        for (std::size_t i = 0; i < whole.size() / 3; ++i) {
            const double got = seen.pixels[3 * i + 1] - base.pixels[3 * i + 1];
            const double there = whole[3 * i + 1] - rest[3 * i + 1];
            ASSERT_TRUE(std::isfinite(got));
            sum += got;
            wanted += there;
            all += seen.pixels[3 * i + 1];
            all_wanted += whole[3 * i + 1];
            const glm::dvec2 at(static_cast<double>(i % 48), static_cast<double>(i / 48));
            centre += got * at;
            right += there * at;
        }
        const double off = glm::length(centre / sum - right / wanted) / 48;
        std::printf(
            "a sky through a ball: flux %.4f of the path tracer's, centre off by %.4f of the width; all "
            "%.4f\n",
            sum / wanted, off, all / all_wanted);
        EXPECT_NEAR(sum / wanted, 1, 0.1);
        EXPECT_NEAR(all / all_wanted, 1, 0.05);
        EXPECT_LT(off, 0.02);
    }
}

// What is aimed at a ball and met is the light's flux in the ball's solid angle; none is lost on the way.
double stored_flux(const FrameScene& scene, GiSettings settings, CausticStatistics* all = nullptr) {
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

FrameScene room_with(std::vector<Mesh> things, std::vector<Material> materials,
                     std::vector<LightInstance> lights) {
    things.insert(things.begin(), box(vec3(-2), vec3(2), true, 0));
    materials.insert(materials.begin(), lambertian(vec3(0.5f)));
    return scene_of(things, materials, std::move(lights), vec3(1.8f, 1.7f, 1.6f), vec3(0));
}

TEST_F(Caustics, FluxIsTheSolidAngles) {
    const float radius = 0.4f;
    const vec3 lamp(0.3f, 1.2f, -0.9f);
    const double sine2 = radius * radius / glm::dot(lamp, lamp);
    const double share = 0.5 * (1 - std::sqrt(1 - sine2));
    const std::vector<Mesh> ball{support::sphere(vec3(0), radius, 5, false, 1)};
    const double point =
        stored_flux(room_with(ball, {metal(vec3(1), 0)}, {point_light(lamp, 10)}), settings_of(40'000));
    EXPECT_NEAR(point / (4 * kPi * 10 * share), 1, 0.01);
    const double spot =
        stored_flux(room_with(ball, {metal(vec3(1), 0)}, {support::spot_light(lamp, -lamp, 10, 0.9f, 1.0f)}),
                    settings_of(40'000));
    EXPECT_NEAR(spot / (4 * kPi * 10 * share), 1, 0.01);
    const double beam =
        stored_flux(room_with({box(vec3(-0.3f, 0, -0.3f), vec3(0.3f, 0.1f, 0.3f), false, 1)},
                              {metal(vec3(1), 0)}, {support::directional_light(vec3(0, -1, 0), 10)}),
                    settings_of(40'000));
    EXPECT_NEAR(beam / (10 * 0.36), 0, 0.001);  // the ceiling is in the way
    // A small lamp that emits to one side, as seen from the ball: Lambert's cosine.
    const vec3 n = glm::normalize(-lamp);
    const vec3 u = glm::normalize(glm::cross(n, vec3(1, 0, 0))) * 0.02f, v = glm::cross(n, u);
    std::vector<Mesh> lit = ball;
    lit.push_back(quad(lamp - 0.5f * (u + v), u, v, 2));
    const double emitter =
        stored_flux(room_with(lit, {metal(vec3(1), 0), support::lamp(vec3(1e5f))}, {}), settings_of(40'000));
    EXPECT_NEAR(emitter / (1e5 * 0.0004 * kPi * sine2), 1, 0.01);
}

// In a closed room: what lands of all that mirrors and glass send on.
TEST_F(Caustics, ThroughMapsAsMuchLandsAsByExactRays) {
    const std::vector<Mesh> ball{support::sphere(vec3(0, -0.6f, 0), 0.4f, 5, false, 1)};
    for (const auto& [name, material] :
         {std::pair("metal", metal(vec3(1), 0)), std::pair("glass", glass(1.5f))}) {
        const FrameScene scene = room_with(ball, {material}, {point_light(vec3(0.3f, 1.2f, -0.9f), 10)});
        const double exact = stored_flux(scene, settings_of(40'000));
        const double maps = stored_flux(scene, settings_of(40'000, EmcFinal::splat, EmcRays::maps));
        std::printf("a ball of %s in a room, through maps: flux %.4f of exact rays'\n", name, maps / exact);
        EXPECT_NEAR(maps / exact, 1, 0.05);
    }
}

TEST_F(Caustics, OverlappingTargetsAreCountedOnce) {
    // Two mirrors of which one hides half of the other, as the lamp sees them; and the same as one thing.
    const Mesh near = quad(vec3(-0.3f, 0, -0.2f), vec3(0, 0, 0.4f), vec3(0.3f, 0, 0), 1);
    const Mesh far = quad(vec3(-0.4f, -0.3f, -0.3f), vec3(0, 0, 0.6f), vec3(0.8f, 0, 0), 1);
    Mesh both = near;
    both.vertices.insert(both.vertices.end(), far.vertices.begin(), far.vertices.end());
    for (const std::uint32_t i : far.indices) {
        both.indices.push_back(i + 4);
    }
    both.bounds.add(far.bounds);
    const LightInstance lamp = point_light(vec3(0, 1.5f, 0), 10);
    const double two = stored_flux(room_with({near, far}, {metal(vec3(1), 0)}, {lamp}), settings_of(60'000));
    const double one = stored_flux(room_with({both}, {metal(vec3(1), 0)}, {lamp}), settings_of(60'000));
    EXPECT_NEAR(two / one, 1, 0.01);
}

TEST_F(Caustics, ALightInsideGlassGetsOut) {
    // At the middle of a ball all light meets it squarely, again and again.
    const double flux = stored_flux(
        room_with({support::sphere(vec3(0), 0.3f, 4, false, 1)}, {glass(1.5f)}, {point_light(vec3(0), 10)}),
        settings_of(20'000));
    EXPECT_NEAR(flux / (4 * kPi * 10), 1, 0.01);
}

TEST_F(Caustics, ExtremesStayWithinWhatIsEmitted) {
    for (const float roughness : {0.0f, 1.0f}) {
        for (const float ior : {1.0f, 3.0f}) {
            Material m = glass(ior);
            m.roughness = roughness;
            for (const float thickness : {0.0f, 0.1f}) {
                m.thickness = thickness;
                CausticStatistics all;
                const double flux = stored_flux(room_with({support::sphere(vec3(0), 0.5f, 3, false, 1)}, {m},
                                                          {point_light(vec3(0, 1.2f, 0), 10)}),
                                                settings_of(5000), &all);
                EXPECT_GT(flux, 0);
                EXPECT_LT(flux, 4 * kPi * 10 * 0.06);
                EXPECT_EQ(all.bad_values, 0u);
            }
        }
    }
}

// A spot shines at a wall alone: all that the ball sends on has been scattered before. The path tracer finds
// it, too.
// By each final stage, and what the path tracer finds.
struct ScatteredCaustics {
    double gather = 0, splat = 0, wanted = 0;
};

ScatteredCaustics scattered_caustics(const Material& material) {
    constexpr ivec2 size(48);
    FrameScene scene = room_with({support::sphere(vec3(0, -1.2f, 0), 0.6f, 4, false, 1)}, {material},
                                 {support::spot_light(vec3(0, 1, 0), vec3(-1, 0.2f, 0), 300, 0.4f, 0.5f)});
    support::look(scene, vec3(0.9f, 1.9f, 0.7f), vec3(0.1f, -2, 0));
    scene.camera.camera.y_fov = 1.0f;
    reference::PathSettings path;
    path.transport = reference::Transport::full;
    path.bounces = 3;
    path.spp = 400;
    ScatteredCaustics result;
    for (const bool caustics : {true, false}) {
        for (const EmcFinal final_stage : {EmcFinal::gather, EmcFinal::splat}) {
            Bench bench;
            bench.settings = settings_of(caustics ? 60'000 : 0, final_stage);
            bench.settings.bounces = path.bounces;
            double& sum = final_stage == EmcFinal::gather ? result.gather : result.splat;
            for (const float lux : bench.frame(scene, size).pixels) {
                sum += (caustics ? 1 : -1) * static_cast<double>(lux);
            }
        }
        path.caustics = caustics;
        reference::PathTracer tracer(scene, size, path, {.indirect = true});
        tracer.render({});
        for (const float lux : tracer.image(reference::PathAov::indirect)) {
            result.wanted += (caustics ? 1 : -1) * static_cast<double>(lux);
        }
    }
    return result;
}

TEST_F(Caustics, LightThatWallsReflectFirstIsFollowed) {
    for (const Material& material : {metal(vec3(1), 0), glass(1.5f)}) {
        const ScatteredCaustics found = scattered_caustics(material);
        std::printf("%s: gather %.4f, splat %.4f of the path tracer's\n",
                    material.metallic > 0 ? "mirror" : "glass", found.gather / found.wanted,
                    found.splat / found.wanted);
        EXPECT_GT(found.wanted, 0);
        EXPECT_NEAR(found.gather / found.wanted, 1, 0.1);
        EXPECT_NEAR(found.splat / found.wanted, 1, 0.1);
    }
}

// Through a window of no thickness the floor has its caustic as without it, though the picture shows no
// floor.
TEST_F(Caustics, AreSeenThroughGlass) {
    const auto radiance = [](bool window, int photons, EmcFinal final_stage) {
        Floor floor;
        floor.materials[0] = lambertian(vec3(0.5f));
        floor.meshes.push_back(quad(vec3(0.9f, 0.1f, -0.3f), vec3(0, 0, 0.6f), vec3(0, 0.3f, 0), 1));
        floor.materials.push_back(metal(vec3(1), 0));
        if (window) {
            Material pane = glass(1.5f);
            pane.thickness = 0;
            pane.specular = 0;
            floor.meshes.push_back(quad(vec3(-1.2f, 1.4f, -1.2f), vec3(0, 0, 2.4f), vec3(2.4f, 0, 0), 2));
            floor.materials.push_back(pane);
        }
        floor.lights = {point_light(vec3(0.4f, 0.8f, 0), 100)};
        FrameScene scene = floor.scene();
        look_closely(scene, vec3(0.3f, 1.5f, 0), vec3(0.3f, 0, 0), 0.5f);
        Bench bench;
        bench.settings = settings_of(photons, final_stage);
        bench.frame(scene, kSize);
        return bench.renderer().read(render::Aov::radiance);
    };
    for (const EmcFinal final_stage : {EmcFinal::gather, EmcFinal::splat}) {
        double sum[2] = {0, 0}, difference = 0;
        const ImageF seen = radiance(true, 60'000, final_stage), dark = radiance(true, 0, final_stage);
        const ImageF open = radiance(false, 60'000, final_stage), plain = radiance(false, 0, final_stage);
        for (std::size_t i = 0; i < seen.pixels.size(); ++i) {
            const double through = static_cast<double>(seen.pixels[i] - dark.pixels[i]);
            const double right = static_cast<double>(open.pixels[i] - plain.pixels[i]);
            sum[0] += through;
            sum[1] += right;
            difference += std::abs(through - right);
        }
        std::printf("through a window: %.4f of the caustic, mean difference %.4f\n", sum[0] / sum[1],
                    difference / sum[1]);
        EXPECT_GT(sum[1], 0);
        EXPECT_NEAR(sum[0] / sum[1], 1, 0.06);
        EXPECT_LT(difference / sum[1], 0.2);
    }
}

TEST_F(Caustics, AMirrorThatFillsTheViewIsNoTrouble) {
    FrameScene scene = room_with({quad(vec3(-1.9f, -1.9f, -1), vec3(3.8f, 0, 0), vec3(0, 3.8f, 0), 1)},
                                 {metal(vec3(1), 0)}, {point_light(vec3(0, 1, 1), 10)});
    support::look(scene, vec3(0, 0, -0.9f), vec3(0, 0, -1));
    EXPECT_GT(stored_flux(scene, settings_of(5000)), 0);
}

TEST_F(Caustics, ThousandsOfThingsShareTheBudget) {
    std::vector<Mesh> things;
    for (int i = 0; i < 2000; ++i) {
        const vec3 p(-1.9f + 0.2f * static_cast<float>(i % 20),
                     -1.9f + 0.4f * static_cast<float>(i / 20 % 10),
                     -1.9f + 0.19f * static_cast<float>(i / 200) * 2);
        things.push_back(box(p, p + vec3(0.05f), false, 1));
    }
    const FrameScene scene =
        room_with(things, {metal(vec3(1), 0)},
                  {point_light(vec3(0, 1.95f, 0), 10), point_light(vec3(1, 1.95f, 0.4f), 10)});
    CausticStatistics all;
    const double flux = stored_flux(scene, settings_of(20'000), &all);
    EXPECT_LE(all.emitted, 20'000u);
    EXPECT_GT(all.emitted, 10'000u);
    EXPECT_GT(flux, 0);
    // All of it as one thing: the same light.
    Mesh one;
    one.material = 1;
    for (const Mesh& thing : things) {
        const auto first = static_cast<std::uint32_t>(one.vertices.size());
        one.vertices.insert(one.vertices.end(), thing.vertices.begin(), thing.vertices.end());
        for (const std::uint32_t i : thing.indices) {
            one.indices.push_back(first + i);
        }
        one.bounds.add(thing.bounds);
    }
    const double whole =
        stored_flux(room_with({one}, {metal(vec3(1), 0)}, scene.lights), settings_of(20'000));
    std::printf("2000 things: flux %.4f of that of one thing with their shape\n", flux / whole);
    EXPECT_NEAR(flux / whole, 1, 0.06);
}

TEST_F(Caustics, OnlyWhatChangedIsTraced) {
    FrameScene scene = room_with({support::sphere(vec3(0), 0.4f, 4, false, 1)}, {metal(vec3(1), 0)},
                                 {point_light(vec3(0, 1.2f, 0), 10), point_light(vec3(1.2f, 0, 0), 10)});
    Bench bench;
    bench.settings = settings_of(10'000);
    bench.frame(scene, kSize);
    const auto& caustics = dynamic_cast<const EmcTechnique&>(bench.technique()).caustics();
    const CausticStatistics first = caustics.statistics();
    EXPECT_EQ(first.traced, first.emitted);
    hold_still(scene);
    bench.frame(scene, kSize);
    EXPECT_EQ(caustics.version(), 1u);
    scene.lights[1].position.y += 0.01f;
    scene.changes.lights = true;
    bench.frame(scene, kSize);
    const CausticStatistics moved = caustics.statistics();
    EXPECT_EQ(caustics.version(), 2u);
    EXPECT_EQ(moved.emitted, first.emitted);
    EXPECT_EQ(2 * moved.traced, moved.emitted);
    // As if it had been there from the start.
    Bench fresh;
    fresh.settings = bench.settings;
    fresh.frame(scene, kSize);
    const auto& anew = dynamic_cast<const EmcTechnique&>(fresh.technique()).caustics();
    ASSERT_EQ(anew.hits().size(), caustics.hits().size());
    for (std::size_t i = 0; i < anew.hits().size(); ++i) {
        ASSERT_EQ(anew.hits()[i].position, caustics.hits()[i].position);
        ASSERT_EQ(anew.hits()[i].radius, caustics.hits()[i].radius);
    }
}

TEST_F(Caustics, GoWhenTheyAreTurnedOff) {
    FrameScene scene = room_with({support::sphere(vec3(0), 0.4f, 4, false, 1)}, {metal(vec3(1), 0)},
                                 {point_light(vec3(0, 1.2f, 0), 10)});
    Bench bench, without;
    bench.settings = settings_of(10'000);
    without.settings = settings_of(0);
    bench.frame(scene, kSize);
    without.frame(scene, kSize);
    hold_still(scene);
    bench.settings.edit<EmcSettings>().caustic_photons = 0;
    EXPECT_EQ(bench.frame(scene, kSize).pixels, without.frame(scene, kSize).pixels);
    bench.settings.edit<EmcSettings>().caustic_photons = 10'000;
    EXPECT_NE(bench.frame(scene, kSize).pixels, without.frame(scene, kSize).pixels);
}

}  // namespace
}  // namespace lanthorn::gi::test

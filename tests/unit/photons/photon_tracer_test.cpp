// Walks of light against closed forms.
#include "gi_module/shared/photons/photon_tracer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "lanthorn/reference/path_tracer.h"
#include "tests/support/closed_forms.h"
#include "tests/unit/photons/traced.h"

namespace lanthorn::gi::test {
namespace photon_tracer_test {

using support::kPiD;
using support::lambertian;
using support::metal;
using support::scene_of;

constexpr std::uint64_t kWalks = 40'000;

FrameScene closed_sphere(float albedo) {
    return scene_of({support::sphere(vec3(0), 1, 4, true, 0)},
                    {lambertian(vec3(albedo, 0.5f * albedo, 0.1f))}, {support::point_light(vec3(0), 10)},
                    vec3(0), vec3(0, 0, 1));
}

class SphereSeries : public testing::TestWithParam<std::tuple<PhotonScattering, float>> {};

// After b reflections rho^b of the flux is on its way (Jacquez and Kuppenheim 1955), in each channel.
TEST_P(SphereSeries, EachReflectionLeavesTheAlbedo) {
    const auto [scattering, albedo] = GetParam();
    const Traced traced(closed_sphere(albedo), kWalks, {.bounces = 4, .seed = 1, .scattering = scattering});
    for (int b = 0; b <= 4; ++b) {
        const double left = std::pow(static_cast<double>(albedo), b);
        const double deviation = std::sqrt((1 - left) / (left * kWalks)) + 1e-5;
        const dvec3 flux = traced.after(b) / (4 * kPiD * 10);
        EXPECT_NEAR(flux.x / left, 1, 4 * deviation) << b;
        EXPECT_NEAR(flux.y / flux.x, std::pow(0.5, b), 1e-3) << b;
    }
    EXPECT_EQ(traced.after(5).x, 0);
}

INSTANTIATE_TEST_SUITE_P(PhotonTracer, SphereSeries,
                         testing::Combine(testing::Values(PhotonScattering::even, PhotonScattering::full),
                                          testing::Values(0.5f, 0.9f)));

bool same(const std::vector<Photon>& a, const std::vector<Photon>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Photon)) == 0;
}

TEST(PhotonTracer, IsTheSameOnAnyNumberOfThreadsAndInAnyRanges) {
    const FrameScene scene = closed_sphere(0.7f);
    const Traced one(scene, 5000, {}, 1), two(scene, 5000, {}, 2);
    EXPECT_TRUE(same(one.run.photons, two.run.photons));
    EXPECT_EQ(one.run.rays, two.run.rays);
    reference::TileWorkers workers(2);
    const PhotonTracer tracer = one.scene.tracer({});
    std::vector<Photon> parts;
    for (const auto& [first, count] : {std::pair{0, 700}, {700, 1}, {701, 0}, {701, 4299}}) {
        const PhotonRun run =
            tracer.trace(static_cast<std::uint64_t>(first), static_cast<std::uint64_t>(count), workers);
        parts.insert(parts.end(), run.photons.begin(), run.photons.end());
    }
    EXPECT_TRUE(same(one.run.photons, parts));
    const Traced other(scene, 5000, {.bounces = 2, .seed = 2}, 2);
    EXPECT_FALSE(same(one.run.photons, other.run.photons));
}

TEST(PhotonTracer, PhotonsLieOnTheTrianglesTheyName) {
    const FrameScene scene = closed_sphere(0.7f);
    const Traced traced(scene, 2000);
    const Mesh& mesh = scene.assets->meshes[0];
    for (const Photon& p : traced.run.photons) {
        vec3 corner[3];
        for (std::size_t v = 0; v < 3; ++v) {
            corner[v] = mesh.vertices[mesh.indices[3 * std::size_t{p.primitive} + v]].position;
        }
        const vec3 n = glm::normalize(glm::cross(corner[1] - corner[0], corner[2] - corner[0]));
        EXPECT_NEAR(glm::dot(p.position - corner[0], n), 0, 1e-5);
        EXPECT_NEAR(glm::dot(p.normal, n), 1, 1e-5);
        EXPECT_LT(glm::dot(p.direction, p.normal), 0);
        EXPECT_TRUE(p.front && p.diffuse && !p.caustic);
    }
}

// What a mirror sends on seems to come from the lamp's picture behind it.
TEST(PhotonTracer, AMirrorsLightIsCausticAndComesFromTheLampsImage) {
    const vec3 lamp(0.5f, 0.5f, 0);
    const FrameScene scene =
        scene_of({floor_quad(0), support::quad(vec3(-1, 0, -1), vec3(0, 2, 0), vec3(0, 0, 2), 1)},
                 {lambertian(vec3(0.5f)), metal(vec3(1), 0)}, {support::point_light(lamp, 10)}, vec3(0, 3, 0),
                 vec3(0));
    for (const auto scattering : {PhotonScattering::even, PhotonScattering::full}) {
        const Traced traced(scene, kWalks, {.bounces = 1, .seed = 1, .scattering = scattering});
        const vec3 image(-2 - lamp.x, lamp.y, lamp.z);
        double caustic = 0;
        int found = 0, aside = 0;
        for (const Photon& p : traced.run.photons) {
            const bool on_floor = p.instance == 0;
            EXPECT_EQ(p.caustic, on_floor && p.bounces == 1);
            if (p.caustic) {
                const vec3 way = glm::normalize(p.position - image);
                ++found;
                aside += glm::dot(way, p.direction) > 0.9999f ? 0 : 1;  // the tail of a very narrow lobe
                caustic += static_cast<double>(p.flux.x) / static_cast<double>(traced.paths[p.group]);
            }
        }
        EXPECT_GT(found, 400);
        EXPECT_LT(aside, 0.1 * found);
        // The solid angle of the floor as the image sees it.
        double solid = 0;
        constexpr int kSteps = 1000;
        for (int i = 0; i < kSteps; ++i) {
            for (int k = 0; k < kSteps; ++k) {
                const dvec3 q(-1 + 2 * (i + 0.5) / kSteps, 0, -1 + 2 * (k + 0.5) / kSteps);
                const dvec3 d = q - dvec3(image);
                solid += 4.0 / (kSteps * kSteps) * -d.y / std::pow(glm::length(d), 3);
            }
        }
        EXPECT_NEAR(caustic / (10 * solid), 1, 0.05);
    }
}

// A slab of glass at right angles lets (1 - R) / (1 + R) through, all orders of reflections between its faces
// taken together.
TEST(PhotonTracer, ASlabOfGlassLetsThroughWhatFresnelSays) {
    Material glass = lambertian(vec3(1));
    glass.specular = 1;
    glass.roughness = 0;
    glass.transmission = 1;
    glass.ior = 1.5f;
    glass.thickness = 1;
    ASSERT_TRUE(glass.bounds_volume());
    const FrameScene scene =
        scene_of({floor_quad(0), support::box(vec3(-1, 0.5f, -1), vec3(1, 0.8f, 1), false, 1)},
                 {lambertian(vec3(0.5f)), glass}, {support::directional_light(vec3(0, -1, 0), 100)},
                 vec3(0, 3, 0), vec3(0));
    const Traced traced(scene, kWalks, {.bounces = 0, .seed = 1});
    const auto on_floor = [](const Photon& p) { return p.instance == 0; };
    const double reflectance = 0.04;
    EXPECT_NEAR(traced.flux(on_floor).x / (400 * (1 - reflectance) / (1 + reflectance)), 1, 0.01);
    for (const Photon& p : traced.run.photons) {
        if (on_floor(p)) {
            EXPECT_TRUE(p.bent && p.caustic && p.indirect());
        }
    }
}

// Thin glass under direct light: what comes through goes straight on, and is told from what fell there
// freely.
TEST(PhotonTracer, AThinPaneLetsLightGoStraightOn) {
    Material pane = lambertian(vec3(1));
    pane.roughness = 0;
    pane.transmission = 1;
    const FrameScene scene =
        scene_of({floor_quad(0), floor_quad(1, 0.5f)}, {lambertian(vec3(0.5f)), pane},
                 {support::directional_light(vec3(0, -1, 0), 100)}, vec3(0, 3, 0), vec3(0));
    const Traced traced(scene, kWalks, {.bounces = 0, .seed = 1});
    const auto on_floor = [](const Photon& p) { return p.instance == 0; };
    EXPECT_NEAR(traced.flux(on_floor).x / 400, 1, 0.01);  // its specular factor is 0: nothing is reflected
    EXPECT_TRUE(std::ranges::all_of(
        traced.run.photons, [&](const Photon& p) { return !on_floor(p) || (p.straight && p.caustic); }));
}

// A curtain stops the share of light that its alpha says.
TEST(PhotonTracer, ACurtainStopsAsMuchAsItCovers) {
    for (const PhotonScattering scattering : {PhotonScattering::even, PhotonScattering::full}) {
        Material cloth = lambertian(vec3(0.8f));
        cloth.alpha_mode = AlphaMode::blend;
        cloth.base_colour.a = 0.4f;
        const FrameScene scene =
            scene_of({floor_quad(0), floor_quad(1, 0.5f)}, {lambertian(vec3(0)), cloth},
                     {support::directional_light(vec3(0, -1, 0), 100)}, vec3(0, 3, 0), vec3(0));
        const Traced traced(scene, kWalks, {.bounces = 1, .seed = 1, .scattering = scattering});
        EXPECT_NEAR(traced.flux([](const Photon& p) { return p.instance == 0; }).x / 400, 0.6, 0.01);
    }
}

// A thin wall that scatters what it lets through and reflects nothing.
Material frosted() {
    Material result = lambertian(vec3(1));
    result.transmission = 1;
    result.roughness = 0.3f;
    return result;
}

// Its lamp shines at the backs of single-sided triangles alone. GGX loses little at this roughness.
TEST(PhotonTracer, AFrostedGlobeLetsItsLampsLightOut) {
    const auto trace = [](const Material& wall) {
        return Traced(
            scene_of({support::sphere(vec3(0), 2, 4, true, 0), support::sphere(vec3(0), 1, 4, false, 1)},
                     {lambertian(vec3(0.5f)), wall}, {support::point_light(vec3(0), 10)}, vec3(0),
                     vec3(0, 0, 1)),
            kWalks, {.bounces = 1, .seed = 1, .scattering = PhotonScattering::full});
    };
    const Traced traced = trace(frosted());
    const double out = traced.after(0).x / (4 * kPiD * 10);
    EXPECT_GT(out, 0.97);
    EXPECT_LT(out, 1.001);
    for (const Photon& p : traced.run.photons) {
        EXPECT_TRUE(p.front) << "backs keep no photons";
        EXPECT_TRUE(p.straight);
    }
    Material plated = frosted();
    plated.metallic = 1;
    EXPECT_EQ(trace(plated).run.rays, kWalks) << "metal transmits nothing: its back ends light";
}

// On the floor below a ball that light enters by fronts and leaves by backs.
TEST(PhotonTracer, AFrostedBallLetsThroughWhatPathTracingSays) {
    constexpr float kRadius = 0.3f;
    FrameScene scene = scene_of({floor_quad(0), support::sphere(vec3(0, 0.7f, 0), 0.3f, 4, false, 1)},
                                {lambertian(vec3(0)), frosted()},
                                {support::directional_light(vec3(0, -1, 0), 100)}, vec3(0, 3, 0), vec3(0));
    const Traced traced(scene, 10 * kWalks, {.bounces = 8, .seed = 1, .scattering = PhotonScattering::full});
    const double lux = traced
                           .flux([&](const Photon& p) {
                               return p.instance == 0 && p.indirect() && std::abs(p.position.x) < kRadius &&
                                      std::abs(p.position.z) < kRadius;
                           })
                           .x /
                       static_cast<double>(4 * kRadius * kRadius);
    support::look_closely(scene, vec3(0, 0.2f, 0), vec3(0), kRadius);
    reference::PathSettings settings;
    settings.spp = 256;
    settings.bounces = 8;
    settings.transport = reference::Transport::full;
    reference::PathTracer tracer(scene, ivec2(32), settings, {.indirect = true});
    tracer.render({});
    double expected = 0;
    for (const float v : tracer.image(reference::PathAov::indirect)) {
        expected += static_cast<double>(v) / (3 * 32 * 32);
    }
    EXPECT_GT(expected, 10);
    EXPECT_NEAR(lux / expected, 1, 0.03);
}

TEST(PhotonTracer, TheBackOfASingleSidedSurfaceEndsLight) {
    const FrameScene scene =
        scene_of({floor_quad(0)}, {lambertian(vec3(0.5f))}, {support::directional_light(vec3(0, 1, 0), 100)},
                 vec3(0, 3, 0), vec3(0));
    EXPECT_TRUE(Traced(scene, 100).run.photons.empty());
}

TEST(PhotonTracer, NoBounceLeavesLightWhereItFirstArrives) {
    const Traced traced(closed_sphere(0.9f), 1000, {.bounces = 0, .seed = 1});
    EXPECT_EQ(traced.run.photons.size(), 1000u);
    EXPECT_TRUE(std::ranges::none_of(traced.run.photons, [](const Photon& p) { return p.indirect(); }));
}

}  // namespace photon_tracer_test
}  // namespace lanthorn::gi::test

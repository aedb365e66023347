// What each kind of light sends, against its flux on paper.
#include "gi_module/shared/photons/photon_sources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/closed_forms.h"
#include "tests/unit/photons/traced.h"

namespace lanthorn::gi::test {
namespace {

using support::kPiD;
using support::lambertian;
using support::scene_of;

constexpr std::uint64_t kWalks = 40'000;

// A closed black room, in which all that is sent arrives once.
FrameScene black_room(std::vector<LightInstance> lights) {
    return scene_of({support::box(vec3(-1), vec3(1), true, 0)}, {lambertian(vec3(0))}, std::move(lights),
                    vec3(0), vec3(0, 0, 1));
}

TEST(PhotonSources, AClosedRoomGetsAllOfAPointLight) {
    const Traced traced(black_room({support::point_light(vec3(0.3f, 0.2f, -0.4f), 10)}), kWalks);
    EXPECT_NEAR(traced.after(0).x / (4 * kPiD * 10), 1, 1e-5);
    EXPECT_EQ(traced.run.photons.size(), kWalks);
    // On the wall x = 1 what Lambert's form factor has: its density, not its sum alone.
    const double share =
        traced.flux([](const Photon& p) { return p.position.x > 0.9999f; }).x / traced.after(0).x;
    const auto solid = [](double a, double b,
                          double d) {  // of a rectangle's quarter, Van Oosterom's arctangent
        return std::atan(a * b / (d * std::sqrt(a * a + b * b + d * d)));
    };
    const double d = 0.7;
    const double expected =
        (solid(0.8, 1.4, d) + solid(0.8, 0.6, d) + solid(1.2, 1.4, d) + solid(1.2, 0.6, d)) / (4 * kPiD);
    EXPECT_NEAR(share, expected, 3 * std::sqrt(expected / kWalks) * 0.5);
}

TEST(PhotonSources, ASpotSendsTheIntegralOfItsCone) {
    for (const float inner : {0.0f, 0.3f, 0.599f}) {
        const Traced traced(black_room({support::spot_light(vec3(0), vec3(1, 0.5f, 0), 10, inner, 0.6f)}),
                            kWalks);
        double expected = 0;  // by the midpoint rule over the cosine
        const double outer = std::cos(0.6),
                     scale = 1 / std::max(1e-3, std::cos(static_cast<double>(inner)) - outer);
        constexpr int kSteps = 100'000;
        for (int i = 0; i < kSteps; ++i) {
            const double c = outer + (1 - outer) * (i + 0.5) / kSteps;
            expected += std::pow(std::clamp((c - outer) * scale, 0.0, 1.0), 2) * (1 - outer) / kSteps;
        }
        expected *= 2 * kPiD * 10;
        EXPECT_NEAR(traced.after(0).x / expected, 1, 1e-4) << inner;
        // Half way up the ramp there is as much light as the ramp's integral to there says.
        const double half = outer + 0.5 * (std::min(outer + 1 / scale, 1.0) - outer);
        const double within = traced
                                  .flux([&](const Photon& p) {
                                      const vec3 axis = glm::normalize(vec3(1, 0.5f, 0));
                                      return static_cast<double>(glm::dot(p.direction, axis)) < half;
                                  })
                                  .x;
        const double on_paper = 2 * kPiD * 10 * std::pow(half - outer, 3) * scale * scale / 3;
        EXPECT_NEAR(within / traced.after(0).x, on_paper / expected, 0.01) << inner;
    }
}

TEST(PhotonSources, AFloorGetsTheIlluminanceOfParallelLight) {
    const FrameScene scene =
        scene_of({floor_quad(0)}, {lambertian(vec3(0))}, {support::directional_light(vec3(1, -1, 0), 100)},
                 vec3(0, 3, 0), vec3(0));
    const Traced traced(scene, kWalks);
    EXPECT_NEAR(traced.after(0).x / (100 * 4 * std::sqrt(0.5)), 1, 0.01);
}

TEST(PhotonSources, AnEmitterSendsPiTimesItsRadianceFromEachLitSide) {
    for (const bool both : {false, true}) {
        Material lamp = support::lamp(vec3(5, 10, 2));
        lamp.double_sided = both;
        const FrameScene scene = scene_of({support::box(vec3(-1), vec3(1), true, 0),
                                           support::quad(vec3(-0.1f), vec3(0.2f, 0, 0), vec3(0, 0.3f, 0), 1)},
                                          {lambertian(vec3(0)), lamp}, {}, vec3(0), vec3(0, 0, 1));
        const Traced traced(scene, kWalks);
        const double expected = kPiD * 0.2 * 0.3 * (both ? 2 : 1);
        EXPECT_NEAR(traced.after(0).x / (5 * expected), 1, 1e-3);
        EXPECT_NEAR(traced.after(0).y / (10 * expected), 1, 1e-3);
        const double forward =
            traced.flux([](const Photon& p) { return p.direction.z > 0; }).y / traced.after(0).y;
        EXPECT_NEAR(forward, both ? 0.5 : 1, both ? 0.01 : 1e-6);
    }
}

// What is blended sends as much as it covers.
TEST(PhotonSources, ABlendedEmitterSendsItsAlpha) {
    for (const PhotonScattering scattering : {PhotonScattering::even, PhotonScattering::full}) {
        Material lamp = support::lamp(vec3(5));
        lamp.alpha_mode = AlphaMode::blend;
        lamp.base_colour.a = 0.3f;
        Mesh panel = support::quad(vec3(-0.1f), vec3(0.2f, 0, 0), vec3(0, 0.3f, 0), 1);
        for (std::size_t i = 0; i < 4; ++i) {
            panel.vertices[i].colour.a = i % 3 == 0 ? 1.0f : 0.0f;  // fades along x
        }
        const FrameScene scene = scene_of({support::box(vec3(-1), vec3(1), true, 0), panel},
                                          {lambertian(vec3(0)), lamp}, {}, vec3(0), vec3(0, 0, 1));
        const Traced traced(scene, kWalks, {.bounces = 2, .seed = 1, .scattering = scattering});
        EXPECT_NEAR(traced.after(0).x / (0.5 * 0.3 * 5 * kPiD * 0.2 * 0.3), 1, 0.01);
    }
}

// A texture that glows on the left half of a panel, which fades in from there along x: what its walks begin
// with is the mean of the product, 1/8, so that what they bring hardly differs from one run of numbers to
// another.
TEST(PhotonSources, APanelsFluxIsItsMeanEmissionTimesAlpha) {
    Material lamp = support::lamp(vec3(8, 16, 4));
    lamp.alpha_mode = AlphaMode::blend;
    lamp.base_colour.a = 0.5f;
    lamp.emissive_texture.texture = 0;
    Mesh panel = support::quad(vec3(-0.1f), vec3(0.2f, 0, 0), vec3(0, 0.3f, 0), 1);
    for (Vertex& v : panel.vertices) {
        const float x = v.position.x > 0 ? 1.0f : 0.0f;
        v.uv0 = vec2(x, v.position.y > 0 ? 1.0f : 0.0f);
        v.colour.a = x;
    }
    FrameScene scene = scene_of({support::box(vec3(-1), vec3(1), true, 0), panel},
                                {lambertian(vec3(0)), lamp}, {}, vec3(0), vec3(0, 0, 1));
    SceneAssets assets = *scene.assets;
    Image image;
    image.width = 2;
    image.height = 1;
    image.rgba = {255, 255, 255, 255, 0, 0, 0, 255};
    assets.images.push_back(image);
    Texture texture;
    texture.sampler.mag = Filter::nearest;
    assets.textures.push_back(texture);
    scene.assets = std::make_shared<const SceneAssets>(assets);
    const Traced traced(scene, kWalks);
    const dvec3 on_paper = dvec3(8, 16, 4) * (0.5 / 8 * kPiD * 0.2 * 0.3);
    ASSERT_EQ(traced.scene.sources().groups().size(), 1u);
    const vec3 flux = traced.scene.sources().groups()[0].flux;
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(static_cast<double>(flux[c]) / on_paper[c], 1, 0.01);
        EXPECT_NEAR(traced.after(0)[c] / on_paper[c], 1, 0.03);
    }
}

TEST(PhotonSources, AFloorUnderAnEvenSkyGetsPiTimesItsRadiance) {
    FrameScene scene = scene_of({floor_quad(0)}, {lambertian(vec3(0))}, {}, vec3(0, 3, 0), vec3(0));
    auto image = std::make_shared<SkyImage>();
    image->width = 8;
    image->height = 4;
    image->radiance.assign(32, vec3(2, 1, 4));
    scene.sky = SkyInstance{7, Sky{image, nullptr, vec3(1), 1}, mat3(1)};
    const Traced traced(scene, 4 * kWalks);
    const dvec3 flux = traced.after(0);
    EXPECT_NEAR(flux.x / (2 * kPiD * 4), 1, 0.02);
    EXPECT_NEAR(flux.z / flux.y, 4, 1e-3);
    EXPECT_TRUE(
        std::ranges::all_of(traced.run.photons, [](const Photon& p) { return p.sky && p.indirect(); }));
}

TEST(PhotonSources, ALightsRangeWindowTakesWhatItTakes) {
    LightInstance light = support::point_light(vec3(0), 10);
    light.light.range = 2;
    const FrameScene scene = scene_of({support::sphere(vec3(0), 1, 4, true, 0)}, {lambertian(vec3(0))},
                                      {light}, vec3(0), vec3(0, 0, 1));
    const Traced traced(scene, kWalks);
    EXPECT_NEAR(traced.after(0).x / (4 * kPiD * 10 * (1 - 1.0 / 16)), 1, 3e-3);
}

// Two colours of lamps, one of them twice: two groups, in which every walk begins with the same flux.
FrameScene three_lamps() {
    LightInstance red = support::point_light(vec3(0.5f, 0, 0), 10);
    red.light.colour = vec3(1, 0.1f, 0.1f);
    LightInstance dim = red;
    dim.position = vec3(-0.5f, 0, 0);
    dim.light.intensity = 2;
    return black_room({red, support::point_light(vec3(0), 4), dim});
}

TEST(PhotonSources, LightsOfOneChromaticityShareAGroupOfConstantPower) {
    const Traced traced(three_lamps(), kWalks);
    ASSERT_EQ(traced.paths.size(), 2u);
    // f is the largest channel: 12 cd against 4.
    EXPECT_NEAR(static_cast<double>(traced.paths[0]) / kWalks, 0.75, 1e-3);
    EXPECT_EQ(traced.paths[0] + traced.paths[1], kWalks);
    const vec3 red = traced.scene.sources().groups()[0].flux;
    EXPECT_TRUE(std::ranges::all_of(traced.run.photons,
                                    [&](const Photon& p) { return p.group != 0 || p.flux == red; }));
    EXPECT_NEAR(traced.after(0).x / (4 * kPiD * 16), 1, 1e-5);
    EXPECT_NEAR(traced.after(0).y / (4 * kPiD * 5.2), 1, 1e-5);
    // Within the group by flux: the walls get as much of the dim one as it sends.
    const auto nearer = [](const Photon& p) { return p.group == 0 && p.position.x < -0.9999f; };
    EXPECT_GT(traced.flux(nearer).x, 0);
}

TEST(PhotonSources, EveryWalkHasAPlaceOfItsOwn) {
    const Traced traced(three_lamps(), 1);
    const PhotonSources& sources = traced.scene.sources();
    for (const std::uint64_t count : {1ull, 5ull, 1000ull, 1024ull, 2500ull}) {
        std::set<std::pair<std::size_t, std::uint64_t>> seen;
        std::vector<std::uint64_t> by_group(2, 0);
        for (std::uint64_t i = 0; i < count; ++i) {
            const PhotonSources::Place place = sources.place(i);
            EXPECT_TRUE(seen.insert({place.group, place.index}).second);
            ++by_group[place.group];
        }
        EXPECT_EQ(by_group, sources.paths(count));
    }
    EXPECT_GT(sources.paths(8)[1], 0u);  // a few walks are of all groups already
}

TEST(PhotonSources, NoLightIsNoPhotons) {
    EXPECT_TRUE(Traced(black_room({}), 100).run.photons.empty());
    EXPECT_TRUE(Traced(black_room({support::point_light(vec3(0), 0)}), 100).run.photons.empty());
    EXPECT_TRUE(Traced(black_room({support::point_light(vec3(0), 1)}), 0).run.photons.empty());
    FrameScene nothing;
    nothing.assets = std::make_shared<SceneAssets>();
    nothing.lights = {support::point_light(vec3(0), 1)};
    EXPECT_TRUE(Traced(nothing, 100).run.photons.empty());
}

}  // namespace
}  // namespace lanthorn::gi::test

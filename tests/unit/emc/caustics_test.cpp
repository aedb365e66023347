// Where caustic photons go, by closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>

#include "gi_module/techniques/emc/caustics/caustic_bandwidth.h"
#include "gi_module/techniques/emc/caustics/caustic_cells.h"
#include "gi_module/techniques/emc/caustics/caustic_emission.h"
#include "gi_module/techniques/emc/caustics/caustic_photons.h"
#include "gi_module/techniques/emc/emc_plan.h"
#include "lanthorn/emc/emc_settings.h"
#include "tests/support/scenes.h"
#include "tests/support/shapes.h"
#include "tests/unit/emc/emc_frames.h"

namespace lanthorn::gi {
namespace caustics_test {

// A floor and mirrors.
FrameScene scene_with(const std::vector<Aabb>& mirrors, std::vector<LightInstance> lights) {
    std::vector<Mesh> meshes{support::quad(vec3(-9, 0, -9), vec3(0, 0, 18), vec3(18, 0, 0), 0)};
    for (const Aabb& box : mirrors) {
        meshes.push_back(support::box(box.lower, box.upper, false, 1));
    }
    return support::scene_of(meshes, {support::lambertian(vec3(0.5f)), support::metal(vec3(1), 0)},
                             std::move(lights), vec3(0, 1, 9), vec3(0));
}

double power_of(const std::vector<CausticPhoton>& photons) {
    double sum = 0;
    for (const CausticPhoton& p : photons) {
        sum += p.power.y;
    }
    return sum;
}

bool meets(const CausticPhoton& p, const Aabb& box) {
    const vec3 a = (box.lower - p.origin) / p.direction, b = (box.upper - p.origin) / p.direction;
    const vec3 in = glm::min(a, b), out = glm::max(a, b);
    return std::max({in.x, in.y, in.z}) <= std::min({out.x, out.y, out.z});
}

const Aabb kBox{vec3(0.9f, 1, -0.2f), vec3(1.3f, 1.2f, 0.2f)};

TEST(CausticAim, AConeHoldsTheBox) {
    for (const glm::dvec3 from : {glm::dvec3(0, 3, 0), glm::dvec3(5, 0, 2), glm::dvec3(1.1, 1.3, 0)}) {
        const CausticAim aim = aim_at(kBox, from);
        for (int i = 0; i < 1000; ++i) {
            const vec3 u(static_cast<float>(i % 10) / 9, static_cast<float>(i / 10 % 10) / 9,
                         static_cast<float>(i / 100) / 9);
            const glm::dvec3 d = glm::normalize(glm::dvec3(kBox.lower + u * kBox.size()) - from);
            EXPECT_GE(glm::dot(d, aim.axis), 1 - aim.one_less_cosine - 1e-6);
        }
    }
    EXPECT_EQ(aim_at(kBox, glm::dvec3(kBox.centre())).one_less_cosine, 2);
    // Far away: the sphere about it is the widest that it may be.
    const double far = aim_at(kBox, {0, 1e6, 0}).solid_angle();
    EXPECT_LE(far, kPi * 0.25 * kBox.diagonal() * kBox.diagonal() / 1e12 * 1.01);
    EXPECT_GT(far, 0.4 * 0.4 / 1e12);
}

TEST(CausticEmission, PowerIsTheLightsInTheSolidAngle) {
    const LightInstance lamp = support::point_light(vec3(0.3f, 3, 0.4f), 50);
    const FrameScene scene = scene_with({kBox}, {lamp});
    const CausticTargets targets = CausticTargets::of(scene, 100);
    ASSERT_EQ(targets.targets.size(), 1u);
    EXPECT_EQ(targets.of_instance[0], CausticTargets::kNone);
    const CausticSource source(lamp, targets);
    const auto photons = source.emit(5000, 1, 0);
    EXPECT_EQ(photons.size(), 5000u);
    const double cone = aim_at(kBox, glm::dvec3(lamp.position)).solid_angle();
    EXPECT_NEAR(power_of(photons) / (50 * cone), 1, 1e-5);
    // Of these, what meets the box is its own solid angle, by quadrature over its three faces.
    double hits = 0;
    for (const CausticPhoton& p : photons) {
        hits += meets(p, kBox) ? p.power.y : 0;
    }
    double solid_angle = 0;
    constexpr int kSteps = 200;
    for (int axis = 0; axis < 3; ++axis) {
        const int v = (axis + 1) % 3, w = (axis + 2) % 3;
        for (const bool upper : {false, true}) {
            for (int i = 0; i < kSteps * kSteps; ++i) {
                vec3 p;
                p[axis] = upper ? kBox.upper[axis] : kBox.lower[axis];
                p[v] = kBox.lower[v] + kBox.size()[v] * (static_cast<float>(i % kSteps) + 0.5f) / kSteps;
                p[w] = kBox.lower[w] + kBox.size()[w] * (static_cast<float>(i / kSteps) + 0.5f) / kSteps;
                const vec3 d = p - lamp.position;
                const double r = glm::length(d);
                const double facing = upper ? -d[axis] : d[axis];
                solid_angle +=
                    std::max(facing, 0.0) / (r * r * r) * kBox.size()[v] * kBox.size()[w] / (kSteps * kSteps);
            }
        }
    }
    EXPECT_NEAR(hits / (50 * solid_angle), 1, 0.01);
}

std::shared_ptr<const CausticSky> sky_of(std::uint32_t width, std::uint32_t height, const vec3& nits,
                                         std::optional<std::size_t> bright = {}) {
    SkyImage image;
    image.width = width;
    image.height = height;
    image.radiance.assign(std::size_t{width} * height, nits);
    if (bright) {
        image.radiance[*bright] = vec3(1e6f);
    }
    SkyInstance sky;
    sky.sky.image = std::make_shared<const SkyImage>(std::move(image));
    sky.to_sky = mat3(glm::rotate(mat4(1), 0.4f, glm::normalize(vec3(1, 2, 3))));
    return std::make_shared<const CausticSky>(sky);
}

// Onto a convex body falls pi times the radiance times its surface.
TEST(CausticEmission, AnEvenSkySendsItsFluxOntoABox) {
    const CausticTargets targets = CausticTargets::of(scene_with({kBox}, {}), 100);
    const CausticSource source(sky_of(16, 8, vec3(3)), targets);
    const vec3 size = kBox.size();
    const double surface = 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
    const auto photons = source.emit(40'000, 1, 0);
    EXPECT_EQ(photons.size(), 40'000u);
    EXPECT_NEAR(power_of(photons) / (3 * kPi * surface), 1, 0.005);
    vec3 mean(0);
    for (const CausticPhoton& p : photons) {
        EXPECT_TRUE(meets(p, {kBox.lower - vec3(1e-4f), kBox.upper + vec3(1e-4f)}));
        EXPECT_GT(glm::distance(p.origin, kBox.centre()), 9) << "it starts outside the scene";
        mean += p.direction / 40'000.0f;
    }
    EXPECT_LT(glm::length(mean), 0.02f);
}

TEST(CausticEmission, OneBrightPixelOfTheSkyIsABeam) {
    const CausticTargets targets = CausticTargets::of(scene_with({kBox}, {}), 100);
    const std::uint32_t pixel = 20 * 128 + 30;
    const CausticSource source(sky_of(128, 64, vec3(0), pixel), targets);
    const SkyImage size{.name = {}, .width = 128, .height = 64, .radiance = {}};
    const vec2 middle(30.5f / 128, 20.5f / 64);
    const mat3 to_sky = mat3(glm::rotate(mat4(1), 0.4f, glm::normalize(vec3(1, 2, 3))));
    const vec3 to_sun = glm::transpose(to_sky) * sky_direction(middle);
    const vec3 box = kBox.size(), d = glm::abs(to_sun);
    const double across = d.x * box.y * box.z + d.y * box.z * box.x + d.z * box.x * box.y;
    const auto photons = source.emit(10'000, 1, 0);
    EXPECT_NEAR(power_of(photons) / (1e6 * size.pixel_solid_angle(pixel / 128) * across), 1, 0.01);
    for (const CausticPhoton& p : photons) {
        EXPECT_GT(glm::dot(-p.direction, to_sun), std::cos(0.75f * kPi / 64));
    }
}

TEST(CausticEmission, ABlackSkySendsNothing) {
    const CausticTargets targets = CausticTargets::of(scene_with({kBox}, {}), 100);
    const CausticSource source(sky_of(16, 8, vec3(0)), targets);
    EXPECT_EQ(source.flux(), 0);
    EXPECT_TRUE(source.emit(100, 1, 0).empty());
}

TEST(CausticEmission, OfManyTargetsEachHasItsShare) {
    std::vector<Aabb> boxes;
    for (int i = 0; i < 300; ++i) {
        const vec3 p(-4 + 0.5f * static_cast<float>(i % 16), 1, -4 + 0.5f * static_cast<float>(i / 16));
        boxes.push_back({p, p + vec3(0.1f)});
    }
    const LightInstance lamp = support::point_light(vec3(0, 4, 0), 50);
    const CausticTargets targets = CausticTargets::of(scene_with(boxes, {lamp}), 1000);
    EXPECT_EQ(targets.targets.size(), 300u);
    const CausticSource source(lamp, targets);
    EXPECT_NEAR(power_of(source.emit(20'000, 1, 0)) / source.flux(), 1, 1e-5);
    // With fewer photons than targets: right in the mean.
    double mean = 0;
    for (std::uint32_t seed = 0; seed < 400; ++seed) {
        const auto photons = source.emit(30, seed, 0);
        EXPECT_EQ(photons.size(), 30u);
        mean += power_of(photons) / 400;
    }
    EXPECT_NEAR(mean / source.flux(), 1, 1e-3);
    // Neighbours share a target where there are too many; none is forgotten.
    const CausticTargets few = CausticTargets::of(scene_with(boxes, {lamp}), 20);
    EXPECT_EQ(few.targets.size(), 20u);
    EXPECT_EQ(std::ranges::count(few.of_instance, CausticTargets::kNone), 1);
}

TEST(CausticEmission, WhatALightDoesNotReachGetsNothing) {
    LightInstance lamp = support::spot_light(vec3(0, 3, 0), vec3(-1, 0, 0), 50, 0.2f, 0.3f);
    EXPECT_EQ(flux_towards(lamp, kBox), 0);
    lamp = support::point_light(vec3(0, 3, 0), 50);
    EXPECT_GT(flux_towards(lamp, kBox), 0);
    lamp.light.range = 1;
    EXPECT_EQ(flux_towards(lamp, kBox), 0);
}

TEST(CausticEmission, ALightThatDimsALittleLeavesTheOthersTheirs) {
    const auto before = shared_out({10, 7, 3, 0}, 20'000);
    EXPECT_LE(std::accumulate(before.begin(), before.end(), 0), 20'000);
    EXPECT_GE(std::accumulate(before.begin(), before.end(), 0), 16'000);
    EXPECT_EQ(before[3], 0);
    EXPECT_EQ(shared_out({10, 6.98, 3, 0}, 20'000), before);
    const auto many = shared_out(std::vector<double>(1000, 1.0), 100);
    EXPECT_EQ(std::accumulate(many.begin(), many.end(), 0), 100);
}

TEST(CausticBandwidth, FollowsTheDensityOfPhotons) {
    // Two patches on a plane, one four times as dense.
    std::vector<PhotonHit> hits;
    for (int i = 0; i < 4000; ++i) {
        const float x = std::fmod(0.7548776662f * static_cast<float>(i), 1.0f);
        const float y = std::fmod(0.5698402910f * static_cast<float>(i), 1.0f);
        hits.push_back({vec3(x, y, 0), 0, vec3(1), 0});
        hits.push_back({vec3(3 + 0.5f * x, 0.5f * y, 0), 0, vec3(1), 0});
    }
    set_bandwidth(hits, 4, 1);
    double sums[2] = {0, 0}, counts[2] = {0, 0};
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const vec3 p = i % 2 == 0 ? hits[i].position : (hits[i].position - vec3(3, 0, 0)) * 2.0f;
        if (std::max(std::abs(p.x - 0.5f), std::abs(p.y - 0.5f)) < 0.45f) {  // at edges there are fewer
            sums[i % 2] += hits[i].radius;
            ++counts[i % 2];
        }
    }
    for (int patch = 0; patch < 2; ++patch) {  // some of the nearest are not found: never narrower
        const double h = 4 / std::sqrt(patch == 0 ? 4000.0 : 16'000.0);
        EXPECT_GT(sums[patch] / counts[patch], h);
        EXPECT_LT(sums[patch] / counts[patch], 1.15 * h);
    }
    std::vector<PhotonHit> lone{hits.front()};
    set_bandwidth(lone, 4, 0.3f);
    EXPECT_EQ(lone.front().radius, 0.3f);
}

// Splats of many sizes: a point's cells have all that reach it.
TEST(CausticCells, HaveAllSplatsAround) {
    std::vector<PhotonHit> hits;
    std::uint32_t bits = 1;
    const auto number = [&] {
        bits = bits * 1664525u + 1013904223u;
        return static_cast<float>(bits >> 8) / 16777216.0f;
    };
    for (int i = 0; i < 2000; ++i) {
        const vec3 at(4 * number() - 2, 4 * number() - 2, 4 * number() - 2);
        hits.push_back({at, std::exp2(-10 * number()), vec3(1), 0});
    }
    const CausticCellTable table = CausticCellTable::of(hits);
    std::size_t asked = 0, reached = 0;
    for (int k = 0; k < 500; ++k) {
        const vec3 p(4 * number() - 2, 4 * number() - 2, 4 * number() - 2);
        std::vector<int> found(hits.size(), 0);
        table.near(
            p, [&](std::uint32_t i, int size) { found[i] += table.is_own(hits[i].radius, size) ? 1 : 0; });
        for (std::size_t i = 0; i < hits.size(); ++i) {
            const bool reaches = glm::distance(hits[i].position, p) < hits[i].radius;
            EXPECT_LE(found[i], 1);
            EXPECT_GE(found[i], reaches ? 1 : 0);
            asked += found[i] > 0 ? 1 : 0;
            reached += reaches ? 1 : 0;
        }
    }
    EXPECT_GT(reached, 1000u);
    EXPECT_LT(asked, 20 * reached);  // boxes of a splat in space, not on a surface
}

TEST(CausticCells, SamplesKnowTheIrradiance) {
    std::vector<PhotonHit> hits;  // 10 lm on 1 m2 that faces +z
    for (int i = 0; i < 10'000; ++i) {
        const vec2 at = glm::fract(static_cast<float>(i) * vec2(0.75487767f, 0.56984029f));
        hits.push_back({vec3(at, 0), 0.04f, vec3(1e-3f), glm::packSnorm2x16(vec2(0))});
    }
    const std::vector<PhotonHit> samples = caustic_samples(hits, 1e-5f);
    EXPECT_EQ(samples.size(), 2500u);
    for (const PhotonHit& sample : samples) {
        const vec2 inner = glm::abs(vec2(sample.position) - 0.5f);
        if (std::max(inner.x, inner.y) < 0.45f) {
            EXPECT_NEAR(sample.power.y, 10, 0.5);
        }
    }
    EXPECT_TRUE(caustic_samples({}, 1).empty());
}

TEST(CausticPlan, SaysWhyThereAreNone) {
    const LightInstance lamp = support::point_light(vec3(0, 3, 0), 50);
    FrameScene scene = scene_with({kBox}, {lamp});
    GiSettings settings;
    test::EmcFrames frames;
    const auto plan = [&] { return frames.next(scene, settings); };
    const auto why = [&] { return plan().why(EmcPass::caustic_photons); };
    EXPECT_EQ(why(), EmcReason::no_caustics_yet);
    EXPECT_TRUE(plan().caustics_by_maps);  // this program has no exact rays
    frames.frame.exact_rays = true;
    EXPECT_EQ(why(), EmcReason::no_caustics_yet);
    EXPECT_FALSE(plan().caustics_by_maps);
    settings.edit<EmcSettings>().rays = EmcRays::maps;
    EXPECT_TRUE(plan().caustics_by_maps);
    settings.edit<EmcSettings>().rays = EmcRays::fastest;
    settings.edit<EmcSettings>().caustic_photons = 0;
    EXPECT_EQ(why(), EmcReason::no_caustics_wanted);
    settings.edit<EmcSettings>().caustic_photons = 100;
    scene.lights[0].light.range = 0.1f;
    EXPECT_EQ(why(), EmcReason::specular_in_the_dark);
    scene = scene_with({}, {lamp});
    EXPECT_EQ(why(), EmcReason::no_specular);
}

TEST(CausticPlan, WhatHoldsIsNotTracedAgain) {
    FrameScene scene = scene_with({kBox}, {support::point_light(vec3(0, 3, 0), 50)});
    scene.changes = {};
    scene.changes.assets = scene.changes.geometry = scene.changes.lights = scene.changes.camera = false;
    GiSettings settings;
    settings.edit<EmcSettings>().final_stage = EmcFinal::splat;
    const test::EmcFrames frames = test::running(scene, settings, true);
    EmcPlan plan = frames.next(scene, settings);
    EXPECT_TRUE(plan.caustics);
    EXPECT_FALSE(plan.on(EmcPass::caustic_photons) || plan.on(EmcPass::caustic_splats));
    scene.changes.camera = true;
    plan = frames.next(scene, settings);
    EXPECT_FALSE(plan.on(EmcPass::caustic_photons));
    EXPECT_TRUE(plan.on(EmcPass::caustic_splats) && plan.splat_caustics);
    scene.changes.lights = true;
    plan = frames.next(scene, settings);
    EXPECT_TRUE(plan.on(EmcPass::caustic_photons) && plan.keep_caustics);
    scene.changes.geometry = true;
    EXPECT_FALSE(frames.next(scene, settings).keep_caustics);
}

// The mirrors went on to show those of before.
TEST(CausticPlan, MirrorsShowOtherCaustics) {
    FrameScene scene = scene_with({kBox}, {support::point_light(vec3(0, 3, 0), 50)});
    scene.changes = {};
    scene.changes.assets = scene.changes.geometry = scene.changes.lights = scene.changes.camera = false;
    GiSettings settings;
    settings.edit<EmcSettings>().final_stage = EmcFinal::splat;
    const test::EmcFrames frames = test::running(scene, settings, true);
    EXPECT_EQ(frames.next(scene, settings).why(EmcPass::specular), EmcReason::image_holds);
    for (const int photons : {1000, 0}) {
        settings.edit<EmcSettings>().caustic_photons = photons;
        const EmcPlan plan = frames.next(scene, settings);
        EXPECT_TRUE(plan.on(EmcPass::specular)) << photons;
        EXPECT_FALSE(plan.specular_rays);
        EXPECT_EQ(plan.caustics, photons > 0);
    }
}

}  // namespace caustics_test
}  // namespace lanthorn::gi

// Why a point is as bright as it is: the parts add up to what `path` finds there, and what is promised of a
// lamp that is hidden comes true.
#include "gi_module/reference/light_split.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "lanthorn/core/colour.h"
#include "tests/support/closed_forms.h"
#include "tests/unit/reference/scenes.h"

namespace lanthorn::reference::test {
namespace {

using support::box;
using support::kPiD;

// What is where in the scene below; entities are numbered so.
enum Thing : std::uint32_t { kRoom, kScreen, kPanel, kLamps = 1000 };

constexpr vec3 kPlace{0.3f, 0, 0.4f};  // on the floor
const vec3 kBehind(0.5f, 2.2f, 0.4f), kFree(-1.5f, 2, -1);

// A room of 6 x 3 x 4 m with a lamp behind a screen, a free one and a panel that glows at a wall.
FrameScene room(bool with_screen = true, float panel_nits = 4) {
    const float far = with_screen ? 0.0f : 100.0f;
    std::vector<Mesh> meshes{
        box({-3, 0, -2}, {3, 3, 2}, true, 0),
        box(vec3(-0.3f, 1.4f, 0) + vec3(far), vec3(1.2f, 1.5f, 0.8f) + vec3(far), false, 0),
        quad({-2.9f, 0.5f, 1}, {0, 0, -1}, {0, 1, 0}, 1)};
    for (std::uint32_t i = 0; i < meshes[kPanel].vertices.size(); ++i) {  // its front looks into the room
        EXPECT_NE(meshes[kPanel].vertices[i].normal.x, 0);
    }
    FrameScene scene =
        scene_of(std::move(meshes), {lambertian(vec3(0.6f, 0.5f, 0.4f)), lamp(vec3(panel_nits))},
                 {point_light(kBehind, 120), point_light(kFree, 60)}, vec3(0, 1.2f, 1.5f), kPlace);
    look_closely(scene, kPlace + vec3(0, 1, 0.4f), kPlace, 1e-4f);
    return scene;
}

PathSettings three_bounces() {
    PathSettings settings;
    settings.bounces = 3;
    return settings;
}

LightSplit split_of(const FrameScene& scene, int paths = 16384) {
    const LightSplitter splitter(scene, three_bounces());
    const auto point = splitter.seen(scene.camera, ivec2(4), ivec2(2));
    EXPECT_TRUE(point);
    EXPECT_EQ(point->entity, kRoom);
    return splitter.split(*point, paths);
}

TEST(LightSplit, AddsUpToWhatThePathTracerFinds) {
    for (const float nits : {0.0f, 4.0f}) {
        const FrameScene scene = room(true, nits);
        const LightSplit split = split_of(scene);
        PathSettings settings = three_bounces();
        settings.spp = 4096;
        PathTracer tracer(scene, ivec2(4), settings, {.indirect = true});
        tracer.render({});
        const std::vector<float> image = tracer.image(PathAov::indirect);
        vec3 mean(0);
        for (std::size_t i = 0; i < image.size(); i += 3) {
            mean += vec3(image[i], image[i + 1], image[i + 2]) / 16.0f;
        }
        const double expected = luminance(dvec3(mean));
        ASSERT_GT(expected, 1);
        EXPECT_LT(split.indirect().noise, 0.02 * expected);
        EXPECT_NEAR(split.indirect().value(), expected, 4 * split.indirect().noise + 0.002 * expected)
            << nits;
    }
}

TEST(LightSplit, PartsAddUpToTheWhole) {
    const LightSplit split = split_of(room());
    dvec3 lamps(0), reflected(0), surfaces(0), direct(0);
    for (const LampPart& lamp : split.lamps) {
        lamps += lamp.sum.rgb;
        direct += lamp.direct.rgb;
        dvec3 sum = lamp.direct.rgb;
        for (const Lux& lux : lamp.reflected) {
            reflected += lux.rgb;
            sum += lux.rgb;
        }
        EXPECT_NEAR(luminance(sum), lamp.sum.value(), 1e-9 * lamp.sum.value());
        EXPECT_LE(lamp.reflected.size(), 3u);
    }
    double ways = 0;
    for (const SurfacePart& surface : split.surfaces) {
        surfaces += surface.reflected.rgb;
    }
    for (const LightWay& way : split.ways) {
        ways += way.lux;
        EXPECT_EQ(way.places.size(), way.entities.size() + 2);
    }
    EXPECT_EQ(split.lamps.size(), 3u);
    EXPECT_NEAR(luminance(lamps), split.direct.value() + split.indirect().value(), 1e-6);
    EXPECT_NEAR(luminance(direct), split.direct.value(), 1e-6);
    EXPECT_NEAR(luminance(reflected), split.reflected.value(), 1e-6);
    EXPECT_NEAR(luminance(surfaces), split.reflected.value(), 1e-6);
    EXPECT_GT(ways, 0.5 * split.reflected.value());
    EXPECT_LE(ways, split.reflected.value() * (1 + 1e-9));
}

// I cos / d^2, and a rectangle's by Howell B-4.
TEST(LightSplit, DirectLightIsThatOfTheClosedForms) {
    const LightSplit split = split_of(room());
    for (const LampPart& lamp : split.lamps) {
        if (lamp.source == LightSource{LightKind::punctual, 1}) {
            const LightSplitter there(room(), three_bounces());
            const dvec3 place(there.seen(room().camera, ivec2(4), ivec2(2))->position);
            const dvec3 span = dvec3(kFree) - place;
            EXPECT_NEAR(lamp.direct.value(), 60 * span.y / std::pow(glm::length(span), 3), 1e-5);
            EXPECT_EQ(lamp.straight, Straight::lit);
            EXPECT_EQ(lamp.entity, kLamps + 1);
        }
    }
    // The panel stands square to an open floor, its lower edge on it, before the point.
    FrameScene scene = scene_of(
        {quad({-20, 0, 20}, {40, 0, 0}, {0, 0, -40}, 0), quad({0, 0, -0.75f}, {1.5f, 0, 0}, {0, 2, 0}, 1)},
        {lambertian(vec3(0.5f)), lamp(vec3(100))}, {}, vec3(0, 1, 0), vec3(0));
    look_closely(scene, vec3(0, 0.5f, 0.5f), vec3(0), 1e-4f);
    const LightSplitter splitter(scene, three_bounces());
    const auto point = splitter.seen(scene.camera, ivec2(4), ivec2(2));
    ASSERT_TRUE(point);
    const LightSplit of_panel = splitter.split(*point);
    const double expected = 100 * kPiD * support::perpendicular_corner(2, 1.5, 0.75);
    EXPECT_NEAR(of_panel.direct.value(), expected, 4 * of_panel.direct.noise + 1e-3 * expected);
    EXPECT_LT(of_panel.direct.noise, 0.01 * expected);
}

TEST(LightSplit, WhatHidesALampIsNamedAndThePromiseComesTrue) {
    const LightSplit hidden = split_of(room()), open = split_of(room(false));
    const auto direct_of = [](const LightSplit& split) {
        for (const LampPart& lamp : split.lamps) {
            if (lamp.source == LightSource{LightKind::punctual, 0}) {
                return std::pair(lamp.straight, lamp.direct.value());
            }
        }
        return std::pair(Straight::no_light, -1.0);
    };
    EXPECT_EQ(direct_of(hidden), std::pair(Straight::hidden, 0.0));
    EXPECT_EQ(direct_of(open).first, Straight::lit);
    ASSERT_FALSE(hidden.hidden.empty());
    const HiddenPart& most = hidden.hidden.front();
    EXPECT_EQ(most.source, (LightSource{LightKind::punctual, 0}));
    EXPECT_EQ(most.occluders, std::vector<std::uint32_t>{kScreen});
    EXPECT_NEAR(most.direct.value(), direct_of(open).second, 1e-3 * direct_of(open).second);
    const double gain =
        open.direct.value() + open.indirect().value() - hidden.direct.value() - hidden.indirect().value();
    EXPECT_TRUE(most.whole);
    EXPECT_NEAR(most.direct.value() + most.reflected.value(), gain, 0.1 * gain);
}

TEST(LightSplit, SaysWhyALampGivesNothing) {
    FrameScene scene = room(false);
    LightInstance near = point_light({0.3f, 2, 0.4f}, 50);
    near.light.range = 1.5f;
    scene.lights = {near, spot_light({0.3f, 2, 0.4f}, {1, 0.2f, 0}, 50, 0.2f, 0.4f),
                    point_light({0, -1, 0}, 50)};
    const LightSplit split = split_of(scene);
    std::vector<Straight> why(3, Straight::lit);
    for (const LampPart& lamp : split.lamps) {
        if (lamp.source.kind == LightKind::punctual) {
            why[lamp.source.index] = lamp.straight;
            EXPECT_EQ(lamp.direct.value(), 0);
        }
    }
    EXPECT_EQ(why, (std::vector{Straight::out_of_range, Straight::out_of_cone, Straight::behind}));
}

// Straight from the sky, and what a roof keeps off.
TEST(LightSplit, TheSkyIsALamp) {
    FrameScene scene = scene_of(
        {quad({-20, 0, 20}, {40, 0, 0}, {0, 0, -40}, 0), quad({-20, 2, 20}, {40, 0, 0}, {0, 0, -20}, 0)},
        {lambertian(vec3(0.5f))}, {}, vec3(0, 1, 0), vec3(0));
    scene.sky = sky_of(10, [](const vec3&) { return true; });
    look_closely(scene, vec3(0, 0.5f, -0.5f), vec3(0, 0, -0.001f), 1e-4f);
    const LightSplitter splitter(scene, three_bounces());
    const auto point = splitter.seen(scene.camera, ivec2(4), ivec2(2));
    ASSERT_TRUE(point);
    const LightSplit split = splitter.split(*point, 65536);
    // Half of it lies under the roof, which ends above the point: E = pi L / 2, and the roof keeps off the
    // rest.
    EXPECT_NEAR(split.sky.value(), 10 * kPiD / 2, 0.15);
    double off = 0;
    for (const HiddenPart& part : split.hidden) {
        if (part.source.kind == LightKind::sky && part.occluders == std::vector<std::uint32_t>{1}) {
            off = part.direct.value();
        }
    }
    EXPECT_NEAR(off, 10 * kPiD / 2, 0.5);
}

// A lamp that is moved needs no new structure, and gives the same bits as one.
TEST(LightSplit, FollowsLampsAndNothingElse) {
    FrameScene scene = room();
    LightSplitter splitter(scene, three_bounces());
    scene.lights[1].position.x += 1;
    ASSERT_TRUE(splitter.follow(scene));
    const LitPoint point = *splitter.seen(scene.camera, ivec2(4), ivec2(2));
    const LightSplitter fresh(scene, three_bounces());
    const LightSplit a = splitter.split(point), b = fresh.split(point);
    EXPECT_EQ(a.direct.rgb, b.direct.rgb);
    EXPECT_EQ(a.reflected.rgb, b.reflected.rgb);
    EXPECT_EQ(a.lamps.size(), b.lamps.size());
    scene.instances[kScreen].transform[3].x += 1;
    EXPECT_FALSE(splitter.follow(scene));
}

}  // namespace
}  // namespace lanthorn::reference::test

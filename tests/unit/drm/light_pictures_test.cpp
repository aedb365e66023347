#include "gi_module/techniques/drm/light_pictures.h"

#include <gtest/gtest.h>

#include <limits>

namespace lanthorn::gi {
namespace {

using render::LightData;

LightData point(const vec3& at, float candela) {
    LightData light{};
    light.type = render::kLightPoint;
    light.position = at;
    light.intensity = vec3(candela);
    light.layers = 6;
    light.range = 1e30f;
    return light;
}

LightData area(const vec3& at, const vec3& facing, float square_metres, std::uint32_t surface) {
    LightData light{};
    light.type = render::kLightAreaSample;
    light.position = at;
    light.direction = facing;
    light.intensity = vec3(100);
    light.area = square_metres;
    light.layers = 6;
    light.id = surface;
    return light;
}

const Aabb kBox{vec3(-2, 0, -3), vec3(2, 5, 3)};

TEST(LightPictures, SamplesOfAPanelAreOneLight) {
    const std::vector<LightData> lights{
        area({0, 3, 0}, {0, -1, 0}, 0.25f, 7), area({1, 3, 0}, {0, -1, 0}, 0.25f, 7),
        area({2, 3, 0}, {0, -1, 0}, 0.25f, 7), area({0, 1, 0}, {0, -1, 0}, 0.5f, 8)};
    const LightPictures all = choose_pictures(lights, 0, kBox, 8);
    ASSERT_EQ(all.count(), 2);
    EXPECT_FLOAT_EQ(all.lights[0].area, 0.75f);
    EXPECT_EQ(all.lights[0].position, vec3(1, 3, 0));  // the middle one: on the surface
    EXPECT_FLOAT_EQ(all.lights[1].area, 0.5f);
    EXPECT_EQ(all.lights[0].first_layer, 0u);
    EXPECT_EQ(all.lights[1].first_layer, 6u);
    for (const LightPicture& shape : all.shapes) {
        EXPECT_EQ(shape.shape, kPictureHemisphere);
        EXPECT_EQ(shape.drawn_here, 1u);
    }
}

// Four samples lie as near to its middle as each other, but for rounding.
TEST(LightPictures, APanelThatMovesIsLookedFromTheSamePlaceOfIt) {
    const auto from_first = [](const vec3& at) {
        std::vector<LightData> lights;
        for (const vec3& corner : {vec3(-1, 0, -1), vec3(1, 0, -1), vec3(-1, 0, 1), vec3(1, 0, 1)}) {
            lights.push_back(area(at + 0.035f * corner, {0, -1, 0}, 0.0034f, 7));
        }
        const LightPictures all = choose_pictures(lights, 0, kBox, 8);
        return glm::distance(all.lights.at(0).position, lights[0].position);
    };
    for (int i = 0; i < 50; ++i) {
        EXPECT_EQ(from_first(vec3(0.00192f, 0.0031f, -0.0007f) * static_cast<float>(i)), 0) << i;
    }
}

TEST(LightPictures, ABulbHasOneForEveryWayThatItFaces) {
    std::vector<LightData> lights;
    float flux = 0;
    for (const vec3& facing : {vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 1, 0), vec3(0, -1, 0)}) {
        lights.push_back(area(0.1f * facing, facing, 0.1f, 3));
        flux += lights.back().area;
    }
    const LightPictures all = choose_pictures(lights, 0, kBox, 8);
    ASSERT_EQ(all.count(), 4);
    for (const LightData& light : all.lights) {
        flux -= light.area;
        EXPECT_NEAR(glm::length(light.right), 1, 1e-6f);
        EXPECT_NEAR(glm::dot(glm::cross(light.right, light.up), light.direction), -1, 1e-6f);
    }
    EXPECT_NEAR(flux, 0, 1e-6f);
}

TEST(LightPictures, WhatShinesToBothSidesHasTwo) {
    LightData sheet = area({0, 1, 0}, {0, 0, 1}, 1, 4);
    sheet.two_sided = 1;
    const LightPictures all = choose_pictures(std::vector{sheet}, 0, kBox, 8);
    ASSERT_EQ(all.count(), 2);
    EXPECT_EQ(all.lights[0].direction, -all.lights[1].direction);
}

TEST(LightPictures, TheStrongestAreTakenInTheirOwnOrder) {
    const std::vector<LightData> lights{point(vec3(0), 1), point(vec3(1), 50), point(vec3(2), 2),
                                        point(vec3(3), 90)};
    const LightPictures all = choose_pictures(lights, 4, kBox, 2);
    ASSERT_EQ(all.count(), 2);
    EXPECT_EQ(all.lights[0].position, vec3(1));
    EXPECT_EQ(all.lights[1].position, vec3(3));
    EXPECT_EQ(all.left_out, 2);
}

TEST(LightPictures, WhatSendsNothingHasNone) {
    LightData broken = point(vec3(0), std::numeric_limits<float>::quiet_NaN());
    LightData endless = point(vec3(0), std::numeric_limits<float>::infinity());
    LightData negative = point(vec3(0), -3);
    LightData without_map = point(vec3(0), 3);
    without_map.layers = 0;
    const std::vector<LightData> lights{point(vec3(0), 0),
                                        broken,
                                        endless,
                                        negative,
                                        without_map,
                                        point(vec3(5), 1),
                                        area(vec3(0), vec3(0, 1, 0), 0, 9)};
    const LightPictures all = choose_pictures(lights, 6, kBox, 8);
    ASSERT_EQ(all.count(), 1);
    EXPECT_EQ(all.lights[0].position, vec3(5));
    EXPECT_EQ(all.dark, 4);
    EXPECT_EQ(choose_pictures({}, 0, kBox, 8).count(), 0);
}

// Area times position is beyond the largest float, to both sides.
TEST(LightPictures, AnEndlesslyLargePanelIsLookedFromOneOfItsSamples) {
    std::vector<LightData> lights{area({5, 3, 0}, {0, -1, 0}, 1e38f, 7),
                                  area({-5, 3, 0}, {0, -1, 0}, 1e38f, 7)};
    EXPECT_EQ(choose_pictures(lights, 0, kBox, 8).dark, 1);  // so is its flux
    for (LightData& light : lights) {
        light.intensity = vec3(0.001f);
    }
    const LightPictures all = choose_pictures(lights, 0, kBox, 8);
    ASSERT_EQ(all.count(), 1);
    EXPECT_EQ(all.lights[0].position, vec3(5, 3, 0));
    EXPECT_EQ(all.lights[0].direction, vec3(0, -1, 0));
    EXPECT_EQ(all.lights[0].area, 2e38f);
    EXPECT_FLOAT_EQ(all.lights[0].intensity.g, 0.001f);
}

// The sun's picture is as large as the scene, not as the sphere around it: no sample is wasted beside it.
TEST(LightPictures, TheSunsIsTheScenesOwnSize) {
    LightData sun{};
    sun.type = render::kLightDirectional;
    sun.direction = vec3(0, -1, 0);
    sun.right = vec3(1, 0, 0);
    sun.up = vec3(0, 0, -1);
    sun.position = vec3(0.5f, 10, 0);
    sun.intensity = vec3(1000);
    sun.layers = 1;
    const LightPictures all = choose_pictures(std::vector{sun}, 1, kBox, 8);
    ASSERT_EQ(all.count(), 1);
    EXPECT_EQ(all.shapes[0].shape, kPictureParallel);
    EXPECT_EQ(all.shapes[0].window, vec4(-2.5f, -3, 1.5f, 3));
}

}  // namespace
}  // namespace lanthorn::gi

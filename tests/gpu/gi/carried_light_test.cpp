// Reflections that the plan leaves out, against the path tracer with all of them.
#include <gtest/gtest.h>

#include <cmath>

#include <numeric>
#include <utility>

#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gi/plan.h"
#include "tests/gpu/gi/path_truth.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace carried_light_test {

constexpr ivec2 kPixels(32);
constexpr int kAll = 8;

// A hall with a white block in it, and a lamp.
FrameScene hall(float albedo, const vec3& lamp_at, const vec3& block_at, float block) {
    return scene_of({box(vec3(0), vec3(12, 6, 20), true, 0), box(block_at, block_at + vec3(block), false, 1)},
                    {lambertian(vec3(albedo)), lambertian(vec3(0.9f))}, {point_light(lamp_at, 1000)},
                    vec3(11, 3, 19), vec3(5, 1, 10));
}

// Of all that is seen from two corners: a share of the light is no share of what one dark end shows.
double mean_radiance(FrameScene scene, int bounces) {
    double sum = 0;
    for (const auto& [eye, at] :
         {std::pair(vec3(11, 5, 19), vec3(2, 1, 2)), std::pair(vec3(1, 5, 1), vec3(10, 1, 18))}) {
        support::look(scene, eye, at);
        const Truth truth = path_traced(scene, kPixels, bounces, 64, reference::PathAov::radiance);
        for (const std::vector<float>& half : truth.halves) {
            sum = std::accumulate(half.begin(), half.end(), sum);
        }
    }
    return sum;
}

TEST(CarriedLight, WhatIsLeftOutIsLessThanAHundredthOfThePicture) {
    int left_out = 0;
    for (const float albedo : {0.01f, 0.02f, 0.03f, 0.04f, 0.06f, 0.1f, 0.2f}) {
        for (const vec3& lamp : {vec3(6, 5, 4), vec3(6, 3, 10), vec3(2, 1, 2)}) {
            const FrameScene scene = hall(albedo, lamp, vec3(5, 0.5f, 12), 0.3f);
            const int bounces = useful_bounces(light_bounds(scene).carried, kAll);
            if (bounces < kAll) {
                ++left_out;
                const double kept = mean_radiance(scene, bounces), all = mean_radiance(scene, kAll);
                EXPECT_GT(kept, 0.99 * all) << albedo << ": " << bounces << " reflections";
            }
        }
    }
    EXPECT_GT(left_out, 15) << "the white block keeps nothing";
}

TEST(CarriedLight, ABlockBesideTheLampKeepsWhatItReflects) {
    // The lamp stands close to the block, which then is what lights the hall.
    const FrameScene scene = hall(0.1f, vec3(5.5f, 1.2f, 12.5f), vec3(5, 0, 12), 1);
    const int bounces = useful_bounces(light_bounds(scene).carried, kAll);
    EXPECT_GE(bounces, 2);
    EXPECT_GT(mean_radiance(scene, bounces), 0.99 * mean_radiance(scene, kAll));
}

// RMS of what differs, over the mean.
double relative_difference(const ImageF& a, const ImageF& b) {
    double squares = 0, sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double off = static_cast<double>(a.pixels[i]) - static_cast<double>(b.pixels[i]);
        squares += off * off;
        sum += static_cast<double>(b.pixels[i]);
    }
    return std::sqrt(squares * static_cast<double>(a.pixels.size())) / sum;
}

// They come and go with the lamp, and leave the picture of a technique that has known nothing else.
TEST(CarriedLight, ReflectionsComeAndGoWithoutATrace) {
    const vec3 away(6, 5, 4), beside(5.5f, 1.2f, 12.5f);
    const auto lit_from = [](const vec3& lamp) { return hall(0.01f, lamp, vec3(5, 0, 12), 1); };
    const auto settled = [](Bench& bench, FrameScene& scene) {
        ImageF image;
        for (int i = 0; i < 18; ++i) {
            image = bench.frame(scene, kPixels);
            hold_still(scene);
        }
        return image;
    };
    const auto move_lamp = [](FrameScene& scene, const vec3& to) {
        scene.lights[0].position = to;
        scene.changes.lights = true;
    };
    const auto reflections = [](Bench& bench) { return bench.technique().statistics(false).plan.bounces; };
    Bench kept;
    kept.settings.edit<EmcSettings>().gather_endless = false;
    kept.settings.edit<EmcSettings>().gather_guide = false;  // by light before: rays would be others
    FrameScene scene = lit_from(away);
    settled(kept, scene);
    EXPECT_EQ(reflections(kept), 1);
    move_lamp(scene, beside);
    const ImageF two = settled(kept, scene);
    EXPECT_EQ(reflections(kept), 2);
    move_lamp(scene, away);
    const ImageF one = settled(kept, scene);
    EXPECT_EQ(reflections(kept), 1);
    const auto fresh = [&](const vec3& lamp) {
        Bench bench;
        bench.settings = kept.settings;
        FrameScene first = lit_from(lamp);
        return settled(bench, first);
    };
    EXPECT_LT(relative_difference(two, fresh(beside)), 0.01);
    EXPECT_LT(relative_difference(one, fresh(away)), 0.01);
}

}  // namespace carried_light_test
}  // namespace lanthorn::gi::test

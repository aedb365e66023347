// Blended surfaces (alphaMode BLEND) stop and reflect the share of light that their alpha says.
#include <gtest/gtest.h>

#include <cstdio>

#include "gi_module/shared/rays/embree_rays.h"
#include "lanthorn/emc/emc_settings.h"
#include "tests/gpu/gi/gather_scene.h"
#include "tests/gpu/gi/path_truth.h"

namespace lanthorn::gi::test {
namespace {

constexpr ivec2 kSize(96);
constexpr int kFrames = 6, kSpp = 128;
constexpr int kBounces = 8;  // of the reference; 0.5^8 of the light is left
constexpr vec3 kGreen(0.15f, 0.6f, 0.15f);

// A curtain across x = 0 of 6 x 6 patches, every other one of them of alpha `light`, the rest of `dense`.
Mesh curtain(float light, float dense) {
    constexpr int kPatches = 6;
    Mesh all = quad(vec3(0, 0, 2), vec3(0, 0, -1), vec3(0, 1, 0), 1);
    all.vertices.clear();
    all.indices.clear();
    for (int i = 0; i < kPatches * kPatches; ++i) {
        const int column = i % kPatches, row = i / kPatches;
        const vec3 across(0, 0, -4.0f / kPatches), up(0, 3.0f / kPatches, 0);
        const Mesh patch =
            quad(vec3(0, 0, 2) + static_cast<float>(column) * across + static_cast<float>(row) * up, across,
                 up, 1);
        const auto first = static_cast<std::uint32_t>(all.vertices.size());
        for (Vertex vertex : patch.vertices) {
            vertex.colour.a = (column + row) % 2 == 0 ? light : dense;
            all.vertices.push_back(vertex);
            all.bounds.add(vertex.position);
        }
        for (const std::uint32_t k : patch.indices) {
            all.indices.push_back(first + k);
        }
    }
    return all;
}

// A room of 6 x 3 x 4 m that it parts, with the lamp on the other side.
FrameScene parted_room(const Mesh& middle, AlphaMode mode) {
    Material cloth = lambertian(kGreen);
    cloth.alpha_mode = mode;
    cloth.double_sided = true;
    return scene_of({box(vec3(-3, 0, -2), vec3(3, 3, 2), true, 0), middle}, {lambertian(vec3(0.5f)), cloth},
                    {point_light(vec3(-1.5f, 1.5f, 0), 300)}, vec3(2.8f, 1.6f, 1.5f), vec3(0, 1.2f, -0.5f));
}

void by_default(Bench& bench) {
    add_embree_rays();
    bench.settings.edit<EmcSettings>().final_stage = EmcFinal::gather;
    bench.settings.edit<EmcSettings>().rays = EmcRays::bvh;
    bench.settings.edit<EmcSettings>().gather_source = GatherSource::photons;
}

ImageF shown(const FrameScene& scene) {
    Bench bench;
    by_default(bench);
    return radiance_of(bench, scene, kSize, kFrames);
}

// Leaves and fences that an exporter calls BLEND.
TEST(Blended, WhatIsClearOrSolidLooksAsIfItWereMasked) {
    const Mesh holes = curtain(0, 1);
    EXPECT_EQ(shown(parted_room(holes, AlphaMode::blend)).pixels,
              shown(parted_room(holes, AlphaMode::mask)).pixels);
}

TEST(Blended, IndirectLightIsWhatPathFinds) {
    const FrameScene scene = parted_room(curtain(0.3f, 0.7f), AlphaMode::blend);
    Bench bench;
    by_default(bench);
    const ImageF image = still_picture(bench, scene, kFrames, kSize);
    const Deviation off = against(image, path_traced(scene, kSize, kBounces, kSpp));
    std::printf("a curtain: flux %.3f, relRMSE %.3f\n", off.mean, off.rel_rmse);
    EXPECT_NEAR(off.mean, 1, 0.03);
    EXPECT_LT(off.rel_rmse, 0.12);
}

// A curtain that hides nearly all of the lit half: it is lit by what falls on the side that is seen, not by
// what falls on the walls behind it.
TEST(Blended, ADenseCurtainIsLitFromItsOwnSide) {
    const FrameScene scene = parted_room(curtain(0.9f, 0.9f), AlphaMode::blend);
    const Truth truth = path_traced(scene, kSize, kBounces, kSpp, reference::PathAov::radiance);
    const Deviation off = against(shown(scene), truth);
    std::printf("a dense curtain: flux %.3f, relRMSE %.3f\n", off.mean, off.rel_rmse);
    EXPECT_NEAR(off.mean, 1, 0.05);
    EXPECT_LT(off.rel_rmse, 0.2);
}

// The little that a dense curtain lets through is bounced on: photons find the same openings in every map.
TEST(Blended, PhotonsPassADenseCurtainAsAlphaSays) {
    FrameScene scene = parted_room(curtain(0.9f, 0.9f), AlphaMode::blend);
    support::look(scene, vec3(0.3f, 1.5f, 0), vec3(3, 1.5f, 0));  // from before the curtain
    const Truth truth = path_traced(scene, kSize, kBounces, kSpp);
    for (const EmcRays rays : {EmcRays::bvh, EmcRays::maps}) {
        Bench bench;
        by_default(bench);
        bench.settings.edit<EmcSettings>().rays = rays;
        const Deviation off = against(still_picture(bench, scene, kFrames, kSize), truth);
        const bool maps = rays == EmcRays::maps;
        std::printf("behind a dense curtain, %s: flux %.3f, relRMSE %.3f\n", maps ? "maps" : "exact rays",
                    off.mean, off.rel_rmse);
        EXPECT_NEAR(off.mean, 1, maps ? 0.15 : 0.08);
        EXPECT_LT(off.rel_rmse, maps ? 0.15 : 0.1);
    }
}

// What is left of the lamp's own light behind it.
TEST(Blended, ShadowsAreAsDenseAsAlphaSays) {
    const auto direct = [](float alpha) {
        Bench bench;
        by_default(bench);
        FrameScene scene = parted_room(curtain(alpha, alpha), AlphaMode::blend);
        support::look(scene, vec3(0.3f, 1.5f, 0), vec3(3, 1.5f, 0));  // from before the curtain
        still_picture(bench, scene, 1, kSize);
        return mean_of(bench.renderer().read(render::Aov::direct));
    };
    const double open = direct(0);
    for (const float alpha : {0.25f, 0.5f, 0.9f, 1.0f}) {
        const double passes = direct(alpha) / open;
        std::printf("alpha %.2f: %.4f of the light passes\n", static_cast<double>(alpha), passes);
        EXPECT_NEAR(passes, 1 - static_cast<double>(alpha), 0.02);
    }
}

TEST(Blended, ACurtainThatIsDrawnStaysFinite) {
    Bench bench;
    by_default(bench);
    FrameScene scene = parted_room(curtain(0.3f, 1), AlphaMode::blend);
    double before = mean_of(bench.frame(scene, kSize));
    for (int f = 1; f <= 6; ++f) {
        hold_still(scene);
        move_instance(scene, 1, glm::translate(mat4(1), vec3(0, 0.4f * static_cast<float>(f), 0)));
        const double now = mean_of(bench.frame(scene, kSize));
        EXPECT_GT(now, 0.9 * before) << "more light comes with every step";
        before = now;
    }
}

}  // namespace
}  // namespace lanthorn::gi::test

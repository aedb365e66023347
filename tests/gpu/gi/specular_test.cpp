// What mirrors and glass show, against what is known on paper: a mirror's picture is what a camera behind it
// sees, a window's is what stands behind it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "lanthorn/render/brdf_table.h"
#include "tests/gpu/gi/path_truth.h"
#include "tests/gpu/gi/specular_room.h"

namespace lanthorn::gi::test {
namespace {

SkyInstance even_sky() {
    SkyImage image;
    image.width = 8;
    image.height = 4;
    image.radiance.assign(32, vec3(kNits));
    SkyInstance sky;
    sky.sky.image = std::make_shared<const SkyImage>(std::move(image));
    return sky;
}

std::string name_of(const ::testing::TestParamInfo<EmcRays>& info) {
    return info.param == EmcRays::maps ? "maps" : "bvh";
}

INSTANTIATE_TEST_SUITE_P(Rays, Specular, ::testing::Values(EmcRays::maps, EmcRays::bvh), name_of);

TEST(BrdfTable, ReflectsNoMoreThanArrives) {
    for (const float nv : {0.0f, 0.1f, 0.5f, 1.0f}) {
        for (const float roughness : {0.0f, 0.3f, 0.7f, 1.0f}) {
            const vec2 share = render::brdf_share(nv, roughness);
            EXPECT_LE(share.x + share.y, 1.001f) << nv << ' ' << roughness;
            EXPECT_GT(share.x + share.y, 0.3f) << nv << ' ' << roughness;
            // A white dielectric, its diffuse part and its lobe together.
            for (const float f0 : {0.0f, 0.04f, 0.25f, 1.0f}) {
                const float f90 = std::min(50 * f0, 1.0f);
                const float out = f0 + (f90 - f0) * std::pow(1 - nv, 5.0f), in = f0 + (f90 - f0) / 21;
                EXPECT_LE(f0 * share.x + f90 * share.y + (1 - out) * (1 - in), 1.0f)
                    << nv << ' ' << roughness << ' ' << f0;
            }
        }
    }
    // A mirror reflects all of it: Schlick's reflectance and nothing else.
    const vec2 mirror = render::brdf_share(0.5f, 0);
    EXPECT_NEAR(mirror.x, 1 - std::pow(0.5f, 5.0f), 0.01f);
    EXPECT_NEAR(mirror.y, std::pow(0.5f, 5.0f), 0.01f);
}

// Under an even sky every lobe sees the same, traced or not: brdf_share() says how much comes back.
TEST_P(Specular, AMetalFloorUnderAnEvenSkyReflectsItsShare) {
    for (const float roughness : {0.0f, 0.2f, 0.45f, 1.0f}) {
        FrameScene scene =
            scene_of({quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, 0)}, {metal(vec3(0.9f, 0.6f, 0.3f), roughness)},
                     {}, vec3(0, 2, 0.01f), vec3(0));
        scene.camera.camera.y_fov = 0.5f;
        scene.sky = even_sky();
        const vec3 got = middle_of(picture(scene));
        const vec2 share = render::brdf_share(1, roughness);
        for (int c = 0; c < 3; ++c) {
            const float base = vec3(0.9f, 0.6f, 0.3f)[c];
            EXPECT_NEAR(got[c] / kNits, base * share.x + share.y, 0.015f) << roughness << ' ' << c;
        }
    }
}

// The mirror fills the wall at x = 4; the same room from behind it, with the wall away, is its picture.
TEST_P(Specular, AMirrorShowsWhatACameraBehindItSees) {
    const Material mirror = metal(vec3(1), 0);
    const vec3 eye(2.6f, 1.3f, 1.5f), target(4, 1.0f, 1.75f);
    const ImageF shown =
        picture(room({quad({3.99f, 0, 0}, {0, 0, 3}, {0, 2.6f, 0}, 0)}, {mirror}, eye, target), 3);
    const vec3 flip(-1, 1, 1), behind(2 * 3.99f, 0, 0);
    const ImageF direct = picture(room({}, {}, eye * flip + behind, target * flip + behind, false));
    ImageF mirrored = direct;
    for (int y = 0; y < direct.height; ++y) {
        for (int x = 0; x < direct.width; ++x) {
            for (int c = 0; c < 3; ++c) {
                const int to = 3 * (y * direct.width + x) + c;
                const int from = 3 * (y * direct.width + direct.width - 1 - x) + c;
                mirrored.pixels[static_cast<std::size_t>(to)] = direct.pixels[static_cast<std::size_t>(from)];
            }
        }
    }
    const Deviation d = against(shown, mirrored.pixels);
    std::printf("mirror: flux %.4f, relRMSE %.4f\n", d.mean, d.rel_rmse);
    EXPECT_NEAR(d.mean, 1, 0.03);
    EXPECT_LT(d.rel_rmse, GetParam() == EmcRays::bvh ? 0.06 : 0.1);
}

// A panel of rough metal reflects as much in a mirror as seen from behind it: its lobe counts once.
TEST_P(Specular, RoughMetalInAMirrorIsAsBrightAsBesideIt) {
    const Material mirror = metal(vec3(1), 0), rough = metal(vec3(0.8f, 0.7f, 0.5f), 0.7f);
    const Mesh panel = quad({0.01f, 0, 0}, {0, 2.6f, 0}, {0, 0, 3}, 0);
    Mesh behind_mirror = panel;
    behind_mirror.material = 1;
    const vec3 eye(2.6f, 1.3f, 1.5f), target(4, 1.2f, 1.6f);
    const ImageF shown = picture(
        room({quad({3.99f, 0, 0}, {0, 0, 3}, {0, 2.6f, 0}, 0), behind_mirror}, {mirror, rough}, eye, target),
        3);
    const vec3 flip(-1, 1, 1), behind(2 * 3.99f, 0, 0);
    const ImageF direct = picture(room({panel}, {rough}, eye * flip + behind, target * flip + behind, false));
    double in_mirror = 0, beside = 0;
    for (std::size_t i = 0; i < shown.pixels.size(); ++i) {
        in_mirror += static_cast<double>(shown.pixels[i]);
        beside += static_cast<double>(direct.pixels[i]);
    }
    std::printf("rough metal in a mirror: %.4f of what is seen from behind it\n", in_mirror / beside);
    EXPECT_NEAR(in_mirror / beside, 1, 0.1)
        << "what a lobe shows depends on the view, in the mirror it does not";
}

// Straight through, less what its surface reflects.
TEST_P(Specular, AThinWindowShowsWhatStandsBehindIt) {
    const Pane pane(kPaneEye, kPaneTarget);
    const ImageF through = picture(room({quad(pane.corner, pane.right, pane.up, 0)},
                                        {Pane::material(vec3(0.5f))}, kPaneEye, kPaneTarget),
                                   3);
    ImageF direct = picture(room({}, {}, kPaneEye, kPaneTarget));
    std::ranges::for_each(direct.pixels, [](float& nits) { nits *= 0.5f; });
    const Deviation d = against(through, direct.pixels);
    std::printf("window: flux %.4f, relRMSE %.4f\n", d.mean, d.rel_rmse);
    EXPECT_NEAR(d.mean, 1, 0.05);
    EXPECT_LT(d.rel_rmse, GetParam() == EmcRays::bvh ? 0.08 : 0.16);
}

// A block of index 1 bends no light and reflects none; what it absorbs is Beer's law.
TEST_P(Specular, ABlockOfGlassAbsorbsByItsThickness) {
    if (GetParam() == EmcRays::maps) {
        GTEST_SKIP() << "to the maps glass is as thin as a sheet";
    }
    Material block = glass(1, 1);
    block.attenuation_distance = 0.5f;
    block.attenuation_colour = vec3(0.5f, 1, 0.25f);
    FrameScene scene =
        scene_of({box({-1, 0.2f, -1}, {1, 0.7f, 1}, false, 0), quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, 1)},
                 {block, lamp(vec3(kNits))}, {}, vec3(0, 2.4f, 0.01f), vec3(0));
    scene.camera.camera.y_fov = 0.2f;
    const vec3 got = middle_of(picture(scene));
    EXPECT_NEAR(got.x, 0.5f * kNits, 1);
    EXPECT_NEAR(got.y, 1.0f * kNits, 1);
    EXPECT_NEAR(got.z, 0.25f * kNits, 1);
}

// What shines within water is darker from above by the square of its index.
TEST_P(Specular, WhatLiesInWaterIsDarkerByItsIndexSquared) {
    if (GetParam() == EmcRays::maps) {
        GTEST_SKIP() << "to the maps water is as thin as a sheet";
    }
    Material water = glass(1.33f, 1);
    water.double_sided = true;
    FrameScene scene =
        scene_of({quad({-2, 0.5f, 2}, {4, 0, 0}, {0, 0, -4}, 0), quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, 1)},
                 {water, lamp(vec3(kNits))}, {}, vec3(0, 2.4f, 0.01f), vec3(0));
    scene.camera.camera.y_fov = 0.2f;
    const float r = (0.33f / 2.33f) * (0.33f / 2.33f);
    EXPECT_NEAR(middle_of(picture(scene)).x, kNits * (1 - r) / (1.33f * 1.33f), 1);
}

// A slab under a lamp, over nothing: its lower side mirrors as its upper side does, 2 R / (1 + R) together.
TEST_P(Specular, ASlabOfGlassMirrorsWithBothSides) {
    if (GetParam() == EmcRays::maps) {
        GTEST_SKIP() << "to the maps glass is as thin as a sheet";
    }
    FrameScene scene =
        scene_of({box({-1, 0.2f, -1}, {1, 0.4f, 1}, false, 0), quad({-2, 3, -2}, {4, 0, 0}, {0, 0, 4}, 1)},
                 {glass(1.5f, 0.2f), lamp(vec3(kNits))}, {}, vec3(0, 2.4f, 0.01f), vec3(0));
    scene.camera.camera.y_fov = 0.2f;
    EXPECT_NEAR(middle_of(picture(scene)).y, kNits * 2 * 0.04f / 1.04f, 0.1f);
}

TEST_P(Specular, NothingIsTracedWhereNothingShinesNorChanges) {
    const auto entry = [](Bench& bench) {
        for (const PlanEntry& e : bench.technique().statistics(false).plan.entries) {
            if (e.pass == "specular") {
                return e;
            }
        }
        return PlanEntry{};
    };
    Bench bench;
    bench.settings = settings();
    FrameScene dull = room({}, {}, vec3(3, 1.3f, 2), vec3(1));
    bench.frame(dull, kSize);
    EXPECT_FALSE(entry(bench).on);
    FrameScene scene = room({quad({3.99f, 0, 0}, {0, 0, 3}, {0, 2.6f, 0}, 0)}, {metal(vec3(1), 0)},
                            vec3(2, 1.3f, 2), vec3(4, 1, 1));
    Bench shiny;
    shiny.settings = settings();
    shiny.frame(scene, kSize);
    EXPECT_TRUE(entry(shiny).on);
    hold_still(scene);
    scene.lights[0].light.intensity *= 2;
    scene.changes.lights = true;
    const ImageF before = shiny.renderer().read(render::Aov::radiance);
    shiny.frame(scene, kSize);
    EXPECT_EQ(entry(shiny).size, "no ray");  // lit anew alone
    EXPECT_NEAR(middle_of(shiny.renderer().read(render::Aov::radiance)).x / middle_of(before).x, 2, 0.1);
    hold_still(scene);
    for (int f = 0; f < 20; ++f) {
        shiny.frame(scene, kSize);
    }
    EXPECT_FALSE(entry(shiny).on);
}

}  // namespace
}  // namespace lanthorn::gi::test

// `drm` while things move, and while nothing does.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/gpu/drm/drm_bench.h"
#include "tests/gpu/gi/settings_walk.h"

namespace lanthorn::gi::test {
namespace {

constexpr ivec2 kSize(96);

std::set<std::string> passes_of(const Bench& bench) {
    std::set<std::string> names;
    for (const gpu::PassTimer::Span& span : bench.spans) {
        names.insert(span.name);
    }
    return names;
}

FrameScene lit_by(std::vector<LightInstance> lights) {
    FrameScene scene = room_with_block();
    scene.lights = std::move(lights);
    for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
        scene.lights[i].id = 1000 + i;
    }
    return scene;
}

TEST(DrmDynamics, NothingMovesAndNothingIsDone) {
    DrmBench bench;
    FrameScene scene = room_with_block();
    const ImageF first = bench.frame(scene, kSize, true);
    EXPECT_TRUE(passes_of(bench).contains("samples") && passes_of(bench).contains("gather"));
    hold_still(scene);
    for (int i = 0; i < 3; ++i) {
        const ImageF again = bench.frame(scene, kSize, true);
        EXPECT_EQ(again.pixels, first.pixels);
        EXPECT_FALSE(passes_of(bench).contains("samples") || passes_of(bench).contains("gather"));
        EXPECT_FALSE(bench.now().sampled || bench.now().gathered);
    }
}

// Whatever changes, the picture is that of a technique that has seen nothing else.
TEST(DrmDynamics, WhatChangesIsFollowed) {
    DrmBench bench;
    FrameScene scene = room_with_block();
    bench.frame(scene, kSize);
    const auto follow = [&](const char* what) {
        const ImageF followed = bench.frame(scene, kSize);
        FrameScene anew = scene;
        anew.changes = SceneChanges();
        for (std::uint32_t i = 0; i < anew.instances.size(); ++i) {
            anew.changes.moved.push_back(i);
        }
        anew.changes.dirty = anew.bounds;
        DrmBench fresh;
        EXPECT_EQ(followed.pixels, fresh.frame(anew, kSize).pixels) << what;
        hold_still(scene);
    };
    hold_still(scene);
    scene.lights[0].position = vec3(3.2f, 2.0f, 1.2f);
    scene.changes.lights = true;
    follow("a lamp moves");
    scene.lights[0].light.colour = vec3(0.2f, 1, 0.4f);
    scene.changes.lights = true;
    follow("its colour changes");
    move_instance(scene, 1, glm::translate(mat4(1), vec3(0.7f, 0, -0.3f)));
    follow("the block moves");
    support::look(scene, vec3(0.3f, 2.2f, 0.4f), vec3(2, 1, 1.5f));
    scene.changes.camera = true;
    follow("the camera moves");
}

TEST(DrmDynamics, SeveralLightsAddUp) {
    const LightInstance lamp = point_light(vec3(0.6f, 2.2f, 1.5f), 100);
    const LightInstance spot = spot_light(vec3(3.3f, 2.3f, 0.5f), vec3(-0.4f, -1, 0.3f), 200, 0.7f);
    const LightInstance sun = support::directional_light(vec3(0.2f, -1, 0.1f), 50);
    const auto light = [](const FrameScene& scene) {
        DrmBench bench;
        return bench.frame(scene, kSize).pixels;
    };
    const auto all = light(lit_by({lamp, spot, sun}));
    const auto a = light(lit_by({lamp})), b = light(lit_by({spot})), c = light(lit_by({sun}));
    double most = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_NEAR(all[i], a[i] + b[i] + c[i], 1e-4f * all[i] + 1e-4f);
        most = std::max(most, static_cast<double>(b[i]));
    }
    EXPECT_GT(most, 1);
}

TEST(DrmDynamics, LightsBeyondTheLimitAreLeftOutAndCounted) {
    DrmBench bench;
    bench.drm().lights = 2;
    const auto dim = [](float x) { return point_light(vec3(x, 2.2f, 0.4f), 1); };
    bench.frame(lit_by({dim(1), point_light(vec3(2, 2.2f, 2.4f), 100), dim(3), dim(3.5f)}), kSize);
    EXPECT_EQ(bench.now().pictures, 2);
    EXPECT_EQ(bench.now().left_out, 2);
    EXPECT_EQ(bench.now().samples, 18);
}

// Sudden changes of a pixel while the lamp goes past the block's edges: the second difference over frames,
// root mean square over the mean.
double flicker(DrmMips mips) {
    DrmBench bench;
    bench.drm().mips = mips;
    FrameScene scene = room_with_block();
    std::vector<float> before, last;
    double squares = 0, sum = 0, n = 0;
    for (int i = 0; i < 64; ++i) {
        scene.lights[0].position = vec3(0.4f + 0.03f * static_cast<float>(i), 2.0f, 1.1f);
        const std::vector<float> now = bench.frame(scene, ivec2(32)).pixels;
        for (std::size_t k = 0; k < before.size(); ++k) {
            const auto jump = static_cast<double>(now[k] - 2 * last[k] + before[k]);
            squares += jump * jump;
            sum += static_cast<double>(now[k]);
            n += 1;
        }
        before = std::exchange(last, now);
        hold_still(scene);
        scene.changes.lights = true;
    }
    return std::sqrt(squares / n) / (sum / n);
}

TEST(DrmDynamics, MeansFlickerLessThanSinglePoints) {
    const double all = flicker(DrmMips::all), light = flicker(DrmMips::light), none = flicker(DrmMips::none);
    std::printf("drm, flicker of a moving lamp: mips all %.5f, light %.5f, none %.5f\n", all, light, none);
    EXPECT_LT(all, 0.8 * none);
}

TEST(DrmDynamics, ChangedSettingsGiveThePictureOfAFreshTechnique) {
    add_drm();
    const auto altered = walk_settings(room_with_block(), {"gi.technique=drm"}, 2);
    for (const char* name :
         {"gi.technique", "gi.drm.samples", "gi.drm.solid_angle", "gi.drm.mips", "gi.drm.texels"}) {
        EXPECT_TRUE(std::ranges::find(altered, name) != altered.end()) << name;
    }
    for (const char* name : {"gi.seed", "gi.bounces", "gi.photons", "gi.drm.lights", "gi.drm.mirrors"}) {
        EXPECT_TRUE(std::ranges::find(altered, name) == altered.end()) << name;
    }
}

}  // namespace
}  // namespace lanthorn::gi::test

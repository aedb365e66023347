// `drm` while things move, and while nothing does.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/transforms.h"
#include "tests/gpu/drm/drm_bench.h"
#include "tests/gpu/gi/settings_walk.h"
#include "tests/support/repository.h"

namespace lanthorn::gi::test {
namespace drm_dynamics_test {

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

// Sudden changes of a pixel while the first lamp goes along x from where it is, `step` metres a frame: the
// second difference over frames, root mean square over the mean.
double flicker(FrameScene scene, DrmMips mips, int frames, float step) {
    DrmBench bench;
    bench.drm().mips = mips;
    const vec3 from = scene.lights[0].position;
    std::vector<float> before, last;
    double squares = 0, sum = 0, n = 0;
    for (int i = 0; i < frames; ++i) {
        scene.lights[0].position = from + vec3(step * static_cast<float>(i), 0, 0);
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

// Past the block's edges.
TEST(DrmDynamics, MeansFlickerLessThanSinglePoints) {
    const auto flickers = [](DrmMips mips) {
        return flicker(room_with_block(vec3(0.4f, 2.0f, 1.1f)), mips, 64, 0.03f);
    };
    const double all = flickers(DrmMips::all), light = flickers(DrmMips::light),
                 none = flickers(DrmMips::none), radiance = flickers(DrmMips::radiance);
    std::printf("drm, flicker of a moving lamp: mips all %.5f, light %.5f, none %.5f, radiance %.5f\n", all,
                light, none, radiance);
    EXPECT_LT(all, 0.8 * none);
    EXPECT_LT(all, 0.8 * radiance);
}

FrameScene scene_in(const char* file) {
    ecs::World world;
    spawn(world, import_gltf(support::repository_file(file)));
    Transforms().update(world);
    return Extractor().extract(world, find_by_name(world, "camera"));
}

// A lamp beneath the ceiling, instead of the panel; both blocks in its way.
TEST(DrmDynamics, MeansFlickerLessInCornellUnderAPointLamp) {
    FrameScene scene = scene_in("assets/cornell.glb");
    const Aabb room = scene.bounds;
    scene.lights = {point_light(room.lower + room.size() * vec3(0.25f, 0.85f, 0.6f), 10)};
    scene.lights[0].id = 1000;
    const float step = 0.006f * room.size().x;
    const double all = flicker(scene, DrmMips::all, 48, step), none = flicker(scene, DrmMips::none, 48, step);
    std::printf("drm, flicker in cornell: mips all %.5f, none %.5f\n", all, none);
    EXPECT_LT(all, none);
}

// The lantern, whose light small rocks and the figure stand close to.
TEST(DrmDynamics, MeansFlickerFarLessInTheCave) {
    const FrameScene scene = scene_in("assets/cave.glb");
    ASSERT_FALSE(scene.lights.empty());
    const double all = flicker(scene, DrmMips::all, 12, 0.03f),
                 none = flicker(scene, DrmMips::none, 12, 0.03f);
    std::printf("drm, flicker in the cave: mips all %.5f, none %.5f\n", all, none);
    EXPECT_LT(all, 0.5 * none);
}

TEST(DrmDynamics, ChangedSettingsGiveThePictureOfAFreshTechnique) {
    add_drm();
    const auto altered = walk_settings(room_with_block(), {"gi.technique=drm"}, 2);
    for (const char* name : {"gi.technique", "gi.drm.samples", "gi.drm.solid_angle", "gi.drm.mips",
                             "gi.drm.texels", "gi.drm.visibility", "gi.drm.second"}) {
        EXPECT_TRUE(std::ranges::find(altered, name) != altered.end()) << name;
    }
    for (const char* name : {"gi.seed", "gi.bounces", "gi.photons", "gi.drm.lights", "gi.drm.mirrors"}) {
        EXPECT_TRUE(std::ranges::find(altered, name) == altered.end()) << name;
    }
}

}  // namespace drm_dynamics_test
}  // namespace lanthorn::gi::test

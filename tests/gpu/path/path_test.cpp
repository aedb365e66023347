// `path` in an App, against the path tracer that it is.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "engine/gpu/memory.h"
#include "gi_module/techniques/path/path.h"
#include "gi_module/techniques/path/path_statistics.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/reference/path_tracer.h"
#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/spawn.h"
#include "lanthorn/scene/transforms.h"
#include "tests/gpu/gi/block_room.h"
#include "tests/gpu/gi/sensor_room.h"
#include "tests/gpu/gi/settings_walk.h"
#include "tests/support/repository.h"

namespace lanthorn::gi::test {
namespace {

using reference::PathSettings;

constexpr ivec2 kSize(48, 32);

// A Bench of this technique; tells the door of it first.
struct Paths : Bench {
    Paths() : Bench(add_path()) { own().transport = reference::Transport::diffuse; }
    PathStatistics now(bool report = false) { return technique().statistics(report).of<PathStatistics>(); }
    PathSettings& own() { return settings.edit<PathSettings>(); }
};

FrameScene asset(const std::string& name) {
    ecs::World world;
    spawn(world, import_gltf(support::repository_file("assets/" + name + ".glb")));
    Transforms().update(world);
    return Extractor().extract(world, find_by_name(world, "camera"));
}

ImageF traced(const FrameScene& scene, const GiSettings& settings, int spp) {
    PathSettings own = settings.of<PathSettings>();
    own.bounces = settings.bounces;
    own.seed = settings.seed;
    own.spp = spp;
    reference::PathTracer tracer(scene, kSize, own, {.indirect = true});
    tracer.render({});
    return {kSize.x, kSize.y, 3, tracer.image(reference::PathAov::indirect), {}};
}

// Pixels that differ. The App's acceleration structure is made for what moves, the tracer's for speed: where
// two triangles are met at the same distance, on a shared edge, each may name the other.
std::size_t other_pixels(const ImageF& a, const ImageF& b) {
    EXPECT_EQ(a.pixels.size(), b.pixels.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); i += 3) {
        count += std::equal(&a.pixels[i], &a.pixels[i] + 3, &b.pixels[i]) ? 0 : 1;
    }
    return count;
}

ImageF after(Paths& bench, FrameScene& scene, int frames) {
    ImageF image;
    for (int i = 0; i < frames; ++i) {
        image = bench.frame(scene, kSize);
        hold_still(scene);
    }
    return image;
}

TEST(Path, HasThePathTracersSamplesFrameByFrame) {
    for (const reference::Transport transport : {reference::Transport::diffuse, reference::Transport::full}) {
        Paths bench;
        bench.settings.seed = 5;
        bench.own().transport = transport;
        FrameScene scene = asset("cornell");
        const FrameScene still = scene;
        EXPECT_EQ(other_pixels(after(bench, scene, 1), traced(still, bench.settings, 1)), 0u);
        EXPECT_EQ(other_pixels(after(bench, scene, 6), traced(still, bench.settings, 7)), 0u);
        EXPECT_EQ(bench.now().spp, 7);
        bench.own().frame_spp = 9;  // no reason to begin again
        EXPECT_EQ(other_pixels(after(bench, scene, 1), traced(still, bench.settings, 16)), 0u);
        EXPECT_EQ(bench.now().frame_spp, 9);
    }
}

// Mirrors and glass, which irradiance does not show: the frame's picture is the tracer's own.
TEST(Path, ShowsTheTracersWholePicture) {
    for (const char* name : {"glass-ball", "mirror-balls", "dimpled"}) {
        SCOPED_TRACE(name);
        Paths bench;
        bench.own() = {};
        FrameScene scene = asset(name);
        const FrameScene still = scene;
        after(bench, scene, 4);
        const ImageF shown = bench.renderer().read(render::Aov::radiance);
        PathSettings own;
        own.spp = 4;
        own.seed = bench.settings.seed;
        reference::PathTracer tracer(still, kSize, own, {.radiance = true});
        tracer.render({});
        const ImageF wanted{kSize.x, kSize.y, 3, tracer.image(reference::PathAov::radiance), {}};
        EXPECT_LE(other_pixels(shown, wanted), wanted.pixels.size() / 300);
        double sum = 0, sum_wanted = 0;
        for (std::size_t i = 0; i < wanted.pixels.size(); ++i) {
            sum += static_cast<double>(shown.pixels[i]);
            sum_wanted += static_cast<double>(wanted.pixels[i]);
        }
        EXPECT_NEAR(sum / sum_wanted, 1, 0.002);
        EXPECT_GT(sum, 0);
        bench.own().transport = reference::Transport::diffuse;
        after(bench, scene, 1);
        EXPECT_GT(other_pixels(bench.renderer().read(render::Aov::radiance), wanted), 100u)
            << "diffuse transport composes it";
        EXPECT_EQ(bench.now().spp, 1);
    }
}

TEST(Path, SpreadsSamplesOverPixelsAsThePathTracerDoes) {
    Paths bench;
    bench.own().antialias = true;
    FrameScene scene = asset("cornell");
    const FrameScene still = scene;
    EXPECT_EQ(other_pixels(after(bench, scene, 4), traced(still, bench.settings, 4)), 0u);
}

TEST(Path, StopsAtItsSamples) {
    Paths bench;
    bench.own().spp = 5;
    bench.own().frame_spp = 2;
    FrameScene scene = room_with_block(2);
    const ImageF done = after(bench, scene, 3);
    EXPECT_EQ(bench.now().spp, 5);
    EXPECT_EQ(bench.now().frame_spp, 1);
    EXPECT_TRUE(bench.technique().statistics(false).plan.on("paths"));
    EXPECT_EQ(after(bench, scene, 2).pixels, done.pixels);
    EXPECT_EQ(bench.now().spp, 5);
    EXPECT_FALSE(bench.technique().statistics(false).plan.on("paths"));
    EXPECT_GT(bench.now(true).noise, 0);
}

TEST(Path, StopsAtItsNoise) {
    Paths bench;
    bench.own().spp = 10'000;
    bench.own().frame_spp = 1000;
    bench.own().target_noise = 0.3f;
    FrameScene scene = room_with_block(2);
    int frames = 0;
    do {
        after(bench, scene, 1);
    } while (bench.now().frame_spp > 0 && ++frames < 100);
    EXPECT_LT(bench.now().spp, 10'000);
    EXPECT_LE(bench.now(true).noise, 0.3);
}

TEST(Path, WhatChangesBeginsItAgain) {
    Paths bench;
    FrameScene scene = room_with_block(2);
    const auto begins_again = [&](const char* what) {
        after(bench, scene, 1);
        EXPECT_EQ(bench.now().spp, 1) << what;
        EXPECT_EQ(other_pixels(after(bench, scene, 2), traced(scene, bench.settings, 3)), 0u) << what;
    };
    begins_again("first");

    scene.lights[0].position += vec3(0.2f, 0, 0.1f);
    scene.changes.lights = true;
    begins_again("light");

    move_instance(scene, static_cast<std::uint32_t>(scene.instances.size() - 1),
                  glm::translate(mat4(1), vec3(0.1f, 0, 0.2f)));
    begins_again("geometry");
    EXPECT_EQ(bench.now().builds, 1u);  // refitted

    scene.camera.position += vec3(0, 0.1f, 0);
    scene.camera.view = glm::translate(scene.camera.view, vec3(0, -0.1f, 0));
    scene.changes.camera = true;
    begins_again("camera");

    bench.settings.bounces = 1;
    begins_again("bounces");
    bench.settings.seed = 99;
    begins_again("seed");
}

TEST(Path, ChangedSettingsGiveThePictureOfAFreshTechnique) {
    add_path();
    const auto altered =
        walk_settings(room_with_block(2),
                      {"gi.technique=path", "path.transport=diffuse", "path.spp=6", "path.frame_spp=2"}, 6);
    for (const char* name : {"gi.technique", "gi.bounces", "gi.seed", "path.spp", "path.antialias"}) {
        EXPECT_TRUE(std::ranges::find(altered, name) != altered.end()) << name;
    }
    EXPECT_TRUE(std::ranges::find(altered, "path.threads") == altered.end());
}

TEST(Path, ItsMemoryDoesNotGrow) {
    Paths bench;
    FrameScene scene = room_with_block(2);
    after(bench, scene, 2);
    const std::size_t before = gpu::allocated_bytes();
    for (int i = 0; i < 10; ++i) {
        scene.changes.lights = i % 3 == 0;
        after(bench, scene, 1);
    }
    EXPECT_EQ(gpu::allocated_bytes(), before);
}

TEST(Path, LightsSensors) {
    Paths colour;
    expect_the_colour_of_bounced_light(colour, 0.05);
    Paths bench, fresh;
    expect_other_light_to_be_told(bench, fresh);
}

TEST(Path, ALampThatGoesOutTakesItsLightWithIt) {
    Paths bench;
    FrameScene scene = room_with_block(2);
    after(bench, scene, 2);
    const std::vector<LightInstance> lights = std::exchange(scene.lights, {});
    scene.changes.lights = true;
    const ImageF dark = after(bench, scene, 1);
    EXPECT_TRUE(std::ranges::all_of(dark.pixels, [](float v) { return v == 0; }));
    scene.lights = lights;
    scene.changes.lights = true;
    EXPECT_EQ(other_pixels(after(bench, scene, 1), traced(scene, bench.settings, 1)), 0u);
}

}  // namespace
}  // namespace lanthorn::gi::test

// Frames give the GPU work and go on: none waits for what it has asked for itself, and none allocates what an
// earlier one has needed already, whatever moves.
#include <gtest/gtest.h>

#include "gi_module/techniques/emc/emc_technique.h"
#include "lanthorn/emc/emc_settings.h"
#include "tests/gpu/gi/gl_calls.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace {

constexpr ivec2 kSize(96, 64);
constexpr int kFirstMotion =
    12;  // frames until everything has happened once: a map exchanged, rays guided anew

// A room with a block that moves and a lamp.
FrameScene room() {
    return scene_of({box(vec3(0), vec3(4, 2.6f, 4), true, 0), box(vec3(-0.3f), vec3(0.3f), false, 1)},
                    {lambertian(vec3(0.6f)), lambertian(vec3(0.7f, 0.3f, 0.2f))},
                    {point_light(vec3(2, 2.2f, 2), 100)}, vec3(3.6f, 1.6f, 3.6f), vec3(1, 0.8f, 1));
}

void place_block(FrameScene& scene, int frame) {
    move_instance(scene, 1, glm::translate(mat4(1), vec3(1 + 0.05f * static_cast<float>(frame), 0.8f, 1.5f)));
}

void turn_camera(FrameScene& scene, int frame) {
    support::look(scene, vec3(3.6f, 1.6f, 3.6f), vec3(1, 0.8f, 1 + 0.02f * static_cast<float>(frame)));
    scene.changes.camera = true;
}

class FrameWaits : public testing::TestWithParam<EmcFinal> {};

std::string in_words(const GlCalls::Counts& counts) {
    std::string words;
    for (const auto& [name, count] : counts) {
        words += name + " x " + std::to_string(count) + ", ";
    }
    return words;
}

TEST_P(FrameWaits, NoFrameWaitsForItsOwnWork) {
    Bench bench;
    bench.settings.edit<EmcSettings>().final_stage = GetParam();
    bench.settings.edit<EmcSettings>().rays = EmcRays::maps;
    FrameScene scene = room();
    place_block(scene, 0);
    bench.show(scene, kSize);  // chooses the maps, which waits
    GlCalls calls;
    for (int frame = 1; frame < 25; ++frame) {
        hold_still(scene);
        if (frame < 20) {
            place_block(scene, frame);
        }
        if (frame % 3 == 0) {
            turn_camera(scene, frame);
        }
        if (frame % 4 == 0) {
            scene.lights.front().light.intensity *= 1.01f;
            scene.changes.lights = true;
        }
        if (frame == 10) {
            bench.settings.edit<EmcSettings>().gather_rays *= 2;  // none is remembered: they are guided anew
        }
        calls.next_frame();
        bench.show(scene, kSize);
        EXPECT_EQ(in_words(calls.waits()), "") << "frame " << frame;
        if (frame > kFirstMotion) {
            EXPECT_EQ(in_words(calls.allocations()), "") << "frame " << frame;
        }
    }
    for (int frame = 25; frame < 45; ++frame) {
        hold_still(scene);
        calls.next_frame();
        bench.show(scene, kSize);
        EXPECT_EQ(in_words(calls.waits()), "") << "frame " << frame;
        if (frame > 27) {
            EXPECT_EQ(in_words(calls.allocations()), "") << "frame " << frame;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Finals, FrameWaits, testing::Values(EmcFinal::splat, EmcFinal::gather),
                         [](const auto& info) { return info.param == EmcFinal::splat ? "Splat" : "Gather"; });

}  // namespace
}  // namespace lanthorn::gi::test

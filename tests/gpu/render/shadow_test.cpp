// Shadows where they must be and nowhere else, at scales six orders of magnitude apart; maps drawn only when
// needed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/gpu/render/scenes.h"

namespace lanthorn {
namespace shadow_test {

using testing::SceneBuilder;

constexpr ivec2 kSize(256, 256);
constexpr float kFov = 0.7f;

enum class Kind { point, spot, directional };

struct Case {
    Kind kind;
    float scale;
};

class Shadow : public ::testing::TestWithParam<Case> {};

// Whether the segment from `a` to `b` meets the box.
bool hits_box(const vec3& a, const vec3& b, const vec3& lower, const vec3& upper) {
    float enter = 0;
    float leave = 1;
    for (int i = 0; i < 3; ++i) {
        const float d = b[i] - a[i];
        float t0 = (lower[i] - a[i]) / d;
        float t1 = (upper[i] - a[i]) / d;
        if (t0 > t1) {
            std::swap(t0, t1);
        }
        enter = std::max(enter, t0);
        leave = std::min(leave, t1);
    }
    return enter <= leave;
}

// A box that stands on a floor; every floor pixel is lit or dark as a ray says, but for a seam of a few
// texels.
TEST_P(Shadow, LiesWhereARaySaysAndNowhereElse) {
    const auto [kind, s] = GetParam();
    SceneBuilder b;
    const auto white = b.add_lambert(vec3(1));
    b.add_quad(white, vec3(0), s * vec3(0, 0, 1), s * vec3(1, 0, 0));
    const vec3 half = s * vec3(0.15f, 0.2f, 0.1f);
    b.add_box(white, vec3(0, half.y, 0), half, 0);
    const vec3 light = s * vec3(0.7f, 0.9f, 0.4f);
    const vec3 direction = glm::normalize(-light);
    switch (kind) {
        case Kind::point:
            b.add_point(light, 10);
            break;
        case Kind::spot:
            b.add_spot(light, direction, 10, 0.5f, 0.9f);
            break;
        case Kind::directional:
            b.add_directional(direction, 10);
            break;
    }
    b.look(s * vec3(0, 3, 0), vec3(0), kFov);
    testing::context();
    render::FrameRenderer renderer;
    testing::render_once(renderer, b.build(), kSize);
    const ImageF direct = renderer.read(render::Aov::direct);
    const ImageF depth = renderer.read(render::Aov::depth);
    const render::LightData data = renderer.light_maps().light_data().front();

    int dark = 0;
    int acne = 0;     // lit pixels with any shadow
    int leaking = 0;  // shadowed pixels with any light
    int judged = 0;
    const float image_half = 3 * s * std::tan(0.5f * kFov);
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
            const vec3 p(((static_cast<float>(x) + 0.5f) / 256 * 2 - 1) * image_half, 0,
                         ((static_cast<float>(y) + 0.5f) / 256 * 2 - 1) * image_half);
            const std::size_t i = static_cast<std::size_t>(y * kSize.x + x);
            const float floor_distance = std::hypot(p.x, 3 * s, p.z);
            if (std::max(std::abs(p.x), std::abs(p.z)) > 0.98f * s ||
                std::abs(depth.pixels[i] - floor_distance) > 0.001f * s) {
                continue;
            }
            const vec3 to = kind == Kind::directional ? p - 3 * s * direction : light;
            // Three texels' reach of the filter and as much of the offset along the normal.
            const float seam = 4 * data.texel * (kind == Kind::directional ? 1.0f : glm::distance(p, light));
            const vec3 bottom(0, -s, 0);
            const vec3 wide(seam, seam, seam);
            const bool surely =
                hits_box(p, to, vec3(0, half.y, 0) - half + wide + bottom, vec3(0, half.y, 0) + half - wide);
            const bool maybe =
                hits_box(p, to, vec3(0, half.y, 0) - half - wide + bottom, vec3(0, half.y, 0) + half + wide);
            const vec3 d = to - p;
            const float r = glm::length(d);
            float want = kind == Kind::directional ? 10 * -direction.y : 10 * d.y / (r * r * r);
            if (kind == Kind::spot) {
                const float a = std::clamp(
                    (glm::dot(-d / r, direction) - std::cos(0.9f)) / (std::cos(0.5f) - std::cos(0.9f)), 0.0f,
                    1.0f);
                want *= a * a;
            }
            const float got = direct.pixels[i * 3] * kPi;
            if (want <= 0 || surely != maybe) {
                continue;
            }
            ++judged;
            if (surely) {
                ++dark;
                leaking += got > 0.01f * want ? 1 : 0;
            } else {
                acne += got < 0.99f * want ? 1 : 0;
            }
        }
    }
    if (s == 1) {
        testing::save_picture(renderer.read(render::Aov::final),
                              "shadow-" + std::to_string(static_cast<int>(kind)));
    }
    EXPECT_GT(judged, 20000);
    EXPECT_GT(dark, 900);
    EXPECT_EQ(acne, 0);
    EXPECT_EQ(leaking, 0);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Shadow,
                         ::testing::Values(Case{Kind::point, 1e-3f}, Case{Kind::point, 1},
                                           Case{Kind::point, 1e3f}, Case{Kind::spot, 1e-3f},
                                           Case{Kind::spot, 1}, Case{Kind::spot, 1e3f},
                                           Case{Kind::directional, 1e-3f}, Case{Kind::directional, 1},
                                           Case{Kind::directional, 1e3f}));

FrameScene next(FrameScene scene) {
    ++scene.frame;
    scene.changes = {};
    scene.changes.assets = scene.changes.geometry = scene.changes.lights = scene.changes.camera = false;
    return scene;
}

TEST(LightMapUpdates, OnlyWhatChangedIsDrawnAgain) {
    testing::context();
    render::FrameRenderer renderer;
    SceneBuilder b = testing::small_room(1, true);
    b.add_point(vec3(0.2f, 0.8f, 0.2f), 1);
    b.add_spot(vec3(-0.2f, 0.8f, 0), vec3(0, -1, 0), 1, 0.2f, 0.5f);
    FrameScene scene = b.build();
    testing::render_once(renderer, scene, {64, 64});
    EXPECT_EQ(renderer.light_maps().layers_drawn(), 6 + 1 + 4 * 6);
    EXPECT_EQ(renderer.light_maps().punctual_count(), 2);
    EXPECT_EQ(renderer.light_maps().light_count(), 6);

    scene = next(scene);
    testing::render_once(renderer, scene, {64, 64});
    EXPECT_EQ(renderer.light_maps().layers_drawn(), 0);

    scene = next(scene);
    scene.lights[1].position.x += 0.1f;
    scene.changes.lights = true;
    testing::render_once(renderer, scene, {64, 64});
    EXPECT_EQ(renderer.light_maps().layers_drawn(), 1);

    const std::uint64_t version = renderer.light_maps().version();
    scene = next(scene);
    scene.lights[0].light.intensity = 7;  // brightness alone: the map stays
    scene.changes.lights = true;
    testing::render_once(renderer, scene, {64, 64});
    EXPECT_EQ(renderer.light_maps().layers_drawn(), 0);
    EXPECT_GT(renderer.light_maps().version(), version);
    EXPECT_EQ(renderer.light_maps().light_data()[0].intensity, vec3(7));

    // A box near the floor moves a little: the lights' upward faces do not see it.
    scene = next(scene);
    Instance& box = scene.instances[5];
    scene.changes.geometry = true;
    scene.changes.moved = {5};
    scene.changes.dirty = box.bounds;
    box.transform = glm::translate(mat4(1), vec3(0.02f, 0, 0));
    box.bounds = transformed(box.bounds, glm::translate(mat4(1), vec3(0.02f, 0, 0)));
    scene.changes.dirty.add(box.bounds);
    testing::render_once(renderer, scene, {64, 64});
    EXPECT_GT(renderer.light_maps().layers_drawn(), 4);
    EXPECT_LT(renderer.light_maps().layers_drawn(), 6 + 1 + 4 * 6);
}

// A frame that was never rendered is not forgotten.
TEST(LightMapUpdates, ChangesOfASkippedFrameAreSeen) {
    testing::context();
    render::FrameRenderer renderer;
    SceneBuilder b = testing::small_room(1, true);
    FrameScene scene = b.build();
    testing::render_once(renderer, scene, {64, 64});
    scene = next(next(scene));
    scene.instances[5].transform = glm::translate(mat4(1), vec3(0, 0.3f, 0));
    scene.instances[5].bounds = transformed(scene.instances[5].bounds, scene.instances[5].transform);
    testing::render_once(renderer, scene, {64, 64});
    render::FrameRenderer fresh;
    scene.changes = {};
    testing::render_once(fresh, scene, {64, 64});
    EXPECT_EQ(renderer.read(render::Aov::direct).pixels, fresh.read(render::Aov::direct).pixels);
}

// After any sequence of partial updates the maps are what a fresh renderer draws.
TEST(LightMapUpdates, AMovedBoxLeavesNoTrace) {
    testing::context();
    render::FrameRenderer moving;
    SceneBuilder b = testing::small_room(1, true);
    b.add_point(vec3(0.2f, 0.8f, 0.2f), 1);
    FrameScene scene = b.build();
    testing::render_once(moving, scene, {64, 64});
    const mat4 move = glm::rotate(glm::translate(mat4(1), vec3(-0.1f, 0.3f, 0.1f)), 0.4f, vec3(0, 1, 0));
    scene = next(scene);
    Instance& box = scene.instances[5];
    scene.changes.geometry = true;
    scene.changes.moved = {5};
    scene.changes.dirty = box.bounds;
    box.transform = move;
    box.bounds = transformed(box.bounds, move);
    scene.changes.dirty.add(box.bounds);
    testing::render_once(moving, scene, {64, 64});

    render::FrameRenderer fresh;
    scene.changes = {};
    testing::render_once(fresh, scene, {64, 64});
    EXPECT_EQ(moving.light_maps().distance().read_floats(1), fresh.light_maps().distance().read_floats(1));
    EXPECT_EQ(moving.light_maps().albedo().read_floats(4), fresh.light_maps().albedo().read_floats(4));
    EXPECT_EQ(moving.light_maps().area_distance().read_floats(1),
              fresh.light_maps().area_distance().read_floats(1));
    EXPECT_EQ(moving.read(render::Aov::direct).pixels, fresh.read(render::Aov::direct).pixels);
}

}  // namespace shadow_test
}  // namespace lanthorn

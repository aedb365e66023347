// Who looks at a scene, and how finely, as the camera and the lights' maps say.
#include "engine/render/detail_hints.h"

#include <gtest/gtest.h>

#include "tests/gpu/render/scenes.h"

namespace lanthorn {
namespace {

using testing::SceneBuilder;

const dvec3 kOrigin(1000, 0, -5);

TEST(DetailHints, ACamerasPixelsAreCountedByAngleOrByLength) {
    SceneBuilder b;
    b.look(vec3(1, 2, 3), vec3(0), 0.5f);
    DetailHints hints;
    render::add_camera(hints, b.scene.camera, kOrigin, 400);
    ASSERT_EQ(hints.eyes.size(), 1u);
    EXPECT_EQ(hints.eyes[0].at, kOrigin + dvec3(1, 2, 3));
    EXPECT_NEAR(hints.eyes[0].samples_per_radian, 800, 1e-3);
    EXPECT_EQ(hints.samples_per_metre, 0);
    b.look_orthographic(vec3(1, 2, 3), vec3(0), 4, 2);
    render::add_camera(hints, b.scene.camera, kOrigin, 400);
    EXPECT_EQ(hints.eyes.size(), 1u) << "it is nowhere";
    EXPECT_NEAR(hints.samples_per_metre, 100, 1e-3);
}

TEST(DetailHints, LightsMapsLookToo) {
    testing::context();
    SceneBuilder b = testing::small_room(1, true);
    b.add_point(vec3(0.1f, 0.6f, 0), 1);
    b.add_spot(vec3(0, 0.9f, 0), vec3(0, -1, 0), 1, 0.2f, 0.4f);
    b.add_directional(vec3(0, -1, 0), 1);
    b.look(vec3(0, 0.5f, 1.5f), vec3(0, 0.5f, 0), 0.7f);
    const FrameScene scene = b.build();
    render::FrameRenderer renderer;
    renderer.settings.shadow_resolution = 64;
    renderer.settings.area_lights_resolution = 32;
    renderer.settings.area_lights_samples = 1;
    testing::render_once(renderer, scene, ivec2(32));
    DetailHints hints;
    render::add_light_maps(hints, renderer.light_maps(), kOrigin);
    ASSERT_EQ(hints.eyes.size(), 3u) << "point, spot and a sample of the lamp";
    EXPECT_EQ(hints.eyes[0].at, kOrigin + dvec3(vec3(0.1f, 0.6f, 0)));
    EXPECT_NEAR(hints.eyes[0].samples_per_radian, 64 / (0.5 * kPi), 1e-3);
    // 56 texels of 64 across the cone; the rest is margin.
    EXPECT_NEAR(hints.eyes[1].samples_per_radian, 32 / std::atan(std::tan(0.4) * 64 / 56), 1e-3);
    EXPECT_NEAR(hints.eyes[2].samples_per_radian, 32 / (0.5 * kPi), 1e-3);
    EXPECT_NEAR(hints.eyes[2].at.y, 0.99, 1e-3);
    EXPECT_NEAR(hints.samples_per_metre, 56 / (2 * 0.51 * scene.diagonal()), 1e-2);
}

}  // namespace
}  // namespace lanthorn

// Flames that shine in the picture alone: where they stand, what hides them, and that nothing else knows
// them.
#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <vector>

#include "engine/render/scene_renderer.h"
#include "tests/gpu/render/scenes.h"

namespace lanthorn {
namespace glow_test {

constexpr ivec2 kSize(64, 64);
constexpr float kWall = 4;

// Looks from 0 along -Z at a grey wall, with a lamp.
testing::SceneBuilder view() {
    testing::SceneBuilder b;
    b.add_quad(b.add_lambert(vec3(0.4f)), vec3(0, 0, -kWall), vec3(30, 0, 0), vec3(0, 30, 0));
    b.add_point({1, 1, -2}, 5);
    b.look(vec3(0), vec3(0, 0, -1), 0.5f);
    return b;
}

render::Glow flame(const dvec3& foot, double height = 0.3) {
    return {foot, foot + dvec3(0, height, 0), static_cast<float>(0.4 * height), vec3(900, 600, 300)};
}

ImageF radiance(const testing::SceneBuilder& b, const std::vector<render::Glow>& glows) {
    testing::context();
    const auto scene = std::make_shared<render::SceneRenderer>();
    scene->show({glows});
    render::FrameRenderer renderer(scene);
    testing::render_once(renderer, b.build(), kSize);
    return renderer.read(render::Aov::radiance);
}

vec3 at(const ImageF& image, int x, int y) {
    const std::size_t i = 3 * (static_cast<std::size_t>(y) * kSize.x + static_cast<std::size_t>(x));
    return {image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]};
}

TEST(Glow, StandsWhereItIsAndIsDeepestInHueAtItsTip) {
    const testing::SceneBuilder b = view();
    const ImageF without = radiance(b, {}), with = radiance(b, {flame({0, -0.15, -2})});
    // 64 pixels for 2 * tan(0.25) * 2 = 1.02 m: it covers rows 22 to 41.
    const vec3 core = at(with, 32, 36), tip = at(with, 32, 25);
    EXPECT_GT(core.r, 500);
    EXPECT_GT(tip.r, 4 * at(without, 32, 25).r);
    EXPECT_LT(tip.b / tip.r, 0.7f * core.b / core.r);
    for (const ivec2 outside : {ivec2(32, 18), ivec2(32, 46), ivec2(20, 32), ivec2(44, 32), ivec2(0, 0)}) {
        EXPECT_EQ(at(with, outside.x, outside.y), at(without, outside.x, outside.y));
    }
}

TEST(Glow, IsHiddenByWhatIsNearer) {
    testing::SceneBuilder b = view();
    EXPECT_EQ(radiance(b, {flame({0, -0.15, -kWall - 1})}).pixels, radiance(b, {}).pixels);
    EXPECT_EQ(radiance(b, {flame({0, -0.15, 1})}).pixels, radiance(b, {}).pixels);  // behind the eye
}

TEST(Glow, FromStraightAboveItIsADisc) {
    testing::SceneBuilder b = view();
    b.look(vec3(0, 2, -2), vec3(0, 1, -2), 0.5f);
    EXPECT_GT(at(radiance(b, {flame({0, -0.15, -2})}), 32, 32).r, 100);
}

TEST(Glow, WhatIsNoNumberOrHasNoSizeIsLeftOut) {
    const testing::SceneBuilder b = view();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    render::Glow no_width = flame({0, -0.15, -2}), no_light = no_width;
    no_width.width = 0;
    no_light.nits.r = std::numeric_limits<float>::infinity();
    const std::vector<render::Glow> bad = {flame({nan, 0, -2}), flame({0, 0, -2}, 0), no_width, no_light};
    EXPECT_EQ(radiance(b, bad).pixels, radiance(b, {}).pixels);
}

}  // namespace glow_test
}  // namespace lanthorn

// From radiance to bytes: exposure, tone map, sRGB, and numbers that are none.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/gpu/render/scenes.h"

namespace lanthorn {
namespace composite_test {

using testing::SceneBuilder;

constexpr ivec2 kSize(32, 32);

// A white wall that fills the view and reflects `nits` everywhere, by indirect irradiance alone.
SceneBuilder wall(const vec3& albedo = vec3(1)) {
    SceneBuilder b;
    b.add_quad(b.add_lambert(albedo), vec3(0), vec3(2, 0, 0), vec3(0, 2, 0));
    b.look(vec3(0, 0, 1), vec3(0), 1);
    return b;
}

struct Shown {
    vec3 final{0};
    vec3 radiance{0};
    float exposure = 0;
};

class Wall {
  public:
    Wall() : scene_(wall().build()), irradiance_(gpu::Texture::make_2d(GL_RGBA32F, kSize)) {}

    Shown show(const vec3& nits) {
        irradiance_.clear(vec4(nits * kPi, 1));
        testing::render_once(renderer, scene_, kSize, {&irradiance_, nullptr});
        const auto final = renderer.read(render::Aov::final);
        const auto radiance = renderer.read(render::Aov::radiance);
        const std::size_t i = 3 * (16 * 32 + 16);
        return {vec3(final.pixels[i], final.pixels[i + 1], final.pixels[i + 2]),
                vec3(radiance.pixels[i], radiance.pixels[i + 1], radiance.pixels[i + 2]),
                renderer.exposure()};
    }

    gpu::Context& context_ = testing::context();
    render::FrameRenderer renderer;

  private:
    FrameScene scene_;
    gpu::Texture irradiance_;
};

float srgb(float v) {
    return v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f;
}

TEST(Composite, ManualExposureIsEv100AndTheOutputIsSrgb) {
    Wall wall;
    wall.renderer.settings.exposure_mode = render::ExposureMode::manual;
    wall.renderer.settings.exposure_ev100 = 3;  // 1.2 * 8 = 9.6 nits show as 1
    wall.renderer.settings.tone_map = render::ToneMap::none;
    for (const float v : {0.0f, 0.002f, 0.0031308f, 0.05f, 0.18f, 0.5f, 1.0f, 3.0f}) {
        const Shown shown = wall.show(vec3(v * 9.6f));
        EXPECT_NEAR(shown.radiance.x, v * 9.6f, 1e-5f + v * 1e-4f);
        EXPECT_NEAR(shown.final.x, srgb(std::min(v, 1.0f)), 0.6f / 255) << v;
    }
}

// Beyond white the brightest channel goes by the logarithm, and takes the others along.
TEST(Composite, ABrightColourKeepsItsHueOnItsShoulder) {
    Wall wall;
    wall.renderer.settings.exposure_mode = render::ExposureMode::manual;
    wall.renderer.settings.exposure_ev100 = 0;  // 1.2 nits show as 1
    wall.renderer.settings.tone_map = render::ToneMap::none;
    const vec3 dark(0.9f, 0.4f, 0.1f), bright(8, 2, 0.5f);
    const Shown before = wall.show(1.2f * dark);
    wall.renderer.settings.shoulder = 0.5f;
    EXPECT_EQ(wall.show(1.2f * dark).final, before.final);
    const float most = 1 + 0.5f * std::log(1 + (bright.r - 1) / 0.5f);
    const Shown shown = wall.show(1.2f * bright);
    EXPECT_NEAR(shown.final.g, srgb(bright.g * most / bright.r), 0.6f / 255);
    EXPECT_NEAR(shown.final.b, srgb(bright.b * most / bright.r), 0.6f / 255);
    EXPECT_NEAR(shown.radiance.r, 1.2f * bright.r, 1e-3f);
}

TEST(Composite, ToneMapsHaveTheirKnownValues) {
    Wall wall;
    wall.renderer.settings.exposure_mode = render::ExposureMode::manual;
    wall.renderer.settings.exposure_ev100 = 0;  // 1.2 nits show as 1
    wall.renderer.settings.tone_map = render::ToneMap::aces;
    // Grey stays grey through both matrices (their rows sum to 1), so the fit is one rational function.
    for (const float v : {0.02f, 0.18f, 1.0f, 4.0f, 16.0f}) {
        const float fitted =
            (v * (v + 0.0245786f) - 0.000090537f) / (v * (0.983729f * v + 0.4329510f) + 0.238081f);
        EXPECT_NEAR(wall.show(vec3(v * 1.2f)).final.y, srgb(std::clamp(fitted, 0.0f, 1.0f)), 1.5f / 255) << v;
    }
    wall.renderer.settings.tone_map = render::ToneMap::neutral;
    EXPECT_NEAR(wall.show(vec3(0.5f * 1.2f)).final.x, srgb(0.46f), 1.0f / 255);
    const float peak = 2 - 0.04f;
    EXPECT_NEAR(wall.show(vec3(2 * 1.2f)).final.x, srgb(1 - 0.0576f / (peak + 0.24f - 0.76f)), 1.0f / 255);
    const Shown red = wall.show(vec3(0.6f, 0.08f, 0.08f) * 1.2f);
    EXPECT_NEAR(red.final.x, srgb(0.56f), 1.0f / 255);
    EXPECT_NEAR(red.final.y, srgb(0.04f), 1.0f / 255);
}

TEST(Composite, AutomaticExposureIsRightAtOnceAndGlidesThen) {
    Wall wall;
    wall.renderer.settings.tone_map = render::ToneMap::none;
    for (const float darkest : {0.1f, 0.001f}) {  // no average below is lifted to the key
        Wall fresh;
        fresh.renderer.settings.exposure_darkest = darkest;
        EXPECT_NEAR(fresh.show(vec3(1e-4f)).exposure * darkest, 0.18f, 1e-3f);
    }
    for (const float nits : {0.002f, 0.02f, 0.2f, 1.0f, 1e5f}) {
        Wall fresh;
        fresh.renderer.settings.tone_map = render::ToneMap::none;
        const Shown shown = fresh.show(vec3(nits));
        EXPECT_NEAR(shown.exposure * nits, 0.18f, 1e-3f);
        EXPECT_NEAR(shown.final.x, srgb(0.18f), 1.0f / 255);
    }
    const float first = wall.show(vec3(1)).exposure;
    const float second = wall.show(vec3(16)).exposure;
    EXPECT_LT(second, first);
    EXPECT_GT(second, first / 16 * 8);  // a small step of the way
    float last = second;
    for (int i = 0; i < 200; ++i) {
        last = wall.show(vec3(16)).exposure;
    }
    EXPECT_NEAR(last / (first / 16), 1, 0.01);
    wall.renderer.settings.exposure_compensation = 1;
    for (int i = 0; i < 200; ++i) {
        last = wall.show(vec3(16)).exposure;
    }
    EXPECT_NEAR(last / (first / 8), 1, 0.01);
}

// Where no lit surface is seen - none at all, or only see-through and unlit ones - it is the sky that is
// exposed for.
TEST(Composite, ASkyAloneIsExposedFor) {
    constexpr float kNits = 1e4f;
    testing::context();
    SceneBuilder b = wall();
    b.look(vec3(0, 0, 1), vec3(0, 0, 2), 1);
    FrameScene scene = b.build();
    SkyImage image;
    image.width = 16;
    image.height = 8;
    image.radiance.assign(image.width * image.height, vec3(kNits));
    scene.sky.emplace().sky.image = std::make_shared<const SkyImage>(std::move(image));
    render::FrameRenderer renderer;
    testing::render_once(renderer, scene, kSize);
    EXPECT_NEAR(renderer.exposure() * kNits, 0.18f, 1e-3f);
}

TEST(Composite, WhatIsNoNumberBecomesBlackAndIsCounted) {
    testing::context();
    render::FrameRenderer renderer;
    const FrameScene scene = wall().build();
    std::vector<float> texels(32 * 32 * 4, kPi);
    texels[4 * 100] = std::numeric_limits<float>::quiet_NaN();
    texels[4 * 200 + 1] = std::numeric_limits<float>::infinity();
    texels[4 * 300 + 2] = -std::numeric_limits<float>::infinity();
    gpu::Texture irradiance = gpu::Texture::make_2d(GL_RGBA32F, kSize);
    glTextureSubImage2D(irradiance.id(), 0, 0, 0, 32, 32, GL_RGBA, GL_FLOAT, texels.data());
    testing::render_once(renderer, scene, kSize, {&irradiance, nullptr});
    EXPECT_EQ(renderer.nan_count(), 3u);
    const auto radiance = renderer.read(render::Aov::radiance);
    EXPECT_TRUE(std::ranges::all_of(radiance.pixels, [](float v) { return std::isfinite(v); }));
    EXPECT_EQ(std::ranges::count(radiance.pixels, 0.0f), 9);
    EXPECT_TRUE(std::isfinite(renderer.exposure()));
}

TEST(Composite, EmissionIsShownInNitsWhateverItsSize) {
    testing::context();
    for (const float nits : {1e-4f, 1.0f, 1e7f}) {
        SceneBuilder b;
        Material lamp;
        lamp.base_colour = vec4(0, 0, 0, 1);
        lamp.emissive = vec3(nits, 0.5f * nits, 0);
        b.add_quad(b.add_material(lamp), vec3(0), vec3(2, 0, 0), vec3(0, 2, 0));
        b.look(vec3(0, 0, 1), vec3(0), 1);
        render::FrameRenderer renderer;
        testing::render_once(renderer, b.build(), kSize);
        const auto radiance = renderer.read(render::Aov::radiance);
        EXPECT_NEAR(radiance.pixels[0] / nits, 1, 1e-3);
        EXPECT_NEAR(radiance.pixels[1] / nits, 0.5, 1e-3);
    }
}

TEST(Composite, UnlitColoursAreShownAsTheyAre) {
    testing::context();
    SceneBuilder b;
    Material sign;
    sign.unlit = true;
    sign.base_colour = vec4(0.5f, 0.25f, 1, 1);
    b.add_quad(b.add_material(sign), vec3(0), vec3(2, 0, 0), vec3(0, 2, 0));
    b.add_point(vec3(0, 0, 1), 1000);
    b.look(vec3(0, 0, 1), vec3(0), 1);
    render::FrameRenderer renderer;
    testing::render_once(renderer, b.build(), kSize);
    const auto final = renderer.read(render::Aov::final);
    EXPECT_NEAR(final.pixels[0], srgb(0.5f), 1.5f / 255);
    EXPECT_NEAR(final.pixels[1], srgb(0.25f), 1.5f / 255);
    EXPECT_NEAR(final.pixels[2], 1, 1.5f / 255);
}

// Panes of glass that shine: each covers what is behind it by its alpha, farthest first whatever their order.
TEST(Blend, PanesCoverWhatIsBehindThemInOrderOfDepth) {
    testing::context();
    SceneBuilder b;
    Material wall;
    wall.base_colour = vec4(0, 0, 0, 1);
    wall.emissive = vec3(8, 0, 0);
    Material near;
    near.base_colour = vec4(0, 0, 0, 0.25f);
    near.metallic = 0;
    near.specular = 0;
    near.emissive = vec3(0, 8, 0);
    near.alpha_mode = AlphaMode::blend;
    Material far = near;
    far.base_colour.a = 0.5f;
    far.emissive = vec3(0, 0, 8);
    Material hidden = far;
    hidden.emissive = vec3(1000);
    b.add_quad(b.add_material(near), vec3(0, 0, 1), vec3(2, 0, 0), vec3(0, 2, 0));
    b.add_quad(b.add_material(far), vec3(0, 0, 0.5f), vec3(2, 0, 0), vec3(0, 2, 0));
    b.add_quad(b.add_material(wall), vec3(0), vec3(2, 0, 0), vec3(0, 2, 0));
    b.add_quad(b.add_material(hidden), vec3(0, 0, -1), vec3(2, 0, 0), vec3(0, 2, 0));
    b.look(vec3(0, 0, 2), vec3(0), 0.5f);
    render::FrameRenderer renderer;
    testing::render_once(renderer, b.build(), kSize);
    const auto radiance = renderer.read(render::Aov::radiance);
    EXPECT_NEAR(radiance.pixels[0], 8 * 0.5 * 0.75, 0.01);
    EXPECT_NEAR(radiance.pixels[1], 8 * 0.25, 0.01);
    EXPECT_NEAR(radiance.pixels[2], 8 * 0.5 * 0.75, 0.01);
    const auto depth = renderer.read(render::Aov::depth);
    EXPECT_NEAR(depth.pixels[16 * 32 + 16], 2, 0.01);
}

// Nothing to see, nothing to see it by: a black picture, no fuss.
TEST(Composite, AnEmptySceneIsBlack) {
    testing::context();
    SceneBuilder b;
    b.add_lambert(vec3(1));
    b.look(vec3(0, 0, 1), vec3(0), 1);
    render::FrameRenderer renderer;
    testing::render_once(renderer, b.build(), kSize);
    const auto final = renderer.read(render::Aov::final);
    EXPECT_TRUE(std::ranges::all_of(final.pixels, [](float v) { return v == 0; }));
    EXPECT_EQ(renderer.nan_count(), 0u);
}

}  // namespace composite_test
}  // namespace lanthorn

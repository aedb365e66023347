// Fragment and compute shaders make the same picture of direct light, of what is added to it, and of its
// display.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/render/fullscreen.h"
#include "tests/gpu/render/scenes.h"

namespace lanthorn {
namespace pixel_stage_test {

using testing::SceneBuilder;

constexpr ivec2 kSize(83, 61);  // no multiple of a work group

struct Pictures {
    ImageF direct, radiance, final;
};

Pictures draw(const SceneBuilder& builder, render::PixelStage stage, bool indirect, float bloom) {
    testing::context();
    const FrameScene scene = builder.build();
    gpu::Texture irradiance = gpu::Texture::make_2d(GL_RGBA32F, kSize),
                 specular = gpu::Texture::make_2d(GL_RGBA32F, kSize);
    irradiance.clear(vec4(3, 2, 1, 1));
    specular.clear(vec4(0.1f, 0.2f, 0.3f, 0.5f));
    render::FrameRenderer renderer;
    renderer.settings.pixel_stage = stage;
    renderer.settings.bloom_share = bloom;
    testing::render_once(renderer, scene, kSize,
                         indirect ? render::IndirectLight{&irradiance, &specular} : render::IndirectLight{});
    return {renderer.read(render::Aov::direct), renderer.read(render::Aov::radiance),
            renderer.read(render::Aov::final)};
}

// The share of values that differ by more than `most`, relative or absolute.
double share_that_differs(const ImageF& a, const ImageF& b, float most) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const float size = std::max({1.0f, std::abs(a.pixels[i]), std::abs(b.pixels[i])});
        count += std::abs(a.pixels[i] - b.pixels[i]) <= most * size ? 0 : 1;
    }
    return static_cast<double>(count) / static_cast<double>(a.pixels.size());
}

// Stages round the place in a pixel differently: where that takes a shadow's look-up to another texel, a
// pixel may differ.
void expect_same(const SceneBuilder& builder, bool indirect, float bloom) {
    const Pictures fragment = draw(builder, render::PixelStage::fragment, indirect, bloom);
    const Pictures compute = draw(builder, render::PixelStage::compute, indirect, bloom);
    EXPECT_LT(share_that_differs(fragment.direct, compute.direct, 1e-4f), 2e-3);
    EXPECT_LT(share_that_differs(fragment.radiance, compute.radiance, 1e-4f), 2e-3);
    EXPECT_LT(share_that_differs(fragment.final, compute.final, 1.01f / 255), 2e-3);
    EXPECT_GT(std::ranges::count_if(fragment.final.pixels, [](float v) { return v > 0.01f; }), 1000);
}

TEST(PixelStage, BothShowTheSameRooms) {
    for (const bool lamp : {true, false}) {
        expect_same(testing::small_room(1, lamp), false, 0);
        expect_same(testing::small_room(1, lamp), true, 0.1f);
    }
}

TEST(PixelStage, BothShowUnlitThingsAndTheBackground) {
    SceneBuilder b = testing::small_room(1, false);
    Material sign;
    sign.unlit = true;
    sign.base_colour = vec4(0.2f, 0.6f, 0.9f, 1);
    b.add_quad(b.add_material(sign), vec3(0, 0.5f, 0.5f), vec3(0.1f, 0, 0), vec3(0, 0.1f, 0));
    b.look(vec3(0, 0.5f, 2.5f), vec3(0, 0.5f, 0), 1);  // past the room's open side
    expect_same(b, false, 0);
}

TEST(PixelStage, TheDeviceDecides) {
    testing::context();
    EXPECT_EQ(render::in_compute(render::PixelStage::by_device), !gpu::draws_in_software());
    EXPECT_FALSE(render::in_compute(render::PixelStage::fragment));
    EXPECT_TRUE(render::in_compute(render::PixelStage::compute));
}

}  // namespace pixel_stage_test
}  // namespace lanthorn

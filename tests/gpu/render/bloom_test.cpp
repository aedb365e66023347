// The veil around bright light: what goes out comes in, in the same hue, and where it is off nothing differs.
#include "engine/render/bloom.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "tests/gpu/render/scenes.h"

namespace lanthorn {
namespace bloom_test {

constexpr ivec2 kSize(256, 128);

// What a picture's light is spread to, RGBA a texel.
std::vector<float> scattered(ivec2 size, const std::vector<float>& radiance, float spread) {
    testing::context();
    const gpu::Texture texture = gpu::Texture::make_2d(GL_RGBA32F, size);
    glTextureSubImage2D(texture.id(), 0, 0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, radiance.data());
    render::Bloom bloom(size);
    bloom.scatter(texture, spread);
    return bloom.scattered().read_floats(4);
}

std::vector<float> filled(ivec2 size, const vec4& texel) {
    std::vector<float> radiance;
    for (int i = 0; i < size.x * size.y; ++i) {
        radiance.insert(radiance.end(), {texel.x, texel.y, texel.z, texel.w});
    }
    return radiance;
}

// One bright pixel in the middle of the dark.
std::vector<float> spark(const vec4& light) {
    std::vector<float> radiance = filled(kSize, vec4(0, 0, 0, 1));
    const std::size_t at = 4 * (std::size_t{64} * kSize.x + 128);
    for (int c = 0; c < 4; ++c) {
        radiance[at + static_cast<std::size_t>(c)] = light[c];
    }
    return radiance;
}

std::array<double, 3> sums(const std::vector<float>& texels) {
    std::array<double, 3> sum{};
    for (std::size_t i = 0; i < texels.size(); ++i) {
        if (i % 4 < 3) {
            sum[i % 4] += static_cast<double>(texels[i]);
        }
    }
    return sum;
}

TEST(Bloom, AConstantPictureStaysAsItIsAtAnySize) {
    for (const ivec2 size : {kSize, ivec2(75, 53), ivec2(1, 1), ivec2(640, 16), ivec2(3, 200)}) {
        const std::vector<float> out = scattered(size, filled(size, vec4(3, 0.5f, 7, 1)), 0.8f);
        for (std::size_t i = 0; i < out.size(); i += 4) {
            ASSERT_NEAR(out[i], 3, 3e-5f) << size.x << 'x' << size.y;
            ASSERT_NEAR(out[i + 1], 0.5f, 1e-5f);
            ASSERT_NEAR(out[i + 2], 7, 7e-5f);
        }
    }
}

// A texel stands for 16 pixels. What the widest levels hold at the picture's edge is repeated there, so that
// the sum is exact only while nothing gets that far.
TEST(Bloom, KeepsTheSumOfLight) {
    EXPECT_NEAR(16 * sums(scattered(kSize, spark(vec4(1000, 0, 0, 1)), 0))[0], 1000, 0.1);
    EXPECT_NEAR(16 * sums(scattered(kSize, spark(vec4(1000, 0, 0, 1)), 0.5f))[0], 1000, 20);
}

TEST(Bloom, KeepsTheHueInEveryTexel) {
    const std::vector<float> out = scattered(kSize, spark(vec4(900, 300, 30, 1)), 0.75f);
    std::size_t lit = 0;
    for (std::size_t i = 0; i < out.size(); i += 4) {
        if (out[i] > 1e-4f) {
            ++lit;
            ASSERT_NEAR(out[i + 1] / out[i], 1.0f / 3, 1e-4f);
            ASSERT_NEAR(out[i + 2] / out[i], 1.0f / 30, 1e-4f);
        }
    }
    EXPECT_GT(lit, out.size() / 8);
}

// Each level hands on the share `spread` and keeps the rest, so that the texel of the spark holds in closed
// form: its own (1 - s) and, from the level after it, s (1 - s) (3/8)^2 w^2 with w = 3/4 3/8 + 1/4 1/8 each
// way, and so on. Of the first two levels:
TEST(Bloom, TheMiddleOfAHaloHasItsClosedForm) {
    const auto middle = [](float spread) {
        const std::vector<float> out = scattered(kSize, spark(vec4(1600, 0, 0, 1)), spread);
        return static_cast<double>(out[4 * (std::size_t{16} * (kSize.x / 4) + 32)]);
    };
    EXPECT_NEAR(middle(0), 100, 1e-3);
    // To the first order in s: -s for what is handed on, + s for what comes back of it. The spark's texel is
    // the first of its pair: the pair's own texel has 3/8 of it and its neighbour 1/8, which come back by 3/4
    // and 1/4.
    const double back = 0.75 * 0.375 + 0.25 * 0.125, s = 1e-3;
    EXPECT_NEAR((middle(static_cast<float>(s)) - 100) / s, 100 * (back * back - 1), 0.2);
}

TEST(Bloom, UnlitColoursAreNoLight) {
    EXPECT_EQ(sums(scattered(kSize, spark(vec4(1000, 1000, 1000, 2)), 0.7f))[0], 0);
}

FrameScene lamp_in_the_dark() {
    testing::SceneBuilder b = testing::small_room(1, true);
    return b.build();
}

std::vector<float> shown(const render::RenderSettings& settings) {
    testing::context();
    render::FrameRenderer renderer;
    renderer.settings = settings;
    testing::render_once(renderer, lamp_in_the_dark(), {64, 48});
    return renderer.read(render::Aov::final).pixels;
}

TEST(Bloom, OffThePictureIsTheSameBitForBitAndOnItIsNot) {
    render::RenderSettings off, other = off, on = off;
    other.bloom_spread = 0.1f;
    on.bloom_share = 0.3f;
    EXPECT_EQ(shown(off), shown(other));
    EXPECT_NE(shown(off), shown(on));
}

}  // namespace bloom_test
}  // namespace lanthorn

// Smoothed edges against what covers each pixel.
#include "engine/render/fxaa.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "tests/gpu/render/scenes.h"

namespace lanthorn {
namespace fxaa_test {

constexpr ivec2 kSize(75, 53);
constexpr float kDark = 0.2f, kLight = 0.8f;

using Picture = std::vector<float>;  // grey, rows upwards

Picture drawn(const std::function<float(int, int)>& grey) {
    Picture picture;
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
            picture.push_back(grey(x, y));
        }
    }
    return picture;
}

Picture smoothed(const Picture& picture) {
    testing::context();
    std::vector<std::uint8_t> bytes;
    for (const float grey : picture) {
        const auto level = static_cast<std::uint8_t>(std::lround(255 * grey));
        bytes.insert(bytes.end(), {level, level, level, 255});
    }
    const gpu::Texture texture = gpu::Texture::make_2d(GL_RGBA8, kSize);
    glTextureSubImage2D(texture.id(), 0, 0, 0, kSize.x, kSize.y, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    render::Fxaa fxaa(kSize);
    fxaa.smooth(texture);
    return texture.read_floats(1);
}

double rms(const Picture& a, const Picture& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double difference = static_cast<double>(a[i]) - static_cast<double>(b[i]);
        sum += difference * difference;
    }
    return std::sqrt(sum / static_cast<double>(a.size()));
}

// Light on one side of a line through the middle, by the middle of each pixel, and by how much of it is
// covered.
struct HalfPlane {
    explicit HalfPlane(double degrees)
        : nx(-std::sin(degrees * 0.0174533)), ny(std::cos(degrees * 0.0174533)) {}

    bool lit(double x, double y) const { return nx * (x - 37.7) + ny * (y - 26.2) < 0; }
    Picture aliased() const {
        return drawn([this](int x, int y) { return lit(x + 0.5, y + 0.5) ? kLight : kDark; });
    }
    Picture covered() const {
        return drawn([this](int x, int y) {
            int inside = 0;
            for (int i = 0; i < 256; ++i) {
                inside += lit(x + (i % 16 + 0.5) / 16, y + (i / 16 + 0.5) / 16) ? 1 : 0;
            }
            return kDark + (kLight - kDark) * static_cast<float>(inside) / 256;
        });
    }

    double nx, ny;
};

TEST(Fxaa, BringsEdgesOfAnySlopeNearerToTheirCoverage) {
    for (const double degrees : {3.0, 8.0, 17.0, 30.0, 44.0, 61.0, 77.0, 85.0, 120.0, 174.0, 203.0, 290.0}) {
        const HalfPlane edge(degrees);
        const double before = rms(edge.aliased(), edge.covered());
        const double after = rms(smoothed(edge.aliased()), edge.covered());
        RecordProperty("degrees_" + std::to_string(static_cast<int>(degrees)),
                       std::to_string(after / before));
        // Diagonals have steps of one pixel, whose ends tell the least, and erred least before.
        EXPECT_LT(after, (degrees == 44 ? 0.75 : 0.6) * before) << degrees << " degrees";
    }
}

TEST(Fxaa, LeavesWhatHasNoEdgesAsItIs) {
    const Picture gradient = drawn([](int x, int y) {
        return std::round(255 * (0.2f + 0.006f * static_cast<float>(x) + 0.004f * static_cast<float>(y))) /
               255;
    });
    EXPECT_LT(rms(smoothed(gradient), gradient), 1e-6);
}

TEST(Fxaa, LeavesEdgesThatArePixelRowsSharp) {
    const Picture wall = drawn([](int x, int) { return x < 30 ? kLight : kDark; });
    EXPECT_LT(rms(smoothed(wall), wall), 0.15 * rms(drawn([](int, int) { return kDark; }), wall));
}

TEST(Fxaa, TakesPicturesOfOnePixelAndOfNoise) {
    std::uint32_t state = 1;
    const Picture noise = drawn([&](int, int) {
        state = state * 1664525 + 1013904223;
        return static_cast<float>(state >> 24) / 255;
    });
    for (const float grey : smoothed(noise)) {
        ASSERT_GE(grey, 0);
        ASSERT_LE(grey, 1);
    }
    const gpu::Texture one = gpu::Texture::make_2d(GL_RGBA8, ivec2(1));
    one.bind(0);
    render::Fxaa(ivec2(1)).smooth(one);
    EXPECT_EQ(one.read_floats(1).front(), 0);
}

}  // namespace fxaa_test
}  // namespace lanthorn

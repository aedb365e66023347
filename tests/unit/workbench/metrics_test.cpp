#include "lanthorn/workbench/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "lanthorn/core/error.h"
#include "lanthorn/workbench/flip.h"

namespace lanthorn::workbench {
namespace {

ImageF image(int width, int height, int channels, float value) {
    ImageF result;
    result.width = width;
    result.height = height;
    result.channels = channels;
    result.pixels.assign(static_cast<std::size_t>(width * height * channels), value);
    return result;
}

// A picture with an edge, a gradient and some texture.
ImageF picture(int shift = 0) {
    ImageF result = image(48, 32, 3, 0);
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 48; ++x) {
            const int u = x + shift;
            result.at(x, y, 0) = u > 20 ? 0.8f : 0.1f;
            result.at(x, y, 1) = static_cast<float>(y) / 32;
            result.at(x, y, 2) = (u / 3 + y / 3) % 2 ? 0.3f : 0.4f;
        }
    }
    return result;
}

double mean(const std::vector<float>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

TEST(Compare, EqualImages) {
    const Comparison c = compare(picture(), picture(), "a", "b");
    EXPECT_EQ(c.all.relrmse, 0);
    EXPECT_EQ(c.all.max, 0);
    EXPECT_EQ(c.all.flux, 1);
    EXPECT_TRUE(std::isinf(c.psnr));
}

TEST(Compare, KnownDifference) {
    ImageF reference = image(2, 1, 3, 2.0f);
    ImageF other = reference;
    other.at(0, 0, 0) = 5;  // one of six values differs by 3
    const Comparison c = compare(other, reference, "a", "b");
    EXPECT_DOUBLE_EQ(c.all.rmse, std::sqrt(9.0 / 6.0));
    EXPECT_DOUBLE_EQ(c.all.relrmse, std::sqrt(9.0 / 6.0) / 2);
    EXPECT_DOUBLE_EQ(c.all.mae, 0.5);
    EXPECT_DOUBLE_EQ(c.all.max, 3);
    EXPECT_DOUBLE_EQ(c.all.flux, 15.0 / 12.0);
    ASSERT_EQ(c.channels.size(), 3u);
    EXPECT_DOUBLE_EQ(c.channels[0].relrmse, std::sqrt(9.0 / 2.0) / 2);
    EXPECT_DOUBLE_EQ(c.channels[1].relrmse, 0);
    EXPECT_DOUBLE_EQ(c.psnr, 10 * std::log10(4 / 1.5)) << "peak: the reference's largest value";
}

TEST(Compare, BackgroundDoesNotCount) {
    ImageF reference = image(4, 1, 3, 1.0f), other = image(4, 1, 3, 1.5f);
    const Comparison all = compare(other, reference, "a", "b");
    for (int c = 0; c < 3; ++c) {
        reference.at(3, 0, c) = other.at(3, 0, c) = 0;
    }
    const Comparison some = compare(other, reference, "a", "b");
    EXPECT_EQ(some.valid_pixels, 3u);
    EXPECT_DOUBLE_EQ(some.all.relrmse, all.all.relrmse);
    other.at(3, 0, 1) = 1;  // light where the reference has none does count
    EXPECT_EQ(compare(other, reference, "a", "b").valid_pixels, 4u);
}

TEST(Compare, OnlyTheMaskCounts) {
    const ImageF reference = image(3, 1, 3, 1.0f);
    ImageF other = reference;
    other.at(0, 0, 0) = 3;
    other.at(1, 0, 1) = 2;
    const Comparison c = compare(other, reference, "a", "b", {0, 1, 1});
    EXPECT_EQ(c.valid_pixels, 2u);
    EXPECT_EQ(c.valid, (PixelMask{0, 1, 1}));
    EXPECT_DOUBLE_EQ(c.channels[0].bias, 0);
    EXPECT_DOUBLE_EQ(c.channels[1].bias, 0.5);
    EXPECT_DOUBLE_EQ(c.all.rmse, std::sqrt(1.0 / 6.0));
    EXPECT_DOUBLE_EQ(c.psnr, 10 * std::log10(1 / (1.0 / 6.0)));
    EXPECT_DOUBLE_EQ(mean_over({9, 1, 2}, {0, 1, 1}), 1.5);
    EXPECT_DOUBLE_EQ(mean_over({9, 1, 2}, {}), 4);
    EXPECT_THROW(compare(other, image(3, 1, 3, 0), "a", "b", {0, 1, 1}), InputError);
}

TEST(Compare, LitPixelsAreThoseNotBlack) {
    ImageF mask = image(3, 1, 3, 0);
    mask.at(1, 0, 2) = 0.1f;
    EXPECT_EQ(lit_pixels(mask), (PixelMask{0, 1, 0}));
}

TEST(Compare, RefusesWhatCannotBeCompared) {
    const ImageF good = picture();
    ImageF nan = good;
    nan.at(5, 7, 1) = std::nanf("");
    for (const auto& [a, b] :
         {std::pair(good, image(48, 31, 3, 1)), std::pair(good, image(48, 32, 1, 1)), std::pair(nan, good),
          std::pair(good, nan), std::pair(good, image(48, 32, 3, 0))}) {
        EXPECT_THROW(compare(a, b, "a", "b"), InputError);
    }
    try {
        compare(good, nan, "image.exr", "reference.exr");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(),
                     "reference.exr: pixel (5, 7) channel 1: found nan, expected finite values");
    }
}

TEST(RelativeError, IsByPixelAndRelativeToTheMean) {
    ImageF reference = image(2, 1, 3, 4.0f), other = reference;
    other.at(1, 0, 2) = 10;
    EXPECT_EQ(relative_error(other, reference, 4), (std::vector<float>{0, 0.5f}));
}

TEST(HeatMap, GoesFromBlackToWhite) {
    const ImageF map = heat_map({-1, 0, 0.5f, 1, 9}, 5, 1);
    for (int c = 0; c < 3; ++c) {
        EXPECT_EQ(map.at(0, 0, c), 0);
        EXPECT_EQ(map.at(1, 0, c), 0);
        EXPECT_EQ(map.at(3, 0, c), 1);
        EXPECT_EQ(map.at(4, 0, c), 1);
    }
    EXPECT_GT(map.at(2, 0, 0), map.at(2, 0, 1));
}

TEST(Flip, EqualImagesDoNotFlip) {
    for (const float value : flip(picture(), picture())) {
        ASSERT_EQ(value, 0);
    }
}

TEST(Flip, LargestForGreenAgainstBlue) {
    ImageF green = image(16, 16, 3, 0), blue = green;
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) {
            green.at(x, y, 1) = 1;
            blue.at(x, y, 2) = 1;
        }
    }
    EXPECT_NEAR(mean(flip(green, blue)), 1, 1e-4);
    EXPECT_NEAR(mean(flip(blue, green)), 1, 1e-4);
}

TEST(Flip, GrowsWithTheDifferenceAndStaysWithinOne) {
    const ImageF reference = picture();
    double last = 0;
    for (const float offset : {0.01f, 0.05f, 0.2f}) {
        ImageF other = reference;
        for (float& v : other.pixels) {
            v = std::min(v + offset, 1.0f);
        }
        const auto map = flip(other, reference);
        for (const float v : map) {
            ASSERT_GE(v, 0);
            ASSERT_LE(v, 1);
        }
        EXPECT_GT(mean(map), last);
        last = mean(map);
    }
}

TEST(Flip, FlatGreysDifferByTheirLightnessAlone) {
    // Without features and colour, the error is the redistributed power 0.7 of the difference in CIELAB
    // lightness.
    const float a = 0.5f, b = 0.6f;
    const auto lightness = [](double v) { return 116 * std::cbrt(std::pow((v + 0.055) / 1.055, 2.4)) - 16; };
    const double difference = std::pow(lightness(b) - lightness(a), 0.7);
    const double largest = std::pow(41.2759, 1.0);  // of green against blue, by the authors' implementation
    EXPECT_NEAR(mean(flip(image(24, 24, 3, a), image(24, 24, 3, b))), 0.95 / (0.4 * largest) * difference,
                2e-3);
}

TEST(Flip, LinearPicturesAreSeenAsTheirEncodedOnes) {
    const auto decoded = [](ImageF picture) {
        for (float& v : picture.pixels) {
            v = v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
        }
        return picture;
    };
    EXPECT_NEAR(mean(flip(decoded(picture(2)), decoded(picture()), Encoding::linear)),
                mean(flip(picture(2), picture())), 1e-5);
}

TEST(Flip, AnEdgeThatMovesIsSeen) {
    EXPECT_GT(mean(flip(picture(2), picture())), 0.05);
}

}  // namespace
}  // namespace lanthorn::workbench

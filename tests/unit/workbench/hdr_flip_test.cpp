#include "lanthorn/workbench/hdr_flip.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lanthorn::workbench {
namespace {

// A ramp of `stops` stops from left to right; pixels of the first row are black.
ImageF ramp(float brightest, float stops) {
    ImageF result;
    result.width = 41;
    result.height = 16;
    result.channels = 3;
    result.pixels.assign(3 * 41 * 16, 0);
    for (int y = 1; y < 16; ++y) {
        for (int x = 0; x < 41; ++x) {
            for (int c = 0; c < 3; ++c) {
                result.at(x, y, c) = brightest * std::exp2(stops * (static_cast<float>(x) / 40 - 1));
            }
        }
    }
    return result;
}

ImageF scaled(ImageF image, float factor) {
    for (float& v : image.pixels) {
        v *= factor;
    }
    return image;
}

TEST(HdrFlip, ExposuresGoFromTheBrightestToTheMedian) {
    const Exposures e = flip_exposures(ramp(100, 12));
    const double x = 100 * std::exp2(e.start);
    const double shown =
        (0.6 * 0.6 * 2.51 * x * x + 0.6 * 0.03 * x) / (0.6 * 0.6 * 2.43 * x * x + 0.6 * 0.59 * x + 0.14);
    EXPECT_NEAR(shown, 0.85, 1e-6) << "by Narkowicz's curve";
    EXPECT_NEAR(e.stop - e.start, 6, 1e-5) << "the median is half way down the ramp, black left out";
    EXPECT_EQ(e.count, 6);
    EXPECT_DOUBLE_EQ(e.at(0), e.start);
    EXPECT_NEAR(e.at(5), e.stop, 1e-12);
}

TEST(HdrFlip, BlackReferenceHasOneExposure) {
    EXPECT_EQ(flip_exposures(scaled(ramp(1, 4), 0)).count, 1);
}

TEST(HdrFlip, EqualImagesDoNotFlip) {
    for (const float value : hdr_flip(ramp(100, 12), ramp(100, 12))) {
        ASSERT_EQ(value, 0);
    }
}

TEST(HdrFlip, UnitsOfLightDoNotMatter) {
    const ImageF reference = ramp(1, 12), image = scaled(reference, 1.3f);
    const auto a = hdr_flip(image, reference);
    const auto b = hdr_flip(scaled(image, 4096), scaled(reference, 4096));
    for (std::size_t i = 0; i < a.size(); ++i) {
        ASSERT_NEAR(a[i], b[i], 1e-4);
    }
}

TEST(HdrFlip, SeesInTheShadowsWhatOneExposureHides) {
    const ImageF reference = ramp(1, 14);
    ImageF image = reference;
    for (int y = 1; y < 16; ++y) {
        for (int c = 0; c < 3; ++c) {
            image.at(20, y, c) *= 3;  // seven stops down
        }
    }
    const std::size_t place = 8 * 41 + 20;
    EXPECT_GT(hdr_flip(image, reference)[place], 2 * flip(image, reference, Encoding::linear)[place]);
}

}  // namespace
}  // namespace lanthorn::workbench

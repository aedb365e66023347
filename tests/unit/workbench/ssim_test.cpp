#include "lanthorn/workbench/ssim.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lanthorn::workbench {
namespace {

ImageF flat(float value) {
    ImageF result;
    result.width = 24;
    result.height = 16;
    result.channels = 3;
    result.pixels.assign(3 * 24 * 16, value);
    return result;
}

// Stripes two pixels wide.
ImageF stripes(float amplitude) {
    ImageF result = flat(0.5f);
    for (int y = 0; y < result.height; ++y) {
        for (int x = 0; x < result.width; ++x) {
            for (int c = 0; c < 3; ++c) {
                result.at(x, y, c) += (x / 2) % 2 == 0 ? amplitude : -amplitude;
            }
        }
    }
    return result;
}

TEST(Ssim, EqualImagesAreOne) {
    for (const float value : ssim(stripes(0.2f), stripes(0.2f), 1, {})) {
        ASSERT_NEAR(value, 1, 1e-6);
    }
}

TEST(Ssim, FlatImagesDifferByTheirMeansAlone) {
    const double a = 0.3, b = 0.6;
    for (const double peak : {1.0, 4.0}) {
        const double c1 = std::pow(0.01 * peak, 2);
        const double expected = (2 * a * b + c1) / (a * a + b * b + c1);
        for (const float value : ssim(flat(0.3f), flat(0.6f), peak, {})) {
            ASSERT_NEAR(value, expected, 1e-6) << "at borders, too";
        }
    }
}

TEST(Ssim, InvertedStructureIsNegative) {
    for (const float value : ssim(stripes(-0.3f), stripes(0.3f), 1, {})) {
        ASSERT_LT(value, -0.7f);
    }
}

TEST(Ssim, WhatTheMaskLeavesOutDoesNotCount) {
    const ImageF reference = stripes(0.2f);
    ImageF image = reference;
    PixelMask mask(24 * 16, 1);
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 12; ++x) {
            image.at(x, y, 1) = 9;
            mask[static_cast<std::size_t>(24 * y + x)] = 0;
        }
    }
    const std::vector<float> map = ssim(image, reference, 1, mask);
    for (std::size_t i = 0; i < map.size(); ++i) {
        ASSERT_NEAR(map[i], mask[i], 1e-6);
    }
    EXPECT_LT(ssim(image, reference, 1, {})[13], 0.9f) << "without it, it does";
}

}  // namespace
}  // namespace lanthorn::workbench

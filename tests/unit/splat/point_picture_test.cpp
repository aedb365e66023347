// Points that are splatted as a picture of their own.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <span>

#include "gi_module/reference/random.h"
#include "gi_module/techniques/splat/point_splats.h"

namespace lanthorn::gi::test {
namespace {

std::vector<PixelSurface> scattered(std::uint32_t count) {
    std::vector<PixelSurface> points(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const reference::RandomNumbers random(1, 2, i);
        points[i] = {vec3(random.pair(0), random.pair(1).x), i % 7 == 0 ? kNoSide : i % 2};
    }
    return points;
}

TEST(PointPicture, EveryPointWithASurfaceHasAPixelOfItsOwn) {
    for (const std::uint32_t count : {0u, 1u, 2u, 64u, 65u, 1000u, 4999u}) {
        const std::vector<PixelSurface> points = scattered(count);
        const PointPicture picture = point_picture(points);
        std::set<std::uint32_t> taken;
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t pixel = picture.pixels[i];
            if (points[i].side == kNoSide) {
                EXPECT_EQ(pixel, kNoPixel);
                continue;
            }
            ASSERT_LT(pixel, static_cast<std::uint32_t>(picture.size.x * picture.size.y));
            EXPECT_TRUE(taken.insert(pixel).second) << i;
        }
        // Not much larger than it has to be, and as high as it is wide.
        const auto pixels = static_cast<std::uint32_t>(picture.size.x * picture.size.y);
        EXPECT_LE(pixels, 64 * ((taken.size() + 63) / 64 + static_cast<std::size_t>(picture.size.x / 8)));
        EXPECT_LE(picture.size.y, picture.size.x);
    }
}

// Else photons of a whole wall would have to be held against every tile.
TEST(PointPicture, TilesAreOfOneSideAndSmall) {
    const std::vector<PixelSurface> points = scattered(5000);
    const PointPicture picture = point_picture(points);
    std::vector<Aabb> boxes(static_cast<std::size_t>(picture.size.x * picture.size.y) / 64);
    std::vector<std::set<SurfaceSide>> sides(boxes.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].side != kNoSide) {
            const int x = static_cast<int>(picture.pixels[i]) % picture.size.x / 8,
                      y = static_cast<int>(picture.pixels[i]) / picture.size.x / 8;
            const auto tile = static_cast<std::size_t>(y * picture.size.x / 8 + x);
            boxes[tile].add(points[i].position);
            sides[tile].insert(points[i].side);
        }
    }
    double diagonals = 0;
    int tiles = 0, mixed = 0;
    for (std::size_t t = 0; t < boxes.size(); ++t) {
        if (!boxes[t].empty()) {
            diagonals += static_cast<double>(boxes[t].diagonal());
            ++tiles;
            mixed += sides[t].size() > 1 ? 1 : 0;
        }
    }
    EXPECT_LE(mixed, 1);
    // 64 of 2143 points of a side fill a cube of 0.31; boxes along the curve are up to twice as long.
    EXPECT_LT(diagonals / tiles, 2 * 0.31 * std::sqrt(3));
}

// Rays come in another order in every run.
TEST(PointPicture, IsTheSameInWhateverOrderPointsCome) {
    std::vector<PixelSurface> points = scattered(500);
    for (std::size_t i = 0; i < 200; ++i) {  // in one cell of the curve
        points[i].position = vec3(0.5f) + 1e-5f * points[i].position;
    }
    const auto pixels = [](const std::vector<PixelSurface>& of) {
        const PointPicture picture = point_picture(of);
        std::vector<vec3> result(static_cast<std::size_t>(picture.size.x * picture.size.y), vec3(-1));
        for (std::size_t i = 0; i < of.size(); ++i) {
            if (picture.pixels[i] != kNoPixel) {
                result[picture.pixels[i]] = of[i].position;
            }
        }
        return result;
    };
    const std::vector<vec3> before = pixels(points);
    std::ranges::reverse(points);
    EXPECT_EQ(pixels(points), before);
    std::ranges::rotate(points, points.begin() + 123);
    EXPECT_EQ(pixels(points), before);
}

TEST(PointPicture, AFarPointOfAnotherSideLeavesTheOthersInTheirPlaces) {
    std::vector<PixelSurface> points = scattered(1000);
    const PointPicture near = point_picture(points);
    points.push_back({vec3(1e5f), 2});
    const PointPicture far = point_picture(points);
    EXPECT_EQ(far.size, near.size);
    EXPECT_TRUE(std::ranges::equal(std::span(far.pixels).first(1000), near.pixels));
}

}  // namespace
}  // namespace lanthorn::gi::test

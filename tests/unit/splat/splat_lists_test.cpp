// What tells the tiles their photons: bounded whatever the kernel's width, and nothing left out.
#include "gi_module/techniques/splat/splat_lists.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "gi_module/reference/random.h"

namespace lanthorn::gi::test {
namespace splat_lists_test {

constexpr ivec2 kSize(64, 48);  // 48 tiles
constexpr SurfaceSide kSides = 3;

// A picture of three surfaces beside each other, and photons all over them, 20 to a block and less.
struct Stripes {
    reference::TileWorkers workers{2};
    PictureSurfaces picture;
    RecordRun run;

    Stripes() {
        std::vector<PixelSurface> pixels;
        for (int y = 0; y < kSize.y; ++y) {
            for (int x = 0; x < kSize.x; ++x) {
                pixels.push_back({vec3(x, y, 0), static_cast<SurfaceSide>(x * 3 / kSize.x)});
            }
        }
        picture.set(kSize, pixels);
        std::vector<std::uint16_t> groups;
        for (std::uint32_t i = 0; i < 6000; ++i) {
            const vec2 u = reference::RandomNumbers(1, 0, 2 * i).pair(0) * vec2(kSize);
            run.records.push_back(
                {vec3(u, 0), PhotonRecord::pack({1, 1, 1}, static_cast<SurfaceSide>(u.x * 3 / kSize.x))});
            groups.push_back(static_cast<std::uint16_t>(i % 4));
        }
        arrange(run, groups);
    }

    using Entries = std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>>;
    static void add(const SplatLists& lists, Entries& entries) {
        for (std::uint32_t t = 0; t + 1 < lists.firsts.size(); ++t) {
            for (std::uint32_t e = lists.firsts[t]; e < lists.firsts[t + 1]; ++e) {
                const SplatEntry& entry = lists.entries[e];
                EXPECT_TRUE(entries.insert({t, entry.first, entry.count, entry.group}).second);
            }
        }
    }
};

TEST(SplatLists, ALimitCutsThemIntoPiecesThatHoldTheSame) {
    Stripes s;
    for (const float h : {2.0f, 20.0f, 1000.0f}) {
        const std::vector<float> bandwidths(kSides, h);
        Stripes::Entries whole, pieces;
        Stripes::add(splat_lists(s.run.blocks, s.picture, bandwidths, {}, s.workers), whole);
        constexpr std::size_t kMost = 300;
        int cuts = 0;
        for (std::span<const PhotonBlock> left = s.run.blocks; !left.empty(); ++cuts) {
            const std::size_t now = blocks_at_once(left, s.picture, kMost);
            ASSERT_GE(now, 1u);
            ASSERT_LE(now, left.size());
            const SplatLists lists = splat_lists(left.first(now), s.picture, bandwidths, {}, s.workers);
            EXPECT_LE(lists.entries.size(), kMost);
            Stripes::add(lists, pieces);
            left = left.subspan(now);
        }
        EXPECT_GT(cuts, 3);
        EXPECT_EQ(pieces, whole) << h;
        EXPECT_FALSE(whole.empty());
    }
}

// With kernels that reach everything the bound is what there is: no piece is smaller than it must be.
TEST(SplatLists, TheLimitIsReachedWhereKernelsReachEverything) {
    Stripes s;
    const std::vector<float> bandwidths(kSides, 1000.0f);
    const std::size_t now = blocks_at_once(s.run.blocks, s.picture, 300);
    const auto entries = [&](std::size_t blocks) {
        return splat_lists(std::span(s.run.blocks).first(blocks), s.picture, bandwidths, {}, s.workers)
            .entries.size();
    };
    EXPECT_LE(entries(now), 300u);
    EXPECT_GT(entries(now + 1), 300u);
}

TEST(SplatLists, ABlockIsNeverCut) {
    Stripes s;
    EXPECT_EQ(blocks_at_once(s.run.blocks, s.picture, 0), 1u);
    EXPECT_EQ(blocks_at_once({}, s.picture, 0), 0u);
    EXPECT_EQ(blocks_at_once(s.run.blocks, s.picture, 1u << 30), s.run.blocks.size());
}

// Photons of a surface that nobody sees make no entries and no cuts.
TEST(SplatLists, WhatIsOutOfSightCostsNothing) {
    Stripes s;
    RecordRun unseen;
    for (std::uint32_t i = 0; i < 1000; ++i) {
        unseen.records.push_back({vec3(i, 0, 0), PhotonRecord::pack({1, 1, 1}, 77)});
    }
    arrange(unseen);
    EXPECT_EQ(blocks_at_once(unseen.blocks, s.picture, 0), unseen.blocks.size());
}

}  // namespace splat_lists_test
}  // namespace lanthorn::gi::test

// Ranges that are given out and taken back, against an array that marks what is in use.
#include "lanthorn/core/range_allocator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace lanthorn {
namespace {

TEST(RangeAllocator, GivesOutTakesBackAndJoins) {
    RangeAllocator places;
    EXPECT_FALSE(places.take(1));
    EXPECT_EQ(places.take(0), 0u);
    places.grow(10);
    EXPECT_EQ(places.take(4), 0u);
    EXPECT_EQ(places.take(4), 4u);
    EXPECT_FALSE(places.take(3));
    places.give_back(0, 4);
    EXPECT_EQ(places.free(), 6u);
    EXPECT_FALSE(places.take(5)) << "in two pieces";
    places.give_back(4, 4);
    EXPECT_EQ(places.take(10), 0u);
    places.grow(12);
    EXPECT_EQ(places.take(2), 10u);
    EXPECT_EQ(places.free(), 0u);
    EXPECT_EQ(places.capacity(), 12u);
}

TEST(RangeAllocator, GivesOutWhatNobodyHas) {
    RangeAllocator ranges;
    std::vector<bool> used;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> held;
    std::mt19937 random(5);
    std::size_t asked = 0;
    for (int i = 0; i < 4000; ++i) {
        if (!held.empty() && (held.size() > 30 || random() % 2 == 0)) {
            const std::size_t k = random() % held.size();
            const auto [first, count] = held[k];
            std::fill_n(used.begin() + first, count, false);
            ranges.give_back(first, count);
            held.erase(held.begin() + static_cast<std::ptrdiff_t>(k));
            asked -= count;
            continue;
        }
        const auto count = static_cast<std::uint32_t>(1 + random() % 20);
        auto free = ranges.take(count);
        if (!free) {
            used.resize(used.size() + count, false);
            ranges.grow(used.size());
            free = ranges.take(count);
        }
        ASSERT_TRUE(free);
        const auto first = static_cast<std::uint32_t>(*free);
        for (std::uint32_t j = first; j < first + count; ++j) {
            ASSERT_FALSE(used[j]) << j;
            used[j] = true;
        }
        held.emplace_back(first, count);
        asked += count;
    }
    EXPECT_LT(used.size(), 900u) << asked << " are held, at most 31 ranges of 20 at any time";
    for (const auto& [first, count] : held) {
        ranges.give_back(first, count);
    }
    EXPECT_EQ(ranges.take(used.size()), 0u) << "all of it is free, in one piece";
}

}  // namespace
}  // namespace lanthorn

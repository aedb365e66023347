// Ranges that are given back and taken again, against an array that marks what is in use.
#include "gi_module/reference/free_ranges.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace lanthorn::reference {
namespace {

TEST(FreeRanges, HaveNothingAtFirst) {
    FreeRanges ranges;
    EXPECT_FALSE(ranges.take(1));
    ranges.give(7, 0);
    EXPECT_EQ(ranges.size(), 0u);
}

TEST(FreeRanges, JoinWithBothNeighbours) {
    FreeRanges ranges;
    ranges.give(0, 2);
    ranges.give(5, 3);
    EXPECT_EQ(ranges.size(), 2u);
    EXPECT_FALSE(ranges.take(4));
    ranges.give(2, 3);
    EXPECT_EQ(ranges.size(), 1u);
    EXPECT_EQ(ranges.take(8), 0u);
    EXPECT_EQ(ranges.size(), 0u);
}

TEST(FreeRanges, GiveWhatNobodyHas) {
    FreeRanges ranges;
    std::vector<bool> used;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> held;
    std::mt19937 random(5);
    std::size_t asked = 0;
    for (int i = 0; i < 4000; ++i) {
        if (!held.empty() && (held.size() > 30 || random() % 2 == 0)) {
            const std::size_t k = random() % held.size();
            const auto [first, count] = held[k];
            std::fill_n(used.begin() + first, count, false);
            ranges.give(first, count);
            held.erase(held.begin() + static_cast<std::ptrdiff_t>(k));
            asked -= count;
            continue;
        }
        const auto count = static_cast<std::uint32_t>(1 + random() % 20);
        auto first = static_cast<std::uint32_t>(used.size());
        if (const auto free = ranges.take(count)) {
            first = *free;
        } else {
            used.resize(used.size() + count, false);
        }
        for (std::uint32_t j = first; j < first + count; ++j) {
            ASSERT_FALSE(used[j]) << j;
            used[j] = true;
        }
        held.emplace_back(first, count);
        asked += count;
    }
    EXPECT_LT(used.size(), 900u) << asked << " are held, at most 31 ranges of 20 at any time";
    for (const auto& [first, count] : held) {
        ranges.give(first, count);
    }
    EXPECT_EQ(ranges.size(), 1u) << "all of it is free, in one piece";
}

}  // namespace
}  // namespace lanthorn::reference

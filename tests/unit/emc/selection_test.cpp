// The selection algorithm on a toy whose areas can be counted by hand: each candidate sees a set of unit
// cells.
#include "gi_module/techniques/emc/maps/selection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace lanthorn::gi {
namespace {

using Cells = std::set<int>;

MeasureCoverage toy(std::vector<Cells> sees) {
    return [sees = std::move(sees)](const std::vector<int>& viewers, const std::vector<int>& selected) {
        std::vector<double> areas;
        for (int v : viewers) {
            const Cells& own = sees[static_cast<std::size_t>(v)];
            areas.push_back(static_cast<double>(std::ranges::count_if(own, [&](int cell) {
                return std::ranges::none_of(selected, [&](int c) {
                    return c != v && sees[static_cast<std::size_t>(c)].contains(cell);
                });
            })));
        }
        return areas;
    };
}

TEST(Selection, GreedyTakesTheLargestNewArea) {
    // 1 sees most; 0 sees a part of that; 2 sees little but all of it new.
    const auto measure = toy({{1, 2, 3}, {1, 2, 3, 4, 5}, {8, 9}, {5, 6}});
    EXPECT_EQ(greedy_selection(4, 3, 0, measure), (std::vector<int>{1, 2, 3}));
}

TEST(Selection, AMapThatAddsNothingIsNotTaken) {
    const auto measure = toy({{1, 2, 3}, {1, 2}, {3}});
    EXPECT_EQ(greedy_selection(3, 3, 1e-3, measure), (std::vector<int>{0}));
}

TEST(Selection, RefinementMendsTheGreedyChoice) {
    // Greedy takes 0 first (largest), then 1 and 2 make it superfluous; 3 is new.
    const auto measure = toy({{1, 2, 3, 4}, {1, 2, 5}, {3, 4, 6}, {9}});
    std::vector<int> selected = greedy_selection(4, 3, 0, measure);
    EXPECT_EQ(selected, (std::vector<int>{0, 1, 2}));
    const int steps = refine_until_stable(selected, 4, 16, measure);
    EXPECT_EQ(steps, 2);  // one exchange, one that changes nothing
    std::ranges::sort(selected);
    EXPECT_EQ(selected, (std::vector<int>{1, 2, 3}));
}

TEST(Selection, AReservedMemberStays) {
    // 3 is no candidate: it shows less than all others, and 0 leaves instead.
    const auto measure = toy({{1, 2}, {3, 4, 5}, {6, 7, 8}, {9}});
    std::vector<int> selected{0, 1, 3};
    const Exchange exchange = exchange_for(selected, 2, 3, measure);
    EXPECT_EQ(exchange.removed, 0);
    EXPECT_EQ(selected, (std::vector<int>{2, 1, 3}));
    std::vector<int> reserved{3};
    EXPECT_TRUE(exchange_for(reserved, 3, 3, measure).none());
}

TEST(Selection, GrowsWhileAllSeeWhatTheOthersDoNot) {
    const auto measure = toy({{1, 2}, {3}, {4}, {1}, {9}});
    const auto grows = [&](const std::vector<int>& larger) {
        return is_to_grow(larger, measure(larger, larger), 4, 0.1);
    };
    EXPECT_TRUE(grows({0, 1, 2}));
    EXPECT_FALSE(grows({0, 1, 3})) << "the newcomer adds nothing";
    EXPECT_FALSE(grows({0, 3, 2})) << "a member adds nothing: the newcomer takes its place";
    EXPECT_TRUE(grows({4, 0, 1})) << "what is reserved does not count";
}

TEST(Selection, AStableChoiceStays) {
    const auto measure = toy({{1, 2, 3}, {4, 5, 6}, {1}});
    std::vector<int> selected{0, 1};
    EXPECT_TRUE(update_step(selected, 3, measure).none());
    EXPECT_EQ(selected, (std::vector<int>{0, 1}));
}

TEST(Selection, NothingToChooseFromIsNoExchange) {
    const auto measure = toy({{1}, {2}});
    std::vector<int> all{0, 1};
    EXPECT_TRUE(update_step(all, 2, measure).none());
    std::vector<int> none;
    EXPECT_TRUE(update_step(none, 2, measure).none());
    EXPECT_TRUE(greedy_selection(0, 8, 0, measure).empty());
}

}  // namespace
}  // namespace lanthorn::gi

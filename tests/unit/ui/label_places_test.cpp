// Labels of the picture beside, above and below one another.
#include "lanthorn/ui/label_places.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace lanthorn::ui {
namespace {

constexpr float kLine = 20, kLow = 10, kHigh = 190;

std::vector<LabelPlace> place_all(const std::vector<LabelPlace>& wanted) {
    std::vector<LabelPlace> placed;
    for (LabelPlace label : wanted) {
        if (const std::optional<float> y = free_height(placed, label, kLine, kLow, kHigh)) {
            label.y = *y;
            placed.push_back(label);
        }
    }
    return placed;
}

TEST(LabelPlaces, AreWhereTheyAreWantedIfTheyCan) {
    const std::vector<LabelPlace> placed = place_all({{0, 50, 60}, {0, 71, 60}, {61, 50, 60}, {0, -9, 5}});
    ASSERT_EQ(placed.size(), 4u);
    EXPECT_EQ(placed[0].y, 50);
    EXPECT_EQ(placed[1].y, 71);
    EXPECT_EQ(placed[2].y, 50);  // beside the first
    EXPECT_EQ(placed[3].y, kLow);
}

// Each label in turn was once held against the last one alone: the third lay on the first.
TEST(LabelPlaces, AThirdCoversNeitherOfTheOthers) {
    const std::vector<LabelPlace> placed = place_all({{0, 100, 60}, {0, 119, 60}, {0, 98, 60}});
    ASSERT_EQ(placed.size(), 3u);
    EXPECT_EQ(placed[1].y, 120);
    EXPECT_EQ(placed[2].y, 80);
}

TEST(LabelPlaces, StayAboveTheLowerEdge) {
    const std::vector<LabelPlace> placed = place_all({{0, 300, 60}, {0, 300, 60}, {0, 300, 60}});
    ASSERT_EQ(placed.size(), 3u);
    EXPECT_EQ(placed[0].y, kHigh);
    EXPECT_EQ(placed[1].y, kHigh - kLine);
    EXPECT_EQ(placed[2].y, kHigh - 2 * kLine);
}

TEST(LabelPlaces, OnesWithoutRoomAreLeftOut) {
    EXPECT_EQ(place_all(std::vector<LabelPlace>(30, {0, 100, 60})).size(), 9u);
}

TEST(LabelPlaces, NoneCoversAnother) {
    std::mt19937 random(7);
    const auto any = [&](float most) { return most * static_cast<float>(random() % 1000) / 1000; };
    for (int round = 0; round < 500; ++round) {
        std::vector<LabelPlace> wanted(12);
        for (LabelPlace& label : wanted) {
            label = {any(200), any(240) - 20, 10 + any(90)};
        }
        const std::vector<LabelPlace> placed = place_all(wanted);
        for (std::size_t i = 0; i < placed.size(); ++i) {
            EXPECT_GE(placed[i].y, kLow);
            EXPECT_LE(placed[i].y, kHigh);
            for (std::size_t k = 0; k < i; ++k) {
                const LabelPlace &a = placed[i], &b = placed[k];
                EXPECT_TRUE(a.x >= b.x + b.width || b.x >= a.x + a.width ||
                            std::abs(a.y - b.y) >= kLine - 0.02f);
            }
        }
    }
}

}  // namespace
}  // namespace lanthorn::ui

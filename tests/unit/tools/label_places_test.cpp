// Names of a chart's points: all to be read where there is room.
#include "tools/lanthorn/trade/label_places.h"

#include <gtest/gtest.h>

#include "gi_module/reference/random.h"

namespace lanthorn::tools {
namespace {

constexpr ChartBox kAll{{0, 0}, {700, 400}};

struct Placed {
    std::vector<ChartLabel> labels;
    std::vector<ChartBox> marks, boxes;
};

Placed place(const std::vector<glm::dvec2>& points, const std::string& text = "coarse-path medium") {
    Placed result;
    for (const glm::dvec2& p : points) {
        result.labels.push_back({p, text});
        result.marks.push_back({p - 7.0, p + 7.0});
    }
    const std::vector<LabelPlace> places = label_places(result.labels, result.marks, kAll);
    for (std::size_t i = 0; i < places.size(); ++i) {
        result.boxes.push_back(label_box(result.labels[i], places[i]));
    }
    return result;
}

void expect_free(const Placed& placed) {
    for (std::size_t i = 0; i < placed.boxes.size(); ++i) {
        for (std::size_t k = 0; k < placed.boxes.size(); ++k) {
            EXPECT_FALSE(k != i && placed.boxes[i].meets(placed.boxes[k])) << i << ' ' << k;
            EXPECT_FALSE(placed.boxes[i].meets(placed.marks[k])) << i << ' ' << k;
        }
        EXPECT_TRUE(glm::all(glm::greaterThanEqual(placed.boxes[i].low, kAll.low)) &&
                    glm::all(glm::lessThanEqual(placed.boxes[i].high, kAll.high)))
            << i;
    }
}

TEST(LabelPlaces, OneStandsBesideItsPoint) {
    const Placed one = place({{300, 200}});
    EXPECT_EQ(one.boxes[0].low.x, 309);
    expect_free(one);
}

TEST(LabelPlaces, PointsCloseTogetherKeepTheirNames) {
    expect_free(place({{300, 200}, {304, 206}, {310, 199}, {320, 203}}));
}

TEST(LabelPlaces, NothingStandsOutside) {
    expect_free(place({{698, 200}, {690, 3}, {3, 398}, {695, 397}}));
}

// Twenty points all over a chart, as `trade` has them.
TEST(LabelPlaces, ManyPointsKeepTheirNames) {
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        std::vector<glm::dvec2> points;
        for (std::uint32_t i = 0; i < 14; ++i) {
            const glm::dvec2 u(reference::RandomNumbers(seed + 1, i, 0).pair(0));
            points.push_back({680 * u.x + 10, 380 * u.y + 10});
        }
        expect_free(place(points));
    }
}

// More than there is room for: they cover something, and are all there.
TEST(LabelPlaces, ACrowdIsStillNamed) {
    const Placed crowd = place(std::vector<glm::dvec2>(60, glm::dvec2(300, 200)));
    EXPECT_EQ(crowd.boxes.size(), 60u);
}

}  // namespace
}  // namespace lanthorn::tools

#include "lanthorn/gi/statistics.h"

#include <gtest/gtest.h>

namespace lanthorn::gi {
namespace {

struct Flies {
    int count = 0;
};
struct Moths {
    int count = 0;
};

TEST(Statistics, HoldAPartOfEachType) {
    GiStatistics statistics;
    statistics.add(Flies{3});
    statistics.add(Moths{5});
    EXPECT_EQ(statistics.of<Flies>().count, 3);
    EXPECT_EQ(statistics.of<Moths>().count, 5);
    statistics.add(Flies{4});
    EXPECT_EQ(statistics.of<Flies>().count, 4);
    EXPECT_EQ(statistics.of<Moths>().count, 5);
    const GiStatistics copy = statistics;
    EXPECT_EQ(copy.of<Flies>().count, 4);
}

TEST(Statistics, WithoutAPartAreThoseOfAnIdleTechnique) {
    EXPECT_EQ(GiStatistics().of<Moths>().count, 0);
}

}  // namespace
}  // namespace lanthorn::gi

#include "tools/workbench/scene/median.h"

#include <gtest/gtest.h>

namespace lanthorn::workbench {
namespace {

TEST(Median, IsTheOneInTheMiddleOrTheMeanOfTwo) {
    EXPECT_EQ(median({}), 0);
    EXPECT_EQ(median({3}), 3);
    EXPECT_EQ(median({9, 1, 2}), 2);
    EXPECT_EQ(median({9, 4, 1, 2}), 3);
}

}  // namespace
}  // namespace lanthorn::workbench

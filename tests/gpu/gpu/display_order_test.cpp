// Which display a context without a window is made on.
#include "engine/gpu/display_order.h"

#include <gtest/gtest.h>

#include <string>

namespace lanthorn {
namespace {

// The displays as they are tried; with '!' where only one that does not draw on the processor will do.
std::string order(bool always_software) {
    const std::vector<std::string> hardware{"a", "b"}, surfaceless{"mesa"}, software{"llvmpipe"};
    std::string names;
    for (const auto& attempt : gpu::display_order(hardware, surfaceless, software, always_software)) {
        names += attempt.display + (attempt.software ? " " : "! ");
    }
    return names;
}

TEST(DisplayOrder, RealDevicesComeBeforeWhatDrawsOnTheProcessor) {
    EXPECT_EQ(order(false), "a! b! mesa! mesa llvmpipe a b ");
}

TEST(DisplayOrder, SoftwareCanBeWanted) {
    EXPECT_EQ(order(true), "mesa llvmpipe a b ");
}

TEST(DisplayOrder, WithoutDevicesSurfacelessIsTried) {
    const std::vector<int> none;
    const auto attempts = gpu::display_order(none, {7}, none, false);
    ASSERT_EQ(attempts.size(), 2u);
    EXPECT_FALSE(attempts[0].software);
    EXPECT_TRUE(attempts[1].software);
}

}  // namespace
}  // namespace lanthorn

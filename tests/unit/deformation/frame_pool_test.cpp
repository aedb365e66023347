#include "engine/deformation/frame_pool.h"

#include <gtest/gtest.h>

#include <thread>
#include <utility>

namespace lanthorn::deform {
namespace {

TEST(FramePool, ArraysAreTakenAgainOnceNobodyHoldsThem) {
    FramePool pool;
    auto first = pool.take(8);
    const auto* kept = first.get();
    auto second = pool.take(8);
    EXPECT_NE(second.get(), kept);
    first.reset();
    const auto again = pool.take(12);
    EXPECT_EQ(again.get(), kept);
    EXPECT_EQ(again->size(), 12u);
}

// What the thread sanitizer watches: the array is made anew only after the other thread has read it.
TEST(FramePool, AnotherThreadMayLetGoOfAnArray) {
    FramePool pool;
    auto first = pool.take(8);
    const auto* kept = first.get();
    float sum = 0;
    std::thread reader([held = std::move(first), &sum]() mutable {
        for (const VertexFrame& frame : *held) {
            sum += frame.normal.z;
        }
        held.reset();
    });
    while (pool.take(12).get() != kept) {
    }
    reader.join();
    EXPECT_EQ(sum, 8);
}

}  // namespace
}  // namespace lanthorn::deform

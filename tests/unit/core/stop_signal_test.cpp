#include "lanthorn/core/stop_signal.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace lanthorn {
namespace {

using std::chrono::milliseconds;

TEST(StopSignal, NotesTheFirst) {
    const StopSignal stop;
    EXPECT_FALSE(stop.asked());
    EXPECT_EQ(stop.exit_code(), 0);
    EXPECT_STREQ(stop.name(), "");
    std::raise(SIGTERM);
    EXPECT_TRUE(stop.asked());
    EXPECT_EQ(stop.exit_code(), 143);
    EXPECT_STREQ(stop.name(), "SIGTERM");
}

TEST(StopSignal, KnowsAllThree) {
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        const StopSignal stop;
        EXPECT_FALSE(stop.asked());
        std::raise(number);
        EXPECT_EQ(stop.number(), number);
        EXPECT_EQ(stop.exit_code(), 128 + number);
    }
}

TEST(StopSignal, TheSecondEndsTheProgramWhicheverItIs) {
    EXPECT_EXIT(
        {
            const StopSignal stop(milliseconds(0));
            std::raise(SIGINT);
            std::raise(SIGTERM);
        },
        testing::KilledBySignal(SIGTERM), "");
}

TEST(StopSignal, SignalsAtOnceAreOneRequest) {
    const StopSignal stop(std::chrono::hours(1));
    std::vector<std::thread> threads;
    for (int i = 0; i < 8; ++i) {
        threads.emplace_back([] { std::raise(SIGINT); });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    EXPECT_EQ(stop.number(), SIGINT);
}

TEST(StopSignal, GivesBackWhatWasThere) {
    static int heard = 0;
    const auto before = std::signal(SIGINT, [](int) { ++heard; });
    {
        const StopSignal stop;
        std::raise(SIGINT);
        EXPECT_EQ(heard, 0);
    }
    std::raise(SIGINT);
    EXPECT_EQ(heard, 1);
    std::signal(SIGINT, before);
}

TEST(StopSignal, LeavesAnIgnoredHangupIgnored) {
    const auto before = std::signal(SIGHUP, SIG_IGN);
    {
        const StopSignal stop;
        std::raise(SIGHUP);
        EXPECT_FALSE(stop.asked());
    }
    std::signal(SIGHUP, before);
}

}  // namespace
}  // namespace lanthorn

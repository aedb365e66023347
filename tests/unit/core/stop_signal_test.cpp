#include "lanthorn/core/stop_signal.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace lanthorn {
namespace {

using std::chrono::milliseconds;

// None is ignored, also where these tests run under nohup or in the background.
class StopSignalTest : public testing::Test {
  protected:
    StopSignalTest() {
        for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
            std::signal(number, SIG_DFL);
        }
    }
};

TEST_F(StopSignalTest, NotesTheFirst) {
    const StopSignal stop;
    EXPECT_FALSE(stop.asked());
    EXPECT_EQ(stop.exit_code(), 0);
    EXPECT_STREQ(stop.name(), "");
    std::raise(SIGTERM);
    EXPECT_TRUE(stop.asked());
    EXPECT_EQ(stop.exit_code(), 143);
    EXPECT_STREQ(stop.name(), "SIGTERM");
}

TEST_F(StopSignalTest, KnowsAllThree) {
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        const StopSignal stop;
        EXPECT_FALSE(stop.asked());
        std::raise(number);
        EXPECT_EQ(stop.number(), number);
        EXPECT_EQ(stop.exit_code(), 128 + number);
    }
}

TEST_F(StopSignalTest, TheSecondEndsTheProgramWhicheverItIs) {
    EXPECT_EXIT(
        {
            const StopSignal stop(milliseconds(0));
            std::raise(SIGINT);
            std::raise(SIGTERM);
        },
        testing::KilledBySignal(SIGTERM), "");
}

TEST_F(StopSignalTest, SignalsAtOnceAreOneRequest) {
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

TEST_F(StopSignalTest, GivesBackWhatWasThere) {
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

TEST_F(StopSignalTest, LeavesIgnoredOnesIgnored) {
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        std::signal(number, SIG_IGN);
        {
            const StopSignal stop;
            std::raise(number);
            EXPECT_FALSE(stop.asked()) << number;
        }
        EXPECT_EQ(std::signal(number, SIG_DFL), SIG_IGN) << number;
    }
}

}  // namespace
}  // namespace lanthorn

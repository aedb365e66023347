#include "tools/workbench/scene/stopping.h"

#include <gtest/gtest.h>

#include <csignal>

namespace lanthorn::workbench {
namespace {

TEST(MeasuredSteps, GoOnWhileNobodyAsks) {
    MeasuredSteps work("measure", "all is kept", 4);
    int done = 0;
    EXPECT_TRUE(work.part([&] { work.step(), ++done; }));
    EXPECT_TRUE(work.part([&] { work.step(3), ++done; }));
    EXPECT_EQ(done, 2);
    EXPECT_NO_THROW(work.finish());
}

TEST(MeasuredSteps, EndAfterTheOneInWhichASignalComes) {
    std::signal(SIGTERM, SIG_DFL);
    MeasuredSteps work("measure", "all is kept", 3);
    int done = 0;
    EXPECT_FALSE(work.part([&] {
        for (int i = 0; i < 3; ++i) {
            ++done;
            if (i == 1) {
                std::raise(SIGTERM);
            }
            work.step();
        }
    }));
    EXPECT_EQ(done, 2);
    try {
        work.finish();
        FAIL() << "expected Stopped";
    } catch (const Stopped& stopped) {
        EXPECT_STREQ(stopped.what(), "measure: stopped by SIGTERM; all is kept");
        EXPECT_EQ(static_cast<int>(stopped.code()), 143);
    }
}

// What is wrong with the work itself is nobody's wish to stop.
TEST(MeasuredSteps, PassOtherErrorsOn) {
    MeasuredSteps work("measure", "all is kept", 1);
    EXPECT_THROW(work.part([] { throw InputError("room.glb", "", "is no scene"); }), InputError);
    EXPECT_NO_THROW(work.finish());
}

}  // namespace
}  // namespace lanthorn::workbench

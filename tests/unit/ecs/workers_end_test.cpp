#include "lanthorn/ecs/workers_end.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <latch>

namespace lanthorn::ecs {
namespace {

long threads() {
    return std::distance(std::filesystem::directory_iterator("/proc/self/task"), {});
}

TEST(WorkersEnd, NoThreadIsLeftBehindIt) {
#ifdef __SANITIZE_THREAD__
    GTEST_SKIP() << "the sanitizer keeps a thread of its own";
#endif
    if (tbb::info::default_concurrency() < 2) {
        GTEST_SKIP() << "one processor: oneTBB starts no threads";
    }
    testing::FLAGS_gtest_death_test_style = "threadsafe";  // a process without threads to begin with
    EXPECT_EXIT(
        {
            long during = 0;
            {
                const WorkersEndWithMain workers;
                std::latch both(2);
                tbb::parallel_for(
                    0, 2, [&](int) { both.arrive_and_wait(); }, tbb::simple_partitioner());
                during = threads();
            }
            std::_Exit(during > 1 && threads() == 1 ? 0 : 1);
        },
        testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace lanthorn::ecs

// Which commit a recording differs since.
#include "tools/lanthorn/replay/commit_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace lanthorn::tools {
namespace {

TEST(FirstBadCommit, IsFoundInLogManyQuestionsWhereverItIs) {
    for (std::size_t count = 1; count <= 40; ++count) {
        for (std::size_t bad = 0; bad < count; ++bad) {
            int asked = 0;
            const FirstBad found = find_first_bad(count, [&](std::size_t i) {
                ++asked;
                return i >= bad ? CommitVerdict::bad : CommitVerdict::good;
            });
            EXPECT_EQ(found.place, bad);
            EXPECT_TRUE(found.perhaps.empty());
            EXPECT_LE(asked, 6) << count;  // the logarithm of 40, rounded up
        }
    }
}

TEST(FirstBadCommit, AmongUntestableOnesNamesThoseThatMayBeIt) {
    const std::set<std::size_t> untestable = {6, 7, 8};
    std::set<std::size_t> asked;
    const FirstBad found = find_first_bad(16, [&](std::size_t i) {
        EXPECT_TRUE(asked.insert(i).second) << "asked twice: " << i;
        return untestable.contains(i) ? CommitVerdict::untestable
               : i >= 9               ? CommitVerdict::bad
                                      : CommitVerdict::good;
    });
    EXPECT_EQ(found.place, 9u);
    EXPECT_EQ(found.perhaps, (std::vector<std::size_t>{6, 7, 8}));
}

TEST(FirstBadCommit, BehindUntestableOnesIsStillFound) {
    const FirstBad found = find_first_bad(16, [&](std::size_t i) {
        return i >= 5 && i <= 9 ? CommitVerdict::untestable
               : i >= 12        ? CommitVerdict::bad
                                : CommitVerdict::good;
    });
    EXPECT_EQ(found.place, 12u);
    EXPECT_TRUE(found.perhaps.empty());
}

TEST(FirstBadCommit, WhereNoneCanBeTestedMayBeAny) {
    const FirstBad found = find_first_bad(4, [](std::size_t) { return CommitVerdict::untestable; });
    EXPECT_EQ(found.place, 3u);
    EXPECT_EQ(found.perhaps.size(), 3u);
}

}  // namespace
}  // namespace lanthorn::tools

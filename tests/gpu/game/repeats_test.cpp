// Pictures of a session are the same however many threads draw them: what is appended to a list by many of
// them comes in another order each time, and no picture may hang on that.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/repository.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn::game {
namespace {

using testing_tools::file_bytes;

// Six moments of a tour, far apart: the camera jumps between them, and rays know nothing of the light there.
std::vector<std::string> pictures(const std::string& level, const std::string& threads) {
    const testing_tools::TemporaryFolder folder;
    const testing_tools::Outcome outcome =
        testing_tools::run_program(LAMPLIGHTER_BINARY,
                                   {"--headless", "--frames", "6", "--level",
                                    support::repository_file("assets/levels/" + level + ".glb"), "--out",
                                    folder.path("out"), "--size", "96x54", "--preset", "low"},
                                   {"LP_NUM_THREADS=" + threads});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    std::vector<std::string> result;
    for (const std::string& file : testing_tools::files_in(folder.path("out"))) {
        result.push_back(file_bytes(folder.path("out/" + file)));
    }
    return result;
}

// Matte walls beside lamps; mirrors, glass and what they throw.
class Repeats : public testing::TestWithParam<const char*> {};

TEST_P(Repeats, PicturesAreTheSameByOneThreadAndByFour) {
    const std::vector<std::string> one = pictures(GetParam(), "1"), four = pictures(GetParam(), "4");
    ASSERT_EQ(one.size(), 6u);
    ASSERT_EQ(four.size(), one.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one[i], four[i]) << "picture " << i + 1;
    }
}

INSTANTIATE_TEST_SUITE_P(Levels, Repeats, testing::Values("red-wall", "two-glasses"), [](const auto& info) {
    std::string name = info.param;
    std::ranges::replace(name, '-', '_');
    return name;
});

}  // namespace
}  // namespace lanthorn::game

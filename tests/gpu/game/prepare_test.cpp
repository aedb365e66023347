// lamplighter --prepare, as a package or a first start calls it.
#include <gtest/gtest.h>

#include "tests/support/repository.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn::game {
namespace {

using testing_tools::Outcome;
using testing_tools::run_program;

Outcome prepare(const testing_tools::TemporaryFolder& folder, const std::string& level) {
    // The driver keeps its cache where it always does.
    return run_program(LAMPLIGHTER_BINARY, {"--prepare", "--preset", "low", "--level", level},
                       {"XDG_CACHE_HOME=" + folder.path("cache"), "MESA_SHADER_CACHE_DIR=" + folder.path()});
}

TEST(Prepare, SaysAndKeepsWhichLevelIsPrepared) {
    const testing_tools::TemporaryFolder folder;
    const Outcome outcome = prepare(folder, support::repository_file("assets/lantern-room.glb"));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out.find('\n') + 1, outcome.out.size()) << outcome.out;
    EXPECT_TRUE(outcome.out.ends_with(", low: prepared\n")) << outcome.out;
    const std::string kept = testing_tools::file_bytes(folder.path("cache/lamplighter/programs"));
    EXPECT_TRUE(kept.ends_with("\nlow lantern-room\n")) << kept;
}

TEST(Prepare, RefusesALevelThatThereIsNot) {
    const testing_tools::TemporaryFolder folder;
    const Outcome outcome = prepare(folder, folder.path("none.glb"));
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
    EXPECT_NE(outcome.err.find("none.glb"), std::string::npos) << outcome.err;
    EXPECT_EQ(testing_tools::file_bytes(folder.path("cache/lamplighter/programs")), "");
}

}  // namespace
}  // namespace lanthorn::game

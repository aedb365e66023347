// What is known to be compiled, from one run to the next.
#include "game/presentation/prepared_programs.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/unit/tools/run_program.h"

namespace lanthorn::game {
namespace {

const gpu::GlInfo kDriver = {"Mesa", "llvmpipe (LLVM 15)", "4.5 Mesa 22", true};

Options with(std::vector<std::string> set) {
    Options options;
    options.set = std::move(set);
    return options;
}

TEST(PreparedPrograms, AreKnownToTheNextRun) {
    const testing_tools::TemporaryFolder folder;
    const std::string path = folder.path("not/yet/programs");
    PreparedPrograms first(kDriver, path);
    EXPECT_FALSE(first.has("pool", "low", {}));
    first.add("pool", "low", {});
    first.add("mirrors", "medium", with({"gi.bounces=2"}));
    const PreparedPrograms next(kDriver, path);
    EXPECT_TRUE(next.has("pool", "low", {}));
    EXPECT_TRUE(next.has("mirrors", "medium", with({"gi.bounces=2"})));
    EXPECT_FALSE(next.has("pool", "medium", {}));
    EXPECT_FALSE(next.has("mirrors", "medium", {}));
    EXPECT_FALSE(next.has("shutter", "low", {}));
}

// Its cache holds other programs, or none.
TEST(PreparedPrograms, OfAnotherDriverCountForNothing) {
    const testing_tools::TemporaryFolder folder;
    const std::string path = folder.path("programs");
    PreparedPrograms(kDriver, path).add("pool", "low", {});
    gpu::GlInfo newer = kDriver;
    newer.version = "4.5 Mesa 23";
    PreparedPrograms of_newer(newer, path);
    EXPECT_FALSE(of_newer.has("pool", "low", {}));
    of_newer.add("mirrors", "low", {});
    EXPECT_FALSE(PreparedPrograms(kDriver, path).has("pool", "low", {}));
    EXPECT_TRUE(PreparedPrograms(newer, path).has("mirrors", "low", {}));
}

TEST(PreparedPrograms, ADamagedFileSaysNothing) {
    const testing_tools::TemporaryFolder folder;
    const std::string path = folder.path("programs");
    std::ofstream(path, std::ios::binary) << std::string("\0\n\xff low pool", 14);
    PreparedPrograms prepared(kDriver, path);
    EXPECT_FALSE(prepared.has("pool", "low", {}));
    prepared.add("pool", "low", {});
    EXPECT_TRUE(PreparedPrograms(kDriver, path).has("pool", "low", {}));
}

// Where the environment names no folder, or one that cannot be written, all is well but forgotten.
TEST(PreparedPrograms, CanBeForgotten) {
    for (const char* path : {"", "/proc/nowhere/programs"}) {
        PreparedPrograms prepared(kDriver, path);
        prepared.add("pool", "low", {});
        EXPECT_TRUE(prepared.has("pool", "low", {}));
        EXPECT_FALSE(PreparedPrograms(kDriver, path).has("pool", "low", {}));
    }
}

}  // namespace
}  // namespace lanthorn::game

// Everything that fuzzing starts from and has found, run once: sound inputs are read, and no finding comes
// back.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/fuzz/target.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn::fuzz {
namespace {

namespace fs = std::filesystem;

class Inputs : public testing::TestWithParam<Target> {};

TEST_P(Inputs, SoundOnesAreHarmless) {
    const std::vector<std::string> inputs = GetParam().seeds();
    EXPECT_FALSE(inputs.empty());
    for (const std::string& input : inputs) {
        EXPECT_NO_THROW(run_target(GetParam(), input));
    }
}

TEST_P(Inputs, EveryPrefixOfASoundOneIsHarmless) {
    for (const std::string& input : GetParam().seeds()) {
        const std::size_t step = 1 + input.size() / 50;
        for (std::size_t size = 0; size < input.size(); size += step) {
            ASSERT_NO_THROW(run_target(GetParam(), std::string_view(input).substr(0, size)))
                << size << " bytes";
        }
    }
}

// tests/fuzz/inputs/TARGET: kept for the ways they take through the code, or because they once broke
// something.
TEST_P(Inputs, KeptOnesAreHarmless) {
    const fs::path folder = support::repository_file("tests/fuzz/inputs/" + std::string(GetParam().name));
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none)) {
        EXPECT_NO_THROW(run_target(GetParam(), testing_tools::file_bytes(entry.path()))) << entry.path();
    }
}

TEST_P(Inputs, DamagedOnesAreHarmless) {
    const std::vector<std::string> inputs = GetParam().seeds();
    for (std::uint64_t round = 0; round < 300; ++round) {
        Mutator mutator(1000003 + round);
        std::string input = inputs[round % inputs.size()];
        if (GetParam().damage != nullptr && round % 2 == 0) {
            input = GetParam().damage(input, mutator);
        } else {
            mutator.damage_bytes(input);
        }
        ASSERT_NO_THROW(run_target(GetParam(), input)) << "round " << round;
    }
}

INSTANTIATE_TEST_SUITE_P(Targets, Inputs, testing::ValuesIn(targets().begin(), targets().end()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace lanthorn::fuzz

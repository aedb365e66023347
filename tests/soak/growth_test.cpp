#include "tests/soak/growth.h"

#include <gtest/gtest.h>

namespace lanthorn::game {
namespace {

shell::Holdings some() {
    return {.heap = 50'000'000,
            .resident = 300'000'000,
            .gpu = 40'000'000,
            .textures = 90,
            .buffers = 120,
            .framebuffers = 30,
            .queries = 4,
            .programs = 80,
            .files = 20,
            .threads = 9};
}

// `step` more in every sample; on top of it what comes and goes.
std::vector<Sample> samples(std::uint64_t shell::Holdings::*kind, std::uint64_t step, int count = 60) {
    std::vector<Sample> all;
    for (int i = 0; i < count; ++i) {
        shell::Holdings held = some();
        held.heap += static_cast<std::uint64_t>(i % 7) * 1'000'000;
        held.textures += static_cast<std::uint64_t>(i % 5);
        held.*kind += static_cast<std::uint64_t>(i) * step;
        all.push_back({i % 2 == 0 ? "a" : "b", held});
    }
    return all;
}

TEST(Growth, OfWhatComesAndGoesThereIsNone) {
    EXPECT_TRUE(growth(samples(&shell::Holdings::heap, 0)).empty());
}

TEST(Growth, IsFoundOfEveryKindAndInEveryState) {
    const auto lines = [](std::uint64_t shell::Holdings::*kind, std::uint64_t step) {
        return growth(samples(kind, step)).size();
    };
    EXPECT_EQ(lines(&shell::Holdings::heap, 8'000'000), 2u);
    EXPECT_EQ(lines(&shell::Holdings::resident, 14'000'000), 2u);
    EXPECT_EQ(lines(&shell::Holdings::gpu, 200'000), 2u);
    for (const auto kind : {&shell::Holdings::textures, &shell::Holdings::buffers,
                            &shell::Holdings::framebuffers, &shell::Holdings::queries,
                            &shell::Holdings::programs, &shell::Holdings::files, &shell::Holdings::threads}) {
        EXPECT_EQ(lines(kind, 1), 2u);
    }
    EXPECT_EQ(growth(samples(&shell::Holdings::files, 1)).front(), "a: files 32 -> 56");
}

TEST(Growth, OfAFewSamplesNothingIsSaid) {
    EXPECT_TRUE(growth(samples(&shell::Holdings::files, 1, 12)).empty());
}

}  // namespace
}  // namespace lanthorn::game

#include "tests/bench/game/level_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "game/level/campaign.h"
#include "lanthorn/core/error.h"
#include "lanthorn/gpu/context.h"

namespace lanthorn::game {

int LevelBench::run(int argc, char** argv,
                    const std::function<void(const std::vector<std::string>& words,
                                             const std::vector<std::string>& levels)>& measure) const {
    const std::vector<std::string> given(argv + 1, argv + argc);
    const auto needed = 1 + std::ranges::count(words, ' ');
    try {
        if (std::ssize(given) < needed) {
            throw InputError(fmt::format("expected {} [LEVEL...]", words));
        }
        std::vector<std::string> levels(given.begin() + needed, given.end());
        if (levels.empty()) {
            levels.assign(campaign().begin(), campaign().end());
        }
        const auto context = gpu::create_headless_context();
        measure({given.begin(), given.begin() + needed}, levels);
        return 0;
    } catch (const std::exception& e) {
        fmt::print(stderr, "{}: {}\n", name, e.what());
        return 2;
    }
}

int LevelBench::number(const std::string& word, int least) const {
    const int value = std::atoi(word.c_str());
    if (value < least) {
        throw InputError(
            fmt::format("found '{}', expected {} with numbers of at least {}", word, words, least));
    }
    return value;
}

}  // namespace lanthorn::game

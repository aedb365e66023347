// Every level of the campaign is solved by its recorded session: every state as recorded, on any number of
// threads, and all crystals awake at its end.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>

#include "game/level/campaign.h"
#include "game/presentation/playthrough.h"
#include "lanthorn/assets/gltf_import.h"
#include "tests/support/repository.h"

namespace lanthorn::game {
namespace {

using Case = std::tuple<std::string_view, int>;  // level, threads

class Level : public testing::TestWithParam<Case> {};

TEST_P(Level, IsSolvedByItsRecording) {
    const auto& [stem, threads] = GetParam();
    Options options;
    options.headless = true;
    options.level = support::repository_file("assets/levels/" + std::string(stem) + ".glb");
    options.replay = support::repository_file("tests/replay/" + std::string(stem) + ".rec");
    options.threads = threads;
    Playthrough playthrough(options, import_gltf(options.level));
    session::Session& session = playthrough.session();
    const ecs::World& world = session.app().world();
    std::uint64_t solved_at = 0;  // step
    while (!session.done()) {
        session.app().step();
        if (solved_at == 0 && solved(world)) {
            solved_at = session.steps();
        }
    }
    EXPECT_EQ(session.divergence(), "");
    EXPECT_TRUE(solved(world));
    EXPECT_GT(solved_at, *session.length() / 3);
}

std::string name_of(const testing::TestParamInfo<Case>& info) {
    std::string name = std::string(std::get<0>(info.param)) + "_" + std::to_string(std::get<1>(info.param));
    std::ranges::replace(name, '-', '_');
    return name;
}
INSTANTIATE_TEST_SUITE_P(Campaign, Level,
                         testing::Combine(testing::ValuesIn(campaign().begin(), campaign().end()),
                                          testing::Values(1, 2)),
                         name_of);

}  // namespace
}  // namespace lanthorn::game

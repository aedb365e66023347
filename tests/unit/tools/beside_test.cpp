// What a recording led to beside what it was expected to lead to, in the editor.
#include "tools/lanthorn/edit/beside.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "lanthorn/core/error.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/ecs/snapshot.h"
#include "lanthorn/scene/components.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/refused.h"
#include "tools/lanthorn/replay/replayed_level.h"

namespace lanthorn::tools {
namespace {

constexpr std::uint64_t kStep = 40;

class Beside : public testing::Test {
  protected:
    // The recording, with a state of step kStep in which the green pane stands half a metre higher.
    Beside() {
        auto recording = std::make_shared<replay::Recording>(
            replay::read_recording(support::repository_file("tests/replay/pool.rec")));
        recording->annotations.states.clear();
        replay::write_recording(folder_.path("bare.rec"), *recording);
        const auto read = read_level("pool.rec", recording->header, level_);
        ReplayedLevel replayed(*read, "pool.rec", recording);
        while (replayed.session().steps() < kStep) {
            replayed.app().step();
        }
        ecs::World& world = replayed.app().world();
        world.query<ecs::Read<Name>, ecs::Write<LocalTransform>>().each(
            [](const Name& name, LocalTransform& place) {
                if (name.value == "green-pane") {
                    place.value.translation.y += 0.5;
                }
            });
        recording->annotations.states = {
            {kStep, ecs::Snapshot::save(world, replayed.app().registry()).to_bytes()}};
        replay::write_recording(folder_.path("pool.rec"), *recording);
    }
    std::string at(const char* file, std::uint64_t step) const {
        return folder_.path(file) + ":" + std::to_string(step);
    }
    std::string refusal(const std::string& place, const std::string& against = "") const {
        try {
            beside(level_, place, against);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }

    const std::string level_ = support::repository_file("assets/levels/pool.glb");
    const testing_tools::TemporaryFolder folder_;
};

TEST_F(Beside, NamesTheFieldWithBothValuesAndItsNode) {
    const edit_window::BesideShown shown = beside(level_, at("pool.rec", kStep), "");
    EXPECT_EQ(shown.title, "after step 40 of pool.rec");
    ASSERT_FALSE(shown.rows.empty());
    EXPECT_FALSE(shown.more);
    const auto row = std::ranges::find_if(shown.rows, [](const edit_window::BesideRow& r) {
        return r.name.find("local_transform.value.translation.y") != std::string::npos;
    });
    ASSERT_NE(row, shown.rows.end());
    EXPECT_EQ(row->name.substr(0, 12), "green-pane (");
    EXPECT_NE(row->node, kNone);
    EXPECT_NEAR(std::stod(row->expected) - std::stod(row->found), 0.5, 1e-12);
    const std::string text = beside_text(shown);
    EXPECT_EQ(text.substr(0, 36), "beside    after step 40 of pool.rec:");
    EXPECT_NE(text.find("expected " + row->expected), std::string::npos);
}

TEST_F(Beside, OfWhatIsAsItWasHasNoRows) {
    // Equal to what another play of this very build comes to.
    const edit_window::BesideShown shown = beside(level_, at("bare.rec", kStep), LANTHORN_BINARY);
    EXPECT_TRUE(shown.rows.empty());
    EXPECT_TRUE(shown.to_expected.empty());
    EXPECT_FALSE(shown.empty());
}

TEST_F(Beside, SaysWhichStatesThereAre) {
    EXPECT_NE(
        refusal(at("pool.rec", 41)).find("found states of steps 40, expected one of step 41; or --against"),
        std::string::npos);
    EXPECT_NE(refusal(at("bare.rec", kStep)).find("found no states, expected one of step 40"),
              std::string::npos);
    EXPECT_NE(refusal(at("pool.rec", 1'000'000)).find("expected at least 1000000"), std::string::npos);
    EXPECT_NE(refusal("pool.rec").find("expected FILE:STEP"), std::string::npos);
    EXPECT_NE(refusal(at("bare.rec", 0), LANTHORN_BINARY).find("found step 0"), std::string::npos);
    EXPECT_NE(refusal(at("bare.rec", kStep), "/bin/false"), "");
}

TEST_F(Beside, WantsAPlaceToBeBeside) {
    using testing_tools::run_program;
    testing_tools::expect_refusal(run_program(LANTHORN_BINARY, {"edit", level_, "--beside"}),
                                  "--beside: found no --at");
    testing_tools::expect_refusal(
        run_program(LANTHORN_BINARY, {"edit", level_, "--at", at("pool.rec", kStep), "--against", "x"}),
        "--against: expected --beside");
}

}  // namespace
}  // namespace lanthorn::tools

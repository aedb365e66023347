// Frames of a real scene that keep a budget, and the same decisions played back.
#include <gtest/gtest.h>

#include "lanthorn/workbench/all_settings.h"
#include "lanthorn/workbench/render_job.h"
#include "tests/support/repository.h"

namespace lanthorn::workbench {
namespace budget_run_test {

RenderOutcome render(const BudgetWish& wish, int frames,
                     std::vector<render::Aov> aovs = {render::Aov::final}) {
    SettingsSchema schema;
    declare_all_settings(schema);
    Settings settings(schema);
    settings.set_from_text("gi.emc.rays=bvh");
    RenderJob job;
    job.size = {64, 64};
    job.view.time = 0;
    job.frames = frames;
    job.aovs = std::move(aovs);
    job.timing = true;
    job.budget = wish;
    return render_scene(load_scene(support::repository_file("assets/cornell.glb"), job.view), settings, job,
                        [](int) {});
}

// No frame takes a microsecond: whatever the machine, all is spared at once.
TEST(BudgetRun, WhatNothingKeepsIsSaidAndSparesAll) {
    const RenderOutcome outcome = render({.ms = 0.001, .error = 0, .processor = true, .played = {}}, 20);
    ASSERT_EQ(outcome.budget.steps.size(), 1u);
    EXPECT_EQ(outcome.budget.steps.front().to, outcome.budget.ladder.size() - 1);
    EXPECT_FALSE(outcome.budget.holds);
    EXPECT_LT(outcome.budget.steps.front().scale, 1);
    EXPECT_EQ(outcome.images.front().width, 64);
}

TEST(BudgetRun, PartsOfThePictureKeepTheirPixels) {
    const RenderOutcome outcome =
        render({.ms = 0.001, .error = 0, .processor = true, .played = {}}, 20, {render::Aov::indirect});
    ASSERT_EQ(outcome.budget.steps.size(), 1u);
    EXPECT_EQ(outcome.budget.steps.front().scale, 1);
    EXPECT_EQ(outcome.images.front().width, 64);
}

TEST(BudgetRun, AnHourSparesNothing) {
    const RenderOutcome outcome = render({.ms = 3.6e6, .error = 0, .processor = false, .played = {}}, 14);
    EXPECT_TRUE(outcome.budget.steps.empty());
    EXPECT_TRUE(outcome.budget.holds);
}

TEST(BudgetRun, DecisionsThatArePlayedBackGiveTheSameBits) {
    const BudgetWish wish{.ms = 0, .error = 0, .processor = false, .played = {{3, 2}, {9, 5}}};
    const RenderOutcome first = render(wish, 14), second = render(wish, 14);
    ASSERT_EQ(first.budget.steps.size(), 2u);
    EXPECT_EQ(first.budget.steps[1].frame, 9);
    EXPECT_EQ(first.budget.steps[1].to, 5u);
    EXPECT_EQ(first.images.front().pixels, second.images.front().pixels);
    EXPECT_THROW(render({.ms = 0, .error = 0, .processor = false, .played = {{3, 2000}}}, 4), Error);
}

TEST(BudgetRun, AnErrorThatSufficesIsSaid) {
    const RenderOutcome outcome = render({.ms = 0, .error = 10, .processor = false, .played = {}}, 24);
    EXPECT_TRUE(outcome.budget.holds);
    // When it is decided that less suffices, the clock says.
    EXPECT_TRUE(outcome.budget.verdict.ends_with(" reached") ||
                outcome.budget.verdict.ends_with(" before the last change"))
        << outcome.budget.verdict;
}

}  // namespace budget_run_test
}  // namespace lanthorn::workbench

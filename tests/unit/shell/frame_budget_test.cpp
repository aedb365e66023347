// Frames of machines that are not there: what they take follows from what is drawn, some noise and the scene.
#include "lanthorn/shell/frame_budget.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "tests/support/median.h"

namespace lanthorn::shell {
namespace {

struct Machine {
    double whole = 100;  // ms of a frame at preset medium and full size
    double fixed = 0.3;  // the share that does not shrink with the picture
    double screen = 0;   // ms between two pictures of the screen, that frames wait for; 0: none

    double frame(const Spending& spending) const {
        const double preset = spending.preset == "low" ? 0.55 : spending.preset == "high" ? 1.8 : 1;
        return whole * preset * (fixed + (1 - fixed) * spending.scale * spending.scale);
    }
};

class Running {
  public:
    Running(double budget, const Machine& machine, const std::string& best = "medium")
        : budget_(budget), machine_(machine) {
        game_.set(budget, best);
    }

    // `load`: of the scene, by the second.
    void seconds(
        double count, const std::function<double(double)>& load = [](double) { return 1.0; }) {
        for (const double end = now_ + 1000 * count; now_ < end;) {
            const double noise = 0.9 + 0.2 * static_cast<double>(random_()) / 2147483647.0;
            double busy = machine_.frame(game_.spending()) * load(now_ / 1000) * noise;
            if (random_() % 30 == 0) {
                busy *= 3;  // something was loaded
            }
            const double ms =
                machine_.screen > 0 ? machine_.screen * std::ceil(busy / machine_.screen) : busy;
            game_.frame(ms, busy);
            now_ += ms;
            frames_.push_back(ms);
        }
    }
    void forget() { frames_.clear(); }
    double median() const { return support::median(frames_); }
    double share_within() const {
        return static_cast<double>(std::ranges::count_if(
                   frames_, [&](double ms) { return ms <= FrameBudget::kTolerance * budget_; })) /
               static_cast<double>(frames_.size());
    }
    FrameBudget& game() { return game_; }

  private:
    double budget_;
    Machine machine_;
    FrameBudget game_;
    std::minstd_rand random_{3};
    double now_ = 0;  // ms
    std::vector<double> frames_;
};

TEST(FrameBudget, IsKeptByMachinesOfAnyKind) {
    for (const double fixed : {0.05, 0.3, 0.6}) {
        for (const double whole : {20.0, 60.0, 100.0, 130.0}) {
            Running run(50, {whole, fixed});
            run.seconds(8);  // that it may take
            run.forget();
            const int before = run.game().changes();
            run.seconds(60);
            EXPECT_LE(run.median(), 50) << whole << ' ' << fixed;
            EXPECT_GT(run.share_within(), 0.9) << whole << ' ' << fixed;
            EXPECT_LE(run.game().changes() - before, 3) << whole << ' ' << fixed;
        }
    }
}

TEST(FrameBudget, NothingIsSparedWhereThereIsTime) {
    Running run(50, {40, 0.3});
    run.seconds(60);
    EXPECT_EQ(run.game().spending(), (Spending{"medium", 1}));
    EXPECT_EQ(run.game().changes(), 0);
    Running any(0, {4000, 0.3});
    any.seconds(600);
    EXPECT_EQ(any.game().changes(), 0);
}

TEST(FrameBudget, NoMoreIsSparedThanHasToBe) {
    Running run(50, {100, 0.3});
    run.seconds(60);
    EXPECT_GT(run.median(), 0.6 * 50);
}

TEST(FrameBudget, WhatWasSparedComesBackWhenThereIsTimeAgain) {
    Running run(50, {60, 0.3});
    run.seconds(30, [](double) { return 1.6; });
    EXPECT_LT(run.game().spending().scale, 1);
    run.seconds(60, [](double) { return 0.5; });
    EXPECT_EQ(run.game().spending(), (Spending{"medium", 1}));
}

// She walks with the lantern, stands, walks: each time for four seconds.
TEST(FrameBudget, ALoadThatComesAndGoesDoesNotMakeItGoUpAndDownForEver) {
    Running run(50, {70, 0.3});
    const auto load = [](double seconds) { return std::fmod(seconds, 8) < 4 ? 1.0 : 0.45; };
    run.seconds(60, load);
    const int first = run.game().changes();
    run.forget();
    run.seconds(240, load);
    EXPECT_LE(run.game().changes() - first, 16);
    EXPECT_GT(run.share_within(), 0.85);
}

// The screen makes 16.8 ms of any shorter frame: only the work tells that there is time left.
TEST(FrameBudget, AScreensBeatIsNoLoad) {
    Running run(16.7, {8, 0.3, 16.8});
    run.seconds(30, [](double seconds) { return seconds < 10 ? 4.0 : 1.0; });
    EXPECT_EQ(run.game().spending(), (Spending{"medium", 1}));
    EXPECT_GT(run.game().changes(), 0);
}

// 20 ms a picture are more than the budget, but nothing that is drawn makes them so.
TEST(FrameBudget, AScreenSlowerThanTheBudgetIsNoLoad) {
    Running run(16.7, {8, 0.3, 20});
    run.seconds(60);
    EXPECT_EQ(run.game().spending(), (Spending{"medium", 1}));
    EXPECT_EQ(run.game().changes(), 0);
}

// A second a frame is not to be borne for nine of them.
TEST(FrameBudget, ASlowMachineIsSparedSoon) {
    Running run(50, {1000, 0.3});
    run.seconds(9);
    EXPECT_GT(run.game().changes(), 0);
}

TEST(FrameBudget, WhereNothingSufficesTheLeastIsDrawn) {
    Running run(16.7, {5000, 0.5}, "ultra");
    run.seconds(600);
    EXPECT_EQ(run.game().spending().preset, "low");
    EXPECT_LT(run.game().spending().scale, 0.4);
    const int changes = run.game().changes();
    run.seconds(600);
    EXPECT_EQ(run.game().changes(), changes);
}

TEST(FrameBudget, AnotherPresetBeginsAnew) {
    Running run(50, {400, 0.3}, "high");
    run.seconds(20);
    EXPECT_NE(run.game().spending().preset, "high");
    run.game().set(50, "medium");
    EXPECT_EQ(run.game().spending(), (Spending{"medium", 1}));
    run.game().set(0, "medium");
    EXPECT_EQ(run.game().spending(), (Spending{"medium", 1}));
}

}  // namespace
}  // namespace lanthorn::shell

// Machines that are not there: what a frame takes follows from the rung that is drawn, the scene and some
// noise.
#include "lanthorn/runtime/budget_control.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "engine/runtime/budget_ladders.h"

namespace lanthorn {
namespace budget_control_test {

// Three groups: light, pixels, the rest.
BudgetLadder ladder() {
    BudgetLadder result;
    result.shares = {0.5, 0.4, 0.1};
    result.rungs = {{.name = "all", .preset = {}, .set = {}, .scale = 1, .cost = {1, 1, 1}, .error = 1}};
    for (int i = 1; i <= 8; ++i) {
        BudgetRung rung = result.rungs.back();
        rung.name = "light " + std::to_string(i);
        rung.cost[0] *= 0.75;
        rung.error *= 1.12;
        result.rungs.push_back(rung);
    }
    add_smaller_pictures(result, 1);
    return result;
}

// Milliseconds of each group at the first rung.
using Scene = std::function<std::vector<double>(int frame)>;

struct Ran {
    std::vector<double> ms;
    std::vector<std::size_t> rungs;

    double share_below(double bound, std::size_t from = 0) const {
        return static_cast<double>(std::count_if(ms.begin() + static_cast<std::ptrdiff_t>(from), ms.end(),
                                                 [&](double m) { return m <= bound; })) /
               static_cast<double>(ms.size() - from);
    }
    double mean(std::size_t from = 0) const {
        double sum = 0;
        for (std::size_t i = from; i < ms.size(); ++i) {
            sum += ms[i];
        }
        return sum / static_cast<double>(ms.size() - from);
    }
};

struct Machine {
    Scene scene;
    bool knows_groups = true;
    double error = 0;           // of the first rung; 0: none is known
    double after_change = 1.8;  // of the first frame after one: histories are made again
};

Ran run(BudgetControl& control, const Machine& machine, int frames, std::uint32_t seed = 7) {
    std::minstd_rand random(seed);
    Ran ran;
    std::int64_t changes = control.changes();
    for (int i = 0; i < frames; ++i) {
        const double noise = 0.95 + 0.1 * static_cast<double>(random()) / 2147483647.0;
        const BudgetRung& rung = control.rung();
        const bool changed = control.changes() != changes;
        changes = control.changes();
        BudgetControl::Frame frame;
        for (std::size_t g = 0; g < rung.cost.size(); ++g) {
            frame.groups.push_back(machine.scene(i)[g] * rung.cost[g] * noise *
                                   (changed ? machine.after_change : 1));
            frame.ms += frame.groups.back();
        }
        frame.busy_ms = frame.ms;
        if (!machine.knows_groups) {
            frame.groups.clear();
        }
        if (machine.error > 0 && i % 4 == 0) {
            frame.error = machine.error * rung.error * noise;
        }
        ran.ms.push_back(frame.ms);
        ran.rungs.push_back(control.at());
        control.frame(frame);
    }
    return ran;
}

Scene steady(double ms) {
    return [ms](int) { return std::vector{0.5 * ms, 0.4 * ms, 0.1 * ms}; };
}

TEST(BudgetControl, AStressKeepsTheBudgetAndUsesIt) {
    // Lamps go on (frames 300 to 900: light three times), a hundred figures enter (600 to 1200: 20 ms more of
    // what nothing spares), another program takes a core (900 to 1500: all of it 1.6 times).
    const Scene scene = [](int frame) {
        const double light = frame >= 300 && frame < 900 ? 3 : 1;
        const double figures = frame >= 600 && frame < 1200 ? 20 : 0;
        const double core = frame >= 900 && frame < 1500 ? 1.6 : 1;
        return std::vector{core * 60 * light, core * 40, core * (10 + figures)};
    };
    for (const bool groups : {true, false}) {
        BudgetControl control;
        control.set({.ms = 100, .error = 0}, ladder());
        const Ran ran = run(control, {.scene = scene, .knows_groups = groups}, 1800);
        EXPECT_GE(ran.share_below(110), 0.95) << groups;
        // Where no pass is timed, what is spared is gone about by the ladder's shares.
        EXPECT_GE(ran.mean(), groups ? 85 : 75);
        EXPECT_LE(control.changes(), 24) << groups;
    }
}

// Three late frames are a scene that is another: they alone say what the next ones take. Two are a burst.
TEST(BudgetControl, AnswersASuddenChangeByItsOwnFrames) {
    constexpr int kBefore = 200;
    BudgetControl control;
    control.set({.ms = 100, .error = 0}, ladder());
    // From pixels alone to light alone.
    const Scene scene = [](int frame) {
        return frame < kBefore ? std::vector{4.0, 60.0, 10.0} : std::vector{150.0, 20.0, 10.0};
    };
    const Ran ran = run(control, {scene}, kBefore + 100);
    EXPECT_EQ(control.changes(), 1) << "one decision finds the rung";
    EXPECT_EQ(control.decisions().front().frame, kBefore + 2);
    EXPECT_GE(ran.share_below(110, kBefore + 4), 0.99);

    BudgetControl patient;
    patient.set({.ms = 100, .error = 0}, ladder());
    run(patient, {[](int frame) { return steady(frame % 20 < 2 ? 200 : 70)(frame); }}, 400);
    EXPECT_EQ(patient.changes(), 0);
}

TEST(BudgetControl, DoesNotGoUpAndDownWhereNothingChanges) {
    for (double ms = 60; ms < 800; ms *= 1.07) {
        BudgetControl control;
        control.set({.ms = 100, .error = 0}, ladder());
        run(control, {steady(ms)}, 300);
        const std::int64_t before = control.changes();
        run(control, {steady(ms)}, 2000, 11);
        EXPECT_LE(control.changes() - before, 2) << ms;
    }
}

TEST(BudgetControl, SparesLightBeforePixelsAndRecovers) {
    BudgetControl control;
    control.set({.ms = 100, .error = 0}, ladder());
    run(control, {steady(130)}, 100);
    EXPECT_GT(control.at(), 0u);
    EXPECT_EQ(control.rung().scale, 1);
    run(control, {steady(300)}, 100);
    EXPECT_LT(control.rung().scale, 1);
    run(control, {steady(60)}, 400);
    EXPECT_EQ(control.at(), 0u);
    EXPECT_TRUE(control.holds());
}

TEST(BudgetControl, TimeOfPassesTellsHowFarToGo) {
    // All of it is pixels: no light needs to be tried first, one step finds the picture's size.
    BudgetControl control;
    control.set({.ms = 100, .error = 0}, ladder());
    run(control, {[](int) { return std::vector{4.0, 150.0, 6.0}; }}, 60);
    EXPECT_EQ(control.changes(), 1);
    EXPECT_LT(control.rung().scale, 1);
}

TEST(BudgetControl, AnErrorThatSufficesSparesTime) {
    BudgetControl control;
    control.set({.ms = 0, .error = 0.1}, ladder());
    const Ran ran = run(control, {.scene = steady(80), .knows_groups = true, .error = 0.05}, 600);
    EXPECT_GT(control.at(), 2u);
    EXPECT_LE(0.05 * control.rung().error, 0.1);
    EXPECT_LT(ran.ms.back(), 60);
    EXPECT_NE(control.verdict().find("reached"), std::string::npos);
}

// A still picture gets there by itself: another rung would begin it again.
TEST(BudgetControl, WaitsForAPictureThatIsRefined) {
    const auto changes = [](bool refines) {
        BudgetControl control;
        control.set({.ms = 0, .error = 0.1}, ladder());
        run(control, {.scene = steady(80), .knows_groups = true, .error = 0.05}, 600);
        const std::int64_t before = control.changes();
        EXPECT_GT(control.at(), 0u);
        for (int i = 0; i < 600; ++i) {
            control.frame({.ms = 80, .busy_ms = 80, .groups = {}, .error = 0.2, .refines = refines});
        }
        EXPECT_FALSE(control.holds());
        return control.changes() - before;
    };
    EXPECT_EQ(changes(true), 0);
    EXPECT_GT(changes(false), 0);
}

TEST(BudgetControl, TimeComesBeforeAnErrorAndTheErrorIsSaid) {
    BudgetControl control;
    control.set({.ms = 50, .error = 0.02}, ladder());
    const Ran ran = run(control, {.scene = steady(100), .knows_groups = true, .error = 0.05}, 1000);
    EXPECT_GE(ran.share_below(55, 50), 0.95);
    EXPECT_NE(control.verdict().find("time comes first"), std::string::npos) << control.verdict();
    EXPECT_FALSE(control.holds());
}

// Where time leaves nothing but pixels to gain, an error out of reach does not raise them again and again.
TEST(BudgetControl, AnErrorOutOfReachDoesNotRaisePixels) {
    BudgetControl control;
    control.set({.ms = 30, .error = 0.001}, ladder());
    run(control, {.scene = steady(120), .knows_groups = true, .error = 0.05}, 2000);
    EXPECT_LT(control.rung().scale, 1) << "light alone was spared";
    EXPECT_LE(control.changes(), 3);
    for (const BudgetControl::Decision& decision : control.decisions()) {
        EXPECT_FALSE(decision.to < decision.from && decision.why.starts_with("error")) << decision.why;
    }
}

TEST(BudgetControl, AnErrorThatNothingReachesIsSaid) {
    BudgetControl control;
    control.set({.ms = 0, .error = 0.001}, ladder());
    run(control, {.scene = steady(100), .knows_groups = true, .error = 0.05}, 300);
    EXPECT_EQ(control.at(), 0u);
    EXPECT_NE(control.verdict().find("all that can be spent"), std::string::npos) << control.verdict();
}

TEST(BudgetControl, AnUnlitSceneHasNoErrorToReach) {
    BudgetControl control;
    control.set({.ms = 100, .error = 0.05}, ladder());
    run(control, {steady(40)}, 300);
    EXPECT_EQ(control.changes(), 0);
    EXPECT_NE(control.verdict().find("none is known"), std::string::npos) << control.verdict();
    EXPECT_TRUE(control.holds());
}

TEST(BudgetControl, ABudgetThatNothingKeepsDrawsTheLeast) {
    BudgetControl control;
    control.set({.ms = 0.001, .error = 0}, ladder());
    run(control, {steady(100)}, 600);
    EXPECT_EQ(control.at(), control.ladder().rungs.size() - 1);
    EXPECT_EQ(control.changes(), 1);
    EXPECT_FALSE(control.holds());
    EXPECT_NE(control.verdict().find("nothing more can be spared"), std::string::npos);
}

TEST(BudgetControl, AnHourOrNoBudgetSparesNothing) {
    for (const double ms : {3.6e6, 0.0, -5.0, std::numeric_limits<double>::quiet_NaN()}) {
        BudgetControl control;
        control.set({.ms = ms, .error = 0}, ladder());
        run(control, {steady(4000)}, 100);
        EXPECT_EQ(control.changes(), 0) << ms;
        EXPECT_TRUE(control.holds()) << ms;
    }
}

TEST(BudgetControl, AClockThatJumpsAndAMachineThatStopsTellNothing) {
    BudgetControl control;
    control.set({.ms = 100, .error = 0}, ladder());
    run(control, {steady(90)}, 50);
    control.frame({.ms = -3000, .busy_ms = -3000, .groups = {}, .error = std::nullopt});
    control.frame({.ms = std::numeric_limits<double>::infinity(), .busy_ms = 80, .groups = {}, .error = {}});
    control.frame({.ms = 5000, .busy_ms = 5000, .groups = {}, .error = std::nullopt});
    run(control, {steady(90)}, 200);
    EXPECT_EQ(control.changes(), 0);
}

TEST(BudgetControl, DecisionsAreTheSameEachTime) {
    const auto decided = [] {
        BudgetControl control;
        control.set({.ms = 100, .error = 0}, ladder());
        run(control, {[](int frame) { return steady(frame % 400 < 200 ? 150 : 90)(frame); }}, 1200);
        std::vector<std::pair<std::int64_t, std::size_t>> list;
        for (const BudgetControl::Decision& decision : control.decisions()) {
            list.emplace_back(decision.frame, decision.to);
            EXPECT_FALSE(decision.why.empty());
        }
        return list;
    };
    EXPECT_FALSE(decided().empty());
    EXPECT_EQ(decided(), decided());
}

TEST(BudgetControl, RefusesLaddersThatAreNone) {
    BudgetControl control;
    EXPECT_THROW(control.set({}, {.rungs = {}, .shares = {1}}), std::invalid_argument);
    EXPECT_THROW(control.set({}, {.rungs = {{}}, .shares = {0.5, 0.5}}), std::invalid_argument);
}

}  // namespace budget_control_test
}  // namespace lanthorn

// Light wishes: lamps whose light is known on paper, and as a script makes them.
#include "tools/editor/core/light_wishes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "lanthorn/core/error.h"
#include "lanthorn/gi/gi_plugin.h"
#include "tests/support/scenes.h"
#include "tests/support/shapes.h"
#include "tools/editor/core/edit_script.h"
#include "tools/editor/core/non_negative.h"

namespace lanthorn::editor {
namespace {

double missed(std::span<const Equation> equations, const std::vector<double>& x) {
    double sum = 0;
    for (const Equation& e : equations) {
        double off = -e.sum;
        for (std::size_t i = 0; i < x.size(); ++i) {
            off += e.factors[i] * x[i];
        }
        sum += off * off;
    }
    return sum;
}

TEST(NonNegative, IsTheSolutionWhereThatIsNotBelow0) {
    const std::vector<Equation> equations{{{2, 1}, 7}, {{1, 3}, 11}};
    const std::vector<double> x = non_negative_solution(equations);
    EXPECT_NEAR(x[0], 2, 1e-12);
    EXPECT_NEAR(x[1], 3, 1e-12);
}

// The least of all there is, by the conditions of Karush, Kuhn and Tucker: a step of any unknown that it may
// take misses more.
TEST(NonNegative, NothingNearMissesLess) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1, 1), part(0, 1);
    int at_zero = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const std::size_t unknowns = 1 + static_cast<std::size_t>(trial % 8);
        std::vector<Equation> equations;
        for (int row = 0; row < 12; ++row) {
            Equation e{{}, any(random)};
            for (std::size_t i = 0; i < unknowns; ++i) {
                e.factors.push_back(part(random));
            }
            equations.push_back(e);
        }
        const std::vector<double> x = non_negative_solution(equations);
        const double least = missed(equations, x);
        for (std::size_t i = 0; i < unknowns; ++i) {
            EXPECT_GE(x[i], 0);
            at_zero += x[i] == 0 ? 1 : 0;
            for (const double step : {1e-4, -1e-4}) {
                std::vector<double> other = x;
                other[i] = std::max(0.0, other[i] + step);
                EXPECT_GE(missed(equations, other), least - 1e-12);
            }
        }
    }
    EXPECT_GT(at_zero, 100);
}

// A black floor with lamps 2 m above it, at x = -2 and x = 2.
constexpr double kHeight = 2, kAway = 2;

double given(double distance) {  // lux of 1 cd
    return kHeight / std::pow(kHeight * kHeight + distance * distance, 1.5);
}

PlacedWish wish_at(float x, const std::string& lux) {
    PlacedWish wish;
    wish.wish = wish_of(std::to_string(x) + ",0,0,0,1,0", lux);
    wish.place.sensor = true;
    wish.place.position = {x, 0, 0};
    wish.place.direction = {0, 1, 0};
    wish.place.radius = 1e-4f;
    wish.place.filter = vec3(0.2126f, 0.7152f, 0.0722f);
    return wish;
}

WishTask two_lamps(double left, double right) {
    WishTask task;
    task.frame = support::scene_of({support::quad({-20, 0, 20}, {40, 0, 0}, {0, 0, -40}, 0)},
                                   {support::lambertian(vec3(0))},
                                   {support::point_light({-2, 2, 0}, static_cast<float>(left)),
                                    support::point_light({2, 2, 0}, static_cast<float>(right))},
                                   vec3(0, 1, 3), vec3(0));
    task.lamps = {{0, "/left", {0}, left}, {1, "/right", {1}, right}};
    return task;
}

constexpr WishEffort kFew{4, 16};

TEST(LightWishes, OfTwoPlacesAndTwoLampsAreSolvedExactly) {
    WishTask task = two_lamps(10, 0);  // the second one is dark
    task.wishes = {wish_at(-2, "100"), wish_at(1, "60lx")};
    const WishSolution solution = solve_wishes(task, kFew);
    const double a = given(0), b = given(2 * kAway), c = given(3), d = given(1);
    const double det = a * d - b * c;
    EXPECT_NEAR(solution.intensities[0], (100 * d - 60 * b) / det, 1e-3 * solution.intensities[0]);
    EXPECT_NEAR(solution.intensities[1], (60 * a - 100 * c) / det, 1e-3 * solution.intensities[1]);
    EXPECT_TRUE(solution.all_met());
    EXPECT_LT(solution.residual, 1e-3);
    EXPECT_NEAR(solution.outcomes[0].before, 10 * a, 1e-3 * a * 10);
    EXPECT_NEAR(solution.outcomes[0].reached, 100, 0.1);
    EXPECT_EQ(solution.commands().size(), 2u);
}

// 100 lx below one lamp and 1 lx a metre beside it: no lamp can be dark enough. The second stays dark, and
// the first gives what misses both least, each by its share of what it asks.
TEST(LightWishes, ThatCannotBeAreMissedByTheLeast) {
    WishTask task = two_lamps(10, 10);
    task.wishes = {wish_at(-2, "100"), wish_at(-1, "1")};
    const WishSolution solution = solve_wishes(task, kFew);
    const double a = given(0) / 100, c = given(1) / 1;
    const double left = (a + c) / (a * a + c * c);
    EXPECT_NEAR(solution.intensities[0], left, 1e-3 * left);
    EXPECT_EQ(solution.intensities[1], 0);
    const double off = std::sqrt(0.5 * (std::pow(a * left - 1, 2) + std::pow(c * left - 1, 2)));
    EXPECT_NEAR(solution.residual, off, 1e-3 * off);
    EXPECT_FALSE(solution.all_met());
    EXPECT_NE(outcome_words(solution.outcomes[0]).find("missed by"), std::string::npos);
    EXPECT_NE(solution_words(solution).find("of 2 wishes met"), std::string::npos);
}

TEST(LightWishes, ForAtMostAndAtLeastLeaveLampsThatDoAsTheyAre) {
    WishTask task = two_lamps(100, 40);
    const double here = 100 * given(0) + 40 * given(2 * kAway);
    task.wishes = {wish_at(-2, "<=" + std::to_string(1.2 * here)), wish_at(2, ">=2")};
    EXPECT_TRUE(solve_wishes(task, kFew).commands().empty());
    task.wishes = {wish_at(-2, "<=" + std::to_string(0.5 * here)), wish_at(2, ">=2")};
    const WishSolution solution = solve_wishes(task, kFew);
    EXPECT_NEAR(solution.outcomes[0].reached, 0.5 * here, 1e-3 * here);
    EXPECT_GE(solution.outcomes[1].reached, 2);
    EXPECT_TRUE(solution.all_met());
}

// Of what two lamps can do together each does what it did, as nearly as can be.
TEST(LightWishes, LeaveWhatTheyDoNotDecideAsItIs) {
    WishTask task = two_lamps(50, 50);
    task.wishes = {wish_at(0, "30")};
    const WishSolution solution = solve_wishes(task, kFew);
    EXPECT_NEAR(solution.intensities[0], 15 / given(2), 1e-3 * solution.intensities[0]);
    EXPECT_NEAR(solution.intensities[1], solution.intensities[0], 1e-4 * solution.intensities[0]);
}

TEST(LightWishes, SayWhereNoLampReaches) {
    WishTask task = two_lamps(50, 50);
    PlacedWish below = wish_at(0, "30");
    below.place.direction = {0, -1, 0};
    task.wishes = {below};
    const WishSolution solution = solve_wishes(task, kFew);
    EXPECT_NE(outcome_words(solution.outcomes[0]).find("no lamp lights it"), std::string::npos);
    EXPECT_TRUE(solution.commands().empty());
}

TEST(LightWishes, AreReadFromWords) {
    EXPECT_EQ(wish_of("/study", "<=5lx").asks, Asks::at_most);
    EXPECT_EQ(wish_of("1,2,3,0,0,2", ">=7").normal, vec3(0, 0, 1));
    EXPECT_EQ(wish_of("1,2,3", "7", "0.5").radius, 0.5);
    EXPECT_EQ(asked_words(wish_of("/study", "<=5lx")), "<=5 lx");
    for (const auto& [where, lux, radius] : {std::array<std::string, 3>{"1,2", "7", ""},
                                             {"1,2,x", "7", ""},
                                             {"1,2,3", "bright", ""},
                                             {"1,2,3", "-7", ""},
                                             {"1,2,3,0,0,0", "7", ""},
                                             {"1,2,3", "7", "0"},
                                             {"/study", "7", "1"},
                                             {"1,2,3", "nan", ""}}) {
        EXPECT_THROW(wish_of(where, lux, radius), InputError) << where << ' ' << lux << ' ' << radius;
    }
}

// A room with bounced light: what is said to be reached is what a second look finds, and it is one step.
class InARoom : public testing::Test {
  protected:
    InARoom() : settings(declared()) {
        run("new-room");
        run("add-light / second point 2 2.2 1 40cd");
        run("add-node / study -1.5 0 0");
        run("set /study light_contract.size [1.5,0.5,1.5]");
        run("set /study light_contract.lower 1");
    }
    static const SettingsSchema& declared() {
        struct All : SettingsSchema {
            All() { gi::declare_settings(*this); }
        };
        static const All schema;
        return schema;
    }
    void run(const std::string& line) { script.run_line(line); }

    Settings settings;
    std::vector<std::string> said;
    EditScript script{{}, settings, [this](const std::string& line) { said.push_back(line); }};
};

TEST_F(InARoom, ASolutionIsOneStepThatIsUndone) {
    run("wish /study 60");
    run("wish 2,0,1,0,1,0 70 0.2");
    run("expect wishes missed");
    run("expect steps 4");
    run("solve");
    EXPECT_EQ(said.back().substr(0, 23), "2 of 2 wishes met, miss") << said.back();
    run("expect wishes met");
    run("expect steps 5");
    EXPECT_EQ(script.session().history().back().text, "solve light wishes");
    run("undo");
    run("expect /room/lamp light.intensity 80");
    run("expect /second light.intensity 40");
    run("expect wishes missed");
}

TEST_F(InARoom, KeptLampsStay) {
    run("keep /second");
    run("wish /study 60");
    run("solve");
    run("expect wishes met");
    run("expect /second light.intensity 40");
    EXPECT_THROW(run("keep /study"), InputError);
}

TEST_F(InARoom, WhatCannotBeIsSaid) {
    EXPECT_THROW(run("solve"), InputError);  // no wish
    run("wish /room/floor 60");
    EXPECT_THROW(run("solve"), InputError);  // neither sensor nor contract
    run("forget-wishes");
    run("wish 0,9,0 60");
    run("solve");
    EXPECT_NE(said.front().find("no surface is there"), std::string::npos) << said.front();
    run("expect wishes missed");
    run("forget-wishes");
    run("wish /study 60");
    run("keep /room/lamp /second");
    EXPECT_THROW(run("solve"), InputError);  // no lamp is left
}

}  // namespace
}  // namespace lanthorn::editor

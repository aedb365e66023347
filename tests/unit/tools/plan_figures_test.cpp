// What `lanthorn measure plan` makes of its measurements.
#include "tools/lanthorn/measure/plan_figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lanthorn/core/error.h"
#include "lanthorn/workbench/all_settings.h"

namespace lanthorn::tools {
namespace plan_figures_test {

// Each case costs what is planned and `more` of it, in the case's own place.
PlanScene scene(const std::string& name, double gi, double more) {
    PlanScene s{name, {"rest", "lamp"}, {}, {}};
    for (const RuleSwitch& rule : rule_switches()) {
        s.rules.push_back(rule.setting);
    }
    const std::size_t cases = s.rules.size() + 2;
    for (std::size_t c = 0; c < cases; ++c) {
        const double extra = more * static_cast<double>(c);
        s.cases.push_back({{gi + extra, 5, 0.1, 20}, {gi + 3 * extra, 5, 0.2 - 0.01 * extra, 20 + extra}});
    }
    return s;
}

TEST(PlanFigures, EverySwitchIsASetting) {
    SettingsSchema schema;
    declare_all_settings(schema);
    Settings settings(schema);
    for (const RuleSwitch& rule : rule_switches()) {
        EXPECT_TRUE(settings.get<bool>(rule.setting)) << rule.setting << ": what is shipped has every rule";
        EXPECT_FALSE(rule.leaves_out.empty());
    }
}

TEST(PlanFigures, ARuleSavesWhatItsAbsenceCosts) {
    const std::vector<PlanScene> scenes = {scene("a", 1, 1), scene("b", 1, 3), scene("c", 1, 0)};
    const RuleFigures f = rule_figures(scenes, 2);
    EXPECT_DOUBLE_EQ(f.saved_median, 4) << "of 4, 12 and 0: means of 2 and 6 over two motions";
    EXPECT_DOUBLE_EQ(f.saved_best, 12);
    EXPECT_EQ(f.best_scene, "b");
    EXPECT_EQ(f.best_motion, "lamp");
    EXPECT_NEAR(f.error_most, 0.06, 1e-12) << "the rule's picture errs by more than without it";
    EXPECT_EQ(f.worst_scene, "b");
    EXPECT_DOUBLE_EQ(f.mb_most, 6);
}

TEST(PlanFigures, EverythingIsHeldAgainstThePlan) {
    const PlanRatio ratio = everything_over_planned(scene("a", 1, 1));
    const auto all = static_cast<double>(rule_switches().size() + 1);
    EXPECT_DOUBLE_EQ(ratio.gi, 1 + 2 * all);
    EXPECT_DOUBLE_EQ(ratio.frame, (6 + 2 * all) / 6);
    EXPECT_LT(everything_over_planned(scene("still", 0, 1)).gi, 1e6) << "no division by nothing";
    EXPECT_DOUBLE_EQ(everything_over_planned(scene("nothing", 0, 0)).gi, 1);
}

// An error below the references' noise is no number; others of the scene still count.
TEST(PlanFigures, ErrorsThatAreLostInNoiseAreLeftOut) {
    PlanScene lost = scene("a", 1, 1);
    lost.cases.front().front().error = std::numeric_limits<double>::quiet_NaN();
    const PlanScene read = plan_from_json(nlohmann::ordered_json::parse(plan_json(lost).dump()), "a.json");
    EXPECT_TRUE(std::isnan(read.cases.front().front().error));
    EXPECT_EQ(plan_markdown({read}), plan_markdown({lost}));
    EXPECT_EQ(plan_markdown({read}).find("nan"), std::string::npos);
    EXPECT_TRUE(std::isfinite(rule_figures({read}, 1).error_most));
}

TEST(PlanFigures, SurviveTheirJson) {
    const PlanScene before = scene("a", 1, 1);
    const PlanScene after = plan_from_json(plan_json(before), "a.json");
    EXPECT_EQ(after.name, "a");
    EXPECT_EQ(after.motions, before.motions);
    EXPECT_EQ(plan_markdown({after}), plan_markdown({before}));
    nlohmann::ordered_json damaged = plan_json(before);
    damaged["cases"].erase(0);
    damaged["cases"].erase(0);
    EXPECT_THROW(plan_from_json(damaged, "a.json"), InputError) << "a case is missing";
    damaged = plan_json(before);
    damaged["rules"][2] = "gi.plan.weather";
    EXPECT_THROW(plan_from_json(damaged, "a.json"), InputError) << "of another build's rules";
    damaged = plan_json(before);
    damaged["motions"].push_back("walk");
    EXPECT_THROW(plan_from_json(damaged, "a.json"), InputError);
    EXPECT_THROW(plan_from_json(nlohmann::ordered_json::array(), "a.json"), InputError);
}

TEST(PlanFigures, TheTableHasARowARuleAndARowAScene) {
    const std::string table = plan_markdown({scene("a", 1, 1), scene("b", 2, 1)});
    for (const RuleSwitch& rule : rule_switches()) {
        EXPECT_NE(table.find("| `" + rule.setting + "` | " + rule.leaves_out + " | "), std::string::npos);
    }
    EXPECT_NE(table.find("| a | 1.0 ms | 23.0 ms | 23.0 |"), std::string::npos) << table;
    EXPECT_NE(table.find("| **median** | | | **17.5** |"), std::string::npos) << table;
}

// Of some rules alone: what everything on would cost was not measured.
TEST(PlanFigures, RulesThatAreMeasuredAloneHaveRowsAlone) {
    PlanScene some = scene("a", 1, 1);
    some.rules = {"render.still.kept"};
    some.cases.resize(2);
    EXPECT_FALSE(some.has_everything());
    const std::string table = plan_markdown({plan_from_json(plan_json(some), "a.json")});
    EXPECT_NE(table.find("| `render.still.kept` | "), std::string::npos) << table;
    EXPECT_EQ(table.find("gi.plan."), std::string::npos) << table;
    EXPECT_EQ(table.find("median**"), std::string::npos) << table;
    EXPECT_THROW(rule_named("gi.plan.weather"), InputError);
}

}  // namespace plan_figures_test
}  // namespace lanthorn::tools

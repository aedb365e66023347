// What `lanthorn trade` advises, with made-up charts.
#include "tools/lanthorn/trade/advice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "lanthorn/core/error.h"
#include "tests/unit/tools/run_program.h"
#include "tools/lanthorn/trade/advice_report.h"
#include "tools/lanthorn/trade/trade_report.h"

namespace lanthorn::tools {
namespace advice_test {

ChartRow row(const std::string& scene, const std::string& preset, double ms, double error) {
    return {scene, {"emc", preset, {}}, ms, error, 10, 0};
}

// `low` is quick and poor, `high` slow and good, and scene b takes four times as long as a.
std::vector<ChartRow> chart() {
    return {row("a", "low", 10, 0.4),   row("a", "medium", 20, 0.2), row("a", "high", 40, 0.1),
            row("b", "low", 40, 0.1),   row("b", "medium", 80, 0.3), row("b", "high", 160, 0.025),
            row("a", "ultra", 1, 0.001)};  // which b does not have
}

TEST(Advice, IsTheLeastErrorWithinTheTimeInEveryScene) {
    const Advice advice = advise(chart(), Budget::ms, 100);
    ASSERT_TRUE(advice.best);
    EXPECT_EQ(advice.best->way.preset, "low") << "medium has 0.24, and high takes 160 ms";
    EXPECT_NEAR(advice.best->error, 0.2, 1e-12) << "geometric: sqrt(0.4 0.1)";
    EXPECT_NEAR(advice.best->ms, 20, 1e-9);
    EXPECT_EQ(advice.best->most_ms, 40);
    EXPECT_EQ(advice.best->slowest, "b");
    EXPECT_EQ(advice.best->most_error, 0.4);
    EXPECT_EQ(advice.best->worst, "a");
    EXPECT_EQ(advise(chart(), Budget::ms, 160).best->way.preset, "high")
        << "a limit is kept by what equals it";
}

TEST(Advice, IsTheLeastTimeWithinTheError) {
    EXPECT_EQ(advise(chart(), Budget::error, 0.4).best->way.preset, "low");
    EXPECT_EQ(advise(chart(), Budget::error, 0.3).best->way.preset, "medium");
    EXPECT_EQ(advise(chart(), Budget::error, 0.1).best->way.preset, "high");
}

TEST(Advice, WithAShareOneScenesTimeDoesNotDecideForAll) {
    EXPECT_FALSE(advise(chart(), Budget::ms, 39).best);
    EXPECT_EQ(advise(chart(), Budget::ms, 39, 0.5).best->way.preset, "low");
    EXPECT_EQ(advise(chart(), Budget::ms, 40, 0.5).best->way.preset, "high");
    EXPECT_FALSE(advise(chart(), Budget::ms, 39, 0.51).best) << "more than half of two scenes are both";
}

TEST(Advice, SaysWhatComesNearestWhereNothingFits) {
    const Advice cheap = advise(chart(), Budget::ms, 5);
    EXPECT_FALSE(cheap.best);
    EXPECT_EQ(cheap.least, 40);
    EXPECT_EQ(cheap.nearest.way.preset, "low");
    const Advice good = advise(chart(), Budget::error, 0.01);
    EXPECT_FALSE(good.best);
    EXPECT_EQ(good.least, 0.1);
    EXPECT_EQ(good.nearest.way.preset, "high");
    Wishes wishes;
    wishes.ms = {5, 100};
    EXPECT_EQ(unmet(chart(), wishes),
              "5 ms: nothing: the cheapest takes 40 ms, by --technique emc --preset low");
    wishes.ms = {100};
    EXPECT_EQ(unmet(chart(), wishes), "");
}

TEST(Advice, OfSomeScenesKnowsTheirNames) {
    EXPECT_EQ(advise(of_scenes(chart(), {"a"}), Budget::ms, 5).best->way.preset, "ultra");
    EXPECT_THROW(of_scenes(chart(), {"c"}), InputError);
    EXPECT_FALSE(has_common_way({row("a", "low", 1, 1), row("b", "high", 1, 1)}));
    EXPECT_THROW(advise({row("a", "low", 1, 1), row("b", "high", 1, 1)}, Budget::ms, 1), InputError);
    EXPECT_THROW(advise({}, Budget::ms, 1), InputError);
}

TEST(Advice, AnErrorOfZeroDoesNotOutweighTheOthers) {
    const std::vector<ChartRow> rows = {row("a", "low", 1, 0), row("b", "low", 1, 1)};
    EXPECT_GT(advise(rows, Budget::ms, 1).best->error, 0);
    EXPECT_TRUE(std::isfinite(advise(rows, Budget::ms, 1).best->error));
}

TEST(Chart, IsReadAsItWasWritten) {
    TradeResult measured, lost;
    measured.point = {"rooms/a.glb", "emc", "low", {}, {"gi.photons=7", "gi.seed=2"}};
    measured.figures.cost_ms = 2.5;
    measured.figures.relrmse = 0.125;
    measured.figures.gpu_mb = 3;
    measured.figures.rss_mb = 4;
    lost.point = measured.point;
    lost.lost = "ended, \"by\" signal\n11";
    const std::vector<TradeResult> results = {lost, measured};
    for (const auto& rows : {parse_chart(trade_csv(results), "t.csv"), chart_rows(results)}) {
        ASSERT_EQ(rows.size(), 1u);
        EXPECT_EQ(rows[0].scene, "a");
        EXPECT_EQ(rows[0].way, (Way{"emc", "low", "gi.photons=7 gi.seed=2"}));
        EXPECT_EQ(rows[0].way.options(), "--technique emc --preset low --set gi.photons=7 --set gi.seed=2");
        EXPECT_EQ(rows[0].ms, 2.5);
        EXPECT_EQ(rows[0].error, 0.125);
        EXPECT_EQ(rows[0].gpu_mb, 3);
        EXPECT_EQ(rows[0].rss_mb, 4);
    }
}

TEST(Chart, WithoutMemoryStillAdvises) {
    const auto rows =
        parse_chart("scene,technique,preset,settings,cost_ms,relrmse\r\na,emc,low,,1,0.5\r\n", "t.csv");
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].gpu_mb, 0);
    EXPECT_EQ(rows[0].error, 0.5);
}

TEST(Chart, DamagedOnesAreRefusedInALine) {
    const std::string head = "scene,technique,preset,settings,cost_ms,relrmse\n";
    for (const std::string& text :
         {std::string(), std::string("not a chart\n"), head, head + "a,emc,low,,1\n",
          head + "a,emc,low,,x,1\n", head + "a,emc,low,,-1,1\n", head + "a,emc,low,,nan,1\n",
          head + "a,emc,low,,1,inf\n", head + "a,emc,low,,1,1 2\n", head + "a,emc,low,\"open,1,1\n"}) {
        EXPECT_THROW(parse_chart(text, "t.csv"), InputError) << text;
    }
    const testing_tools::TemporaryFolder folder;
    EXPECT_THROW(read_chart(folder.path("")), InputError) << "a folder without trade.csv";
    EXPECT_THROW(read_chart(folder.path("no.csv")), InputError);
    std::ofstream(folder.path("trade.csv")) << head << "a,emc,low,,1,1\n";
    EXPECT_EQ(read_chart(folder.path("")).size(), 1u);
}

TEST(AdviceReport, HasARowAWish) {
    Wishes wishes;
    wishes.ms = {5, 40};
    wishes.errors = {0.3};
    const std::string page = advice_markdown(chart(), wishes);
    EXPECT_NE(page.find("| 5 ms | nothing: the cheapest takes 40 ms | | | | | |\n"), std::string::npos)
        << page;
    EXPECT_NE(
        page.find(
            "| 40 ms | `--technique emc --preset low` | 0.20 | 0.40 (a) | 20 ms | 40 ms (b) | 10 MB |\n"),
        std::string::npos)
        << page;
    EXPECT_NE(page.find("| error 0.3 | `--technique emc --preset medium` |"), std::string::npos) << page;
    const auto json = advice_json(chart(), wishes);
    EXPECT_TRUE(json.at("wishes").at(0).at("best").is_null());
    EXPECT_EQ(json.at("wishes").at(0).at("least"), 40);
    EXPECT_EQ(json.at("wishes").at(1).at("best").at("preset"), "low");
    const std::string text = advice_text(chart(), wishes, true);
    EXPECT_NE(text.find("5 ms, each scene by itself"), std::string::npos) << text;
    EXPECT_NE(text.find("--preset ultra"), std::string::npos) << "which a alone has";
    EXPECT_NE(advice_html(chart(), wishes).find("<td class=\"text\">0.40 (a)</td>"), std::string::npos);
}

TEST(Seeds, GiveMediansAndTheSpreadOfErrors) {
    std::vector<TradeResult> of_seeds(3);
    for (std::size_t i = 0; i < 3; ++i) {
        of_seeds[i].figures.relrmse = std::vector<double>{0.3, 0.1, 0.2}[i];
        of_seeds[i].figures.gi = {1.0 + static_cast<double>(i), 5, 0};
        of_seeds[i].picture = std::to_string(i);
    }
    const TradeResult one = over_seeds(of_seeds);
    EXPECT_EQ(one.figures.relrmse, 0.2);
    EXPECT_EQ(one.figures.relrmse_least, 0.1);
    EXPECT_EQ(one.figures.relrmse_most, 0.3);
    EXPECT_EQ(one.figures.seeds, 3);
    EXPECT_EQ(one.figures.gi.median, 2);
    EXPECT_EQ(one.picture, "0");
    of_seeds[2].lost = "crashed";
    EXPECT_FALSE(over_seeds(of_seeds).measured());
}

}  // namespace advice_test
}  // namespace lanthorn::tools

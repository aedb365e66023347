// The sweep of `lanthorn trade`, its front and its reports, with made-up figures.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>

#include "lanthorn/core/error.h"
#include "lanthorn/core/stop_signal.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/workbench/all_settings.h"
#include "lanthorn/workbench/trade_measure.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/run_program.h"
#include "tools/lanthorn/trade/trade_report.h"
#include "tools/lanthorn/trade/trade_run.h"

namespace lanthorn::tools {
namespace {

using testing_tools::TemporaryFolder;

TradeResult result(double cost, double error, const std::string& scene = "a.glb") {
    TradeResult r;
    r.point = {scene, "emc", "medium", {}, {"gi.photons=" + std::to_string(static_cast<int>(cost))}};
    r.figures.cost_ms = cost;
    r.figures.relrmse = r.figures.relrmse_all = r.figures.flip = error;
    return r;
}

std::vector<bool> front(const std::vector<TradeResult>& results) {
    return pareto_front(results, &TradeFigures::relrmse);
}

TEST(ParetoFront, IsWhatNothingBetters) {
    EXPECT_EQ(front({result(1, 5), result(2, 3), result(3, 4), result(4, 3), result(5, 1)}),
              (std::vector<bool>{true, true, false, false, true}));
}

TEST(ParetoFront, KeepsEqualsAndScenesApartAndLeavesLostPointsOut) {
    TradeResult lost = result(0, 0);
    lost.lost = "crashed";
    EXPECT_EQ(front({result(2, 3), result(2, 3), result(9, 9, "b.glb"), lost}),
              (std::vector<bool>{true, true, true, false}));
    EXPECT_TRUE(front({}).empty());
}

TEST(Spread, IsMedianNearestRankAndLeast) {
    const Spread s = spread_of({4, 1, 3, 2});
    EXPECT_EQ(s.median, 2.5);
    EXPECT_EQ(s.p95, 4);
    EXPECT_EQ(s.min, 1);
    EXPECT_EQ(spread_of({7}).p95, 7);
}

class TradeSweep : public testing::Test {
  protected:
    TradeSweep() { declare_all_settings(schema_); }
    std::vector<std::string> labels(const Sweep& sweep) const {
        std::vector<std::string> list;
        for (const TradePoint& point : sweep_points(sweep, schema_)) {
            list.push_back(point.label());
        }
        return list;
    }
    static Sweep sweep_of(std::vector<std::string> techniques, std::vector<std::string> presets) {
        Sweep sweep;
        sweep.scenes = {"a.glb"};
        sweep.techniques = std::move(techniques);
        sweep.presets = std::move(presets);
        return sweep;
    }
    SettingsSchema schema_;
};

TEST_F(TradeSweep, TurnsOneKnobAtATimeAndNoPointTwice) {
    Sweep sweep = sweep_of({"emc", "path", "none"}, {"low", "medium"});
    sweep.knobs = {parse_knob("gi.photons=7,20000", schema_), parse_knob("path.spp=3", schema_)};
    EXPECT_EQ(labels(sweep), (std::vector<std::string>{
                                 "low", "low, splat", "medium", "medium, splat", "the paper's own way",
                                 "medium, gi.emc.final=splat, gi.photons=7", "path, path.spp=3", "none"}))
        << "20000 is what medium has";
}

TEST_F(TradeSweep, ShowsTheRivalsPresetsBesideEmcs) {
    Sweep sweep = sweep_of({"emc", "coarse-path"}, {"low", "high"});
    sweep.knobs = {parse_knob("gi.photons=7", schema_), parse_knob("gi.coarse-path.samples=3", schema_)};
    EXPECT_EQ(labels(sweep),
              (std::vector<std::string>{"low", "low, splat", "high", "high, splat", "the paper's own way",
                                        "medium, gi.emc.final=splat, gi.photons=7", "coarse-path low",
                                        "coarse-path high", "coarse-path medium, gi.coarse-path.samples=3"}))
        << "each turns its own knobs";
}

TEST_F(TradeSweep, ShowsBothFinalStagesOfEachPreset) {
    for (const std::string set : {"splat", "gather"}) {
        Sweep sweep = sweep_of({"emc"}, {"ultra"});
        sweep.common = {"gi.emc.final=" + set};
        sweep.presets_only = true;
        const std::string other = set == "splat" ? "gather" : "splat";
        EXPECT_EQ(labels(sweep),
                  (std::vector<std::string>{"ultra", "ultra, " + other, "the paper's own way"}));
        const std::vector<TradePoint> points = sweep_points(sweep, schema_);
        const auto final_of = [&](std::size_t i) {
            return gi::gi_settings(points[i].settings(schema_)).of<gi::EmcSettings>().final_stage;
        };
        EXPECT_NE(final_of(1), final_of(0));
        EXPECT_EQ(final_of(2), gi::EmcFinal::splat) << "as the paper does";
    }
}

TEST_F(TradeSweep, LeavesOutWhatStandsBesidePresets) {
    Sweep sweep = sweep_of({"emc", "coarse-path"}, {"low"});
    sweep.own_stage = true;
    sweep.knobs = {parse_knob("gi.emc.rays=maps", schema_)};
    EXPECT_EQ(labels(sweep),
              (std::vector<std::string>{"low", "medium, gi.emc.rays=maps", "coarse-path low"}));
}

TEST_F(TradeSweep, DrawsBothFinalStagesAsPresets) {
    TradeResult preset = result(2, 0.5);
    preset.point.assignments.clear();
    TradeResult other = result(1, 0.25);
    other.point = other_final_stage(preset.point, schema_);
    const std::string chart = trade_chart({preset, other}, preset.point.scene, trade_measures().front());
    EXPECT_NE(chart.find("emc, final stage " + other.point.stage), std::string::npos);
    EXPECT_NE(chart.find(">medium, " + other.point.stage + "</text>"), std::string::npos);
    EXPECT_EQ(chart.find("<circle"), std::string::npos) << "no knob is turned";
}

TEST(TradePoint, IsNamedByItsSceneAndCamera) {
    TradePoint point;
    point.scene = "rooms/a.b.glb@dark";
    EXPECT_EQ(point.scene_name(), "a.b-dark");
    point.scene = "rooms/a.b.glb";
    EXPECT_EQ(point.scene_name(), "a.b");
    const std::string still = point.panel();
    point.motion = TradeMotion::figure;
    EXPECT_EQ(point.scene_name(), "a.b-figure");
    EXPECT_NE(point.panel(), still) << "a chart of its own";
}

TEST_F(TradeSweep, HasEachMotionAsPointsOfItsOwn) {
    Sweep sweep = sweep_of({"emc", "coarse-path"}, {"low"});
    sweep.presets_only = true;
    const std::size_t one = sweep_points(sweep, schema_).size();
    sweep.motions = {TradeMotion::lamp, TradeMotion::walk, TradeMotion::box, TradeMotion::figure};
    const std::vector<TradePoint> points = sweep_points(sweep, schema_);
    EXPECT_EQ(points.size(), 4 * one);
    for (const TradeMotion motion : sweep.motions) {
        EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(points, motion, &TradePoint::motion)), one)
            << name_of(motion);
        EXPECT_EQ(trade_motion_named(name_of(motion)), motion);
    }
    EXPECT_THROW(trade_motion_named("dance"), InputError);
}

// A figure is compared where its last frame shows it, all else where the scene has it.
TEST(TradeMeasurement, ComparesAFigureWhereItArrives) {
    TradeMeasurement job;
    job.view.time = 1;
    job.frames = 5;
    job.warmup = 8;
    const ListedScene puppet = listed_scene(support::repository_file("assets/puppet.glb"), job.view);
    EXPECT_DOUBLE_EQ(*last_view(puppet, TradeMotion::walk, job).view.time, 1);
    EXPECT_DOUBLE_EQ(*last_view(puppet, TradeMotion::figure, job).view.time, 1 + 12 / 60.0);
}

// A box is in what the last frame is compared with, and in no other motion's.
TEST(TradeMeasurement, ComparesABoxWhereItArrives) {
    const TradeMeasurement job;
    const ListedScene rooms = listed_scene(support::repository_file("assets/two-rooms.glb"), job.view);
    EXPECT_FALSE(last_view(rooms, TradeMotion::lamp, job).view.box);
    const LastView last = last_view(rooms, TradeMotion::box, job);
    ASSERT_TRUE(last.view.box);
    EXPECT_EQ(load_scene(rooms.file, last.view).nodes.size(),
              load_scene(rooms.file, rooms.view).nodes.size() + 1);
    EXPECT_EQ(last_view(rooms, TradeMotion::figure, job).lacking,
              "it has no animation, expected some for --motion figure");
}

TEST_F(TradeSweep, ThePapersOwnWayHasThePapersEpsilon) {
    const Sweep sweep = sweep_of({"emc"}, {"medium"});
    const std::vector<TradePoint> points = sweep_points(sweep, schema_);
    const TradePoint& paper = *std::ranges::find(points, "the paper's own way", &TradePoint::name);
    EXPECT_EQ(paper.knob(), paper.name);
    const Settings settings = paper.settings(schema_);
    EXPECT_FLOAT_EQ(settings.get<float>("gi.emc.threshold"), 1e-3f);
    EXPECT_TRUE(settings.get<bool>("gi.emc.exhaustive"));
    EXPECT_NE(settings.to_json().find("secant"), std::string::npos);
}

TEST_F(TradeSweep, ProductIsEveryCombination) {
    Sweep sweep = sweep_of({"emc"}, {});
    sweep.product = true;
    sweep.knobs = {parse_knob("gi.photons=7,8", schema_), parse_knob("gi.bounces=1,3", schema_)};
    EXPECT_EQ(labels(sweep).size(), 4u);
    EXPECT_EQ(labels(sweep).front(), "medium, gi.emc.final=splat, gi.photons=7, gi.bounces=1");
}

// Before memory is taken for them: the knobs of emc alone have 233 280.
TEST_F(TradeSweep, RefusesCombinationsThatNoOneCouldWaitFor) {
    Sweep sweep = sweep_of({"emc"}, {});
    sweep.product = true;
    EXPECT_THROW(labels(sweep), InputError);
    std::string values = "gi.photons=1";
    for (int i = 2; i <= 100; ++i) {
        values += ',' + std::to_string(i);
    }
    sweep.knobs = {parse_knob(values, schema_), parse_knob(values, schema_)};
    EXPECT_EQ(labels(sweep).size(), 100u);  // the same settings are one point
    sweep.knobs.push_back(parse_knob("gi.bounces=1,3", schema_));
    EXPECT_THROW(labels(sweep), InputError);
}

TEST_F(TradeSweep, DefaultKnobsAreDeclared) {
    for (const gi::TechniqueEntry& technique : gi::techniques()) {
        for (const Knob& knob : technique.turns) {
            Settings settings(schema_);
            for (const std::string& value : knob.values) {
                EXPECT_NO_THROW(settings.set_from_text(knob.name, value)) << knob.name;
            }
        }
    }
}

TEST_F(TradeSweep, RefusesWhatIsEmptyOrUnknown) {
    Sweep sweep = sweep_of({"path"}, {"low"});
    sweep.presets_only = true;
    EXPECT_THROW(labels(sweep), InputError);
    for (const char* text : {"gi.photons", "gi.photons=", "gi.photons=x", "gi.photos=1", "gi.photons=1,,2"}) {
        EXPECT_THROW(parse_knob(text, schema_), InputError) << text;
    }
}

class TradeRuns : public testing::Test {
  protected:
    // Two points; the runner writes figures for those it is not told to crash at.
    TradeRun run(std::size_t crash_at, ChildOutcome crash, std::size_t stop_after = 100) {
        const std::vector<TradePoint> points = {result(1, 1).point, result(2, 1).point, result(3, 1).point};
        std::vector<std::filesystem::path> stems;
        for (std::size_t i = 0; i < points.size(); ++i) {
            stems.emplace_back(folder_.path("p" + std::to_string(i)));
        }
        ran_ = 0;
        return run_points(
            points, stems,
            [&](const TradePoint&, const std::filesystem::path& stem) {
                const bool crashes =
                    stem == stems[std::min(crash_at, points.size() - 1)] && crash_at < points.size();
                ++ran_;
                if (!crashes) {
                    std::ofstream(stem.string() + ".png") << "picture";
                    std::ofstream(stem.string() + ".json") << figures_json(result(1, 1).figures);
                }
                return crashes ? crash : ChildOutcome{};
            },
            [](std::size_t) {}, [&] { return ran_ >= stop_after; });
    }
    TemporaryFolder folder_;
    std::size_t ran_ = 0;
};

TEST_F(TradeRuns, ACrashLosesThatPointOnlyAndItIsTriedAgain) {
    const TradeRun first = run(1, {0, 11, ""});
    ASSERT_EQ(first.results.size(), 3u);
    EXPECT_EQ(first.lost, 1u);
    EXPECT_TRUE(first.results[0].measured());
    EXPECT_NE(first.results[1].lost.find("signal 11"), std::string::npos);
    EXPECT_TRUE(first.results[2].measured());

    const TradeRun second = run(9, {});
    EXPECT_EQ(ran_, 1u) << "the others are kept";
    EXPECT_EQ(second.kept, 2u);
    EXPECT_EQ(second.lost, 0u);
}

TEST_F(TradeRuns, AnInterruptKeepsWhatIsFinished) {
    const TradeRun first = run(9, {}, 1);
    EXPECT_TRUE(first.interrupted);
    EXPECT_EQ(first.results.size(), 1u);
    EXPECT_EQ(run(9, {}).kept, 1u);
}

TEST_F(TradeRuns, ADamagedPointIsMeasuredAgain) {
    run(9, {});
    std::ofstream(folder_.path("p2.json")) << "{\"gi_ms\":";
    const TradeRun again = run(9, {});
    EXPECT_EQ(again.kept, 2u);
    EXPECT_EQ(ran_, 1u);
    EXPECT_EQ(again.lost, 0u);
}

TEST_F(TradeRuns, WithoutOpenGlNothingGoesOn) {
    try {
        run(1, {3, 0, "no OpenGL"});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::no_gl);
        EXPECT_STREQ(error.what(), "no OpenGL");
    }
}

TEST(ChildProcess, SaysHowItEnded) {
    EXPECT_TRUE(run_child({"/bin/sh", "-c", "exit 0"}).ok());
    const ChildOutcome failed = run_child({"/bin/sh", "-c", "echo one >&2; echo two >&2; exit 2"});
    EXPECT_EQ(failed.code, 2);
    EXPECT_EQ(failed.why(), "two");
    const ChildOutcome killed = run_child({"/bin/sh", "-c", "kill -SEGV $$"});
    EXPECT_EQ(killed.signal, 11);
    EXPECT_EQ(run_child({"/nowhere/at-all"}).code, 127);
}

// A child that never stops talking is asked to stop all the same, and what it said is not kept.
TEST(ChildProcess, IsAskedToStopWhileItTalks) {
    std::signal(SIGTERM, SIG_DFL);  // also where these tests run with it ignored
    const StopSignal stop;
    const ChildOutcome outcome =
        run_child({"/bin/sh", "-c",
                   fmt::format("trap 'echo stopped >&2; exit 7' TERM; kill -TERM {}; while :; do echo "
                               "talking >&2; done",
                               getpid())});
    EXPECT_EQ(outcome.code, 7);
    EXPECT_EQ(outcome.last_line, "stopped");
}

TEST(TradeFigures, SurviveTheirJson) {
    TradeFigures figures = result(3.25, 0.125).figures;
    figures.gi = {1, 2, 0.5};
    figures.renderer = "llvmpipe";
    const TradeFigures read = figures_from_json(figures_json(figures), "f.json");
    EXPECT_EQ(read.cost_ms, 3.25);
    EXPECT_EQ(read.relrmse, 0.125);
    EXPECT_EQ(read.gi.p95, 2);
    EXPECT_EQ(read.renderer, "llvmpipe");
    EXPECT_THROW(figures_from_json("{}", "f.json"), InputError);
}

std::vector<TradeResult> three_results() {
    std::vector<TradeResult> results = {result(10, 0.5), result(20, 0.2), result(30, 0.4)};
    results[0].point.assignments.clear();
    results[1].picture = "</script>";
    results[2].lost = "ended by \"signal\", 11";
    return results;
}

TEST(TradeReports, CsvHasALineAPointWithAsManyFields) {
    const std::string csv = trade_csv(three_results());
    EXPECT_EQ(std::ranges::count(csv, '\n'), 4);
    EXPECT_NE(csv.find("\"ended by \"\"signal\"\", 11\""), std::string::npos);
    const std::string first = csv.substr(0, csv.find('\n'));
    const std::string second =
        csv.substr(first.size() + 1, csv.find('\n', first.size() + 1) - first.size() - 1);
    EXPECT_EQ(std::ranges::count(first, ','), std::ranges::count(second, ','));
}

TEST(TradeReports, PageNeedsNothingElse) {
    const std::string html =
        trade_html(three_results(), {"a <machine>", "gl", "build", "method", "reference"});
    EXPECT_NE(html.find("a &lt;machine&gt;"), std::string::npos);
    EXPECT_NE(html.find("PC9zY3JpcHQ+"), std::string::npos) << "the picture";
    EXPECT_EQ(html.find("src=\"http"), std::string::npos);
    EXPECT_EQ(html.find("<link"), std::string::npos);
    EXPECT_EQ(html.find("</script>"), html.rfind("</script>"));
    EXPECT_NE(html.find("data-i=\"1\""), std::string::npos);
}

TEST(TradeReports, DrawingShowsMeasuredPointsAlone) {
    const std::string svg = trade_svg(three_results(), {});
    EXPECT_NE(svg.find("data-i=\"0\""), std::string::npos);
    EXPECT_NE(svg.find("data-i=\"1\""), std::string::npos);
    EXPECT_EQ(svg.find("data-i=\"2\""), std::string::npos);
    EXPECT_NE(trade_svg({}, {}).find("</svg>"), std::string::npos);
}

TEST(TradeReports, DrawingHasTimeMemoryAndSpread) {
    std::vector<TradeResult> results = {result(10, 0.5), result(20, 0.2)};
    EXPECT_EQ(trade_svg(results, {}).find("class=\"spread\""), std::string::npos) << "one seed has none";
    for (TradeResult& r : results) {
        r.figures.gpu_mb = 100;
        r.figures.seeds = 5;
        r.figures.relrmse_least = 0.9 * r.figures.relrmse;
        r.figures.relrmse_most = 1.2 * r.figures.relrmse;
    }
    const std::string svg = trade_svg(results, {});
    EXPECT_NE(svg.find("10 ms, relRMSE 0.5"), std::string::npos);
    EXPECT_NE(svg.find("100 GPU MB, relRMSE 0.5"), std::string::npos);
    EXPECT_NE(svg.find(">all seeds</text>"), std::string::npos);
    EXPECT_NE(svg.find(">gi.photons</text>"), std::string::npos) << "of two values";
    const std::string times = trade_svg(results, {}, TradeDrawing::time);
    EXPECT_NE(times.find("10 ms, relRMSE 0.5"), std::string::npos);
    EXPECT_EQ(times.find("GPU MB"), std::string::npos);
    EXPECT_NE(times.find("class=\"spread\""), std::string::npos);
    results.pop_back();
    EXPECT_NE(trade_svg(results, {}).find(">gi.photons=10</text>"), std::string::npos) << "of one";
}

}  // namespace
}  // namespace lanthorn::tools

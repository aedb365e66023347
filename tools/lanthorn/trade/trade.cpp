// lanthorn trade SCENE... -o DIR: error against time for all techniques.
// lanthorn trade --from CHART --for-ms MS: what to set, by a chart that is finished.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <thread>
#include <tuple>

#include "engine/build_info/build_info.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/choice.h"
#include "lanthorn/core/progress.h"
#include "lanthorn/core/stop_signal.h"
#include "lanthorn/workbench/all_settings.h"
#include "lanthorn/workbench/render_job.h"
#include "lanthorn/workbench/trade_measure.h"
#include "tools/lanthorn/commands.h"
#include "tools/lanthorn/common/common_options.h"
#include "tools/lanthorn/farm/farm_options.h"
#include "tools/lanthorn/trade/advice_command.h"
#include "tools/lanthorn/trade/trade_children.h"
#include "tools/lanthorn/trade/trade_report.h"
#include "tools/lanthorn/trade/trade_run.h"
#include "tools/workbench/scene/stopping.h"

namespace lanthorn::tools {

namespace fs = std::filesystem;

namespace {

struct TradeArguments : TradeOptions {
    AdviceOptions advice;
    std::vector<std::string> motions = {"light"};
};

struct PointOptions {
    TradePoint point;
    TradeMeasurement job;
    TradeReferences references;
    std::string stem, motion;
    int thumbnail = 96;
};

CLI::Validator is_motion() {
    return CLI::IsMember(std::vector<std::string>(kTradeMotionNames.begin(), kTradeMotionNames.end()));
}

// In words.
std::string transport_of_references(const TradeOptions& options) {
    for (const std::string& assignment : of_references(options)) {
        if (assignment.starts_with("path.transport=")) {
            return assignment.substr(15) + " transport";
        }
    }
    return "diffuse transport (pictures: full)";
}

TradeContext context_of(const TradeOptions& options, const std::vector<TradeResult>& results) {
    TradeContext context;
    context.machine = fmt::format("{}, {} threads", processor(), std::thread::hardware_concurrency());
    for (const TradeResult& r : results) {
        if (r.measured() && r.point.technique != "path") {
            context.renderer = r.figures.renderer;
        }
    }
    context.build = fmt::format("lanthorn {} {}, {}", kVersion, kCommit, kBuildType);
    double noise = 0;
    for (const TradeResult& r : results) {
        noise = std::max(noise, r.figures.reference_noise);
    }
    context.method =
        fmt::format("{}; medians of {} frames after {}; in each, unless the name says otherwise, light moves",
                    options.size, options.job.frames, options.job.warmup);
    context.reference = fmt::format(
        "references: path tracing, {}, {} samples a pixel, own relRMSE at most {:.2g}, its square taken off",
        transport_of_references(options), options.reference_spp, noise);
    return context;
}

void write_reports(const TradeFolder& folder, const TradeOptions& options,
                   std::vector<TradeResult>& results) {
    const std::vector<bool> front = pareto_front(results, trade_measures().front().error);
    for (std::size_t i = 0; i < results.size(); ++i) {
        results[i].on_front = front[i];
    }
    const TradeContext context = context_of(options, results);
    write_file(folder.file("trade.csv"), trade_csv(results));
    write_file(folder.file("trade.svg"), trade_svg(results, context));
    write_file(folder.file("trade-time.svg"), trade_svg(results, context, TradeDrawing::time));
    write_file(folder.file("trade.html"), trade_html(results, context));
}

// Each point as often as there are seeds, those of a point behind each other.
std::vector<TradePoint> with_seeds(const std::vector<TradePoint>& points, int seeds,
                                   const SettingsSchema& schema) {
    std::vector<TradePoint> result;
    for (const TradePoint& point : points) {
        const int first = point.settings(schema).get<int>("gi.seed");
        for (int i = 0; i < seeds; ++i) {
            result.push_back(point);
            if (i > 0) {
                result.back().common.push_back(fmt::format("gi.seed={}", first + i));
            }
        }
    }
    return result;
}

// What with_seeds() made many of, one again. A point whose seeds are not all there is left out.
std::vector<TradeResult> without_seeds(const std::vector<TradeResult>& results, int seeds) {
    std::vector<TradeResult> points;
    const auto count = static_cast<std::size_t>(seeds);
    for (std::size_t i = 0; i + count <= results.size(); i += count) {
        const auto first = results.begin() + static_cast<std::ptrdiff_t>(i);
        points.push_back(over_seeds({first, first + seeds}));
    }
    return points;
}

// Has the points that are missing measured by other processes, and says of each what became of it.
PointRunner measured_by_others(const std::vector<TradePoint>& points, const std::vector<fs::path>& stems,
                               const TradeArguments& options, const TradeFolder& folder,
                               const SettingsSchema& schema) {
    constexpr double kStartSeconds = 5, kFrameSeconds = 0.5;
    std::vector<suite::FarmTask> tasks;
    std::vector<fs::path> of_task;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!is_finished(stems[i]) && std::ranges::find(of_task, stems[i]) == of_task.end()) {
            const fs::path stem = fs::absolute(stems[i]);
            std::error_code ignored;
            fs::remove(stem.string() + ".json", ignored);  // damaged, or without its picture
            tasks.push_back({point_command(points[i], options, folder.references(points[i], schema), stem),
                             stem.string() + ".json",
                             kStartSeconds + kFrameSeconds * (options.job.frames + options.job.warmup)});
            of_task.push_back(stems[i]);
        }
    }
    const suite::FarmReport report =
        do_tasks(tasks, options.farm, folder.file("farm").string(), "measuring points", true);
    std::map<std::string, ChildOutcome> outcomes;
    for (const auto& [task, loss] : report.lost) {
        outcomes[of_task[task].string()] = {loss.code, 0, loss.why};
    }
    return [outcomes](const TradePoint&, const fs::path& stem) {
        const auto found = outcomes.find(stem.string());
        return found == outcomes.end() ? ChildOutcome() : found->second;
    };
}

ExitCode trade(TradeArguments options) {
    if (!options.advice.from.empty()) {
        if (!options.output.empty()) {
            throw InputError(
                "trade: found --from and -o, expected one of them: a finished chart, or a new one");
        }
        return advise_from_chart(options.advice, options.sweep.scenes);
    }
    if (options.sweep.scenes.empty() || options.output.empty()) {
        throw InputError("trade: expected scenes and -o DIR, or --from with a finished chart");
    }
    SettingsSchema schema;
    declare_all_settings(schema);
    options.job.size = parse_size("--size", options.size, 1, kLargestPicture);
    options.sweep.motions.clear();
    std::ranges::transform(options.motions, std::back_inserter(options.sweep.motions), trade_motion_named);
    for (const std::string& knob : options.knobs) {
        options.sweep.knobs.push_back(parse_knob(knob, schema));
    }
    std::vector<TradePoint> swept = sweep_points(options.sweep, schema);
    const TradeFolder folder(options);
    std::erase_if(swept, [&](const TradePoint& point) { return !folder.has(point.scene, point.motion); });
    const std::vector<TradePoint> points = with_seeds(swept, options.seeds, schema);

    const StopSignal stop;
    std::set<std::tuple<std::string, TradeMotion, int>> references;
    std::vector<fs::path> stems;
    for (const TradePoint& point : points) {
        references.emplace(point.scene, point.motion, 0);
        references.emplace(point.scene, point.motion, point.settings(schema).get<int>("gi.bounces"));
        stems.push_back(folder.stem(point, schema));
    }
    Progress progress("measuring", references.size() + points.size());
    std::uint64_t done = 0;
    for (const auto& [scene, motion, bounces] : references) {
        if (!stop.asked()) {
            make_reference(folder, options, scene, motion, bounces, stop);
        }
        progress.update(++done);
    }
    PointRunner runner = [&](const TradePoint& point, const fs::path& stem) {
        return run_own(point_command(point, options, folder.references(point, schema), stem));
    };
    if (options.by_others() && !stop.asked()) {
        runner = measured_by_others(points, stems, options, folder, schema);
    }
    TradeRun run = run_points(
        points, stems, runner, [&](std::size_t n) { progress.update(done + n); },
        [&] { return stop.asked(); });

    run.results = without_seeds(run.results, options.seeds);
    write_reports(folder, options, run.results);
    const std::size_t measured = run.results.size() - run.lost;
    if (run.interrupted) {
        throw Stopped("trade",
                      fmt::format("{} of {} points are done and kept in {}, the same command goes on",
                                  measured, points.size(), options.output));
    }
    if (run.lost > 0) {
        const auto lost =
            std::ranges::find_if(run.results, [](const TradeResult& r) { return !r.measured(); });
        throw Error(ExitCode::check_failed,
                    fmt::format("trade: {} of {} points lost, the first {} ({}): {}", run.lost, points.size(),
                                lost->point.label(), lost->point.scene_name(), lost->lost));
    }
    return options.advice.wishes.any() ? advise_by(chart_rows(run.results), options.advice) : ExitCode::ok;
}

ExitCode measure_point(PointOptions options) {
    SettingsSchema schema;
    declare_all_settings(schema);
    options.point.motion = trade_motion_named(options.motion);
    TradeView view = view_point(options.point, options.job, schema);
    compare_with_references(view, options.references);
    write_image(options.stem + ".png", picture_of(view, options.references.same, options.thumbnail));
    write_file(options.stem + ".json", figures_json(view.figures));
    return ExitCode::ok;
}

}  // namespace

Command add_trade(CLI::App& app) {
    auto options = std::make_shared<TradeArguments>();
    Sweep& sweep = options->sweep;
    sweep.techniques = gi::technique_names();
    sweep.presets.assign(kPresetNames.begin(), kPresetNames.end());
    CLI::App* command = app.add_subcommand(
        "trade", "Draw error against time: techniques, presets and settings, as CSV, SVG and an HTML page.");
    const auto is_preset = CLI::IsMember(preset_names());
    command->add_option(
        "SCENE", sweep.scenes,
        "glTF 2.0 files (.gltf, .glb), FILE@CAMERA for one of its cameras; with --from: names of "
        "scenes of that chart (default: all)");
    command->add_option("-o,--output", options->output,
                        "folder for trade.csv, trade.svg, trade-time.svg, trade.html and, below it, what is "
                        "finished: the same command "
                        "again measures only what is missing");
    add_advice_options(*command, options->advice);
    command
        ->add_option(
            "--technique", sweep.techniques,
            fmt::format("{} (default: all), separated by commas", fmt::join(gi::technique_names(), ", ")))
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember(gi::technique_names()));
    command
        ->add_option("--preset", sweep.presets,
                     "presets to show, paper among them (default: low to ultra), separated by commas")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(is_preset);
    command->add_option("--around", sweep.around, "preset that knobs are turned from")
        ->check(is_preset)
        ->capture_default_str();
    command
        ->add_option("--knob", options->knobs,
                     "KEY=VALUE,VALUE,...: a setting to turn, repeatable (default: those with a price)")
        ->allow_extra_args(false);
    command->add_flag("--product", sweep.product,
                      "all combinations of the knobs instead of one at a time, up to 10000 a technique");
    command->add_flag("--presets-only", sweep.presets_only, "turn no knobs");
    command->add_flag(
        "--own-stage", sweep.own_stage,
        "leave out what stands beside emc's presets: their other final stage, and the paper's own "
        "way");
    command
        ->add_option(
            "--set", sweep.common,
            "KEY=VALUE, repeatable: a setting of every point; those of path (path.transport=full) of "
            "the references too")
        ->allow_extra_args(false);
    command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    add_camera_option(*command, options->job.view.camera);
    add_moment_options(*command, options->job.view, "that is shown, standing still (default: 0)");
    command
        ->add_option("--motion", options->motions,
                     "what changes in each frame, a chart each, separated by commas: light (default), lamp "
                     "and walk (2 cm a frame), box (a grey one, put into the middle of the picture, 3 cm), "
                     "figure (the animation plays from --time on). A scene that lacks one is left out of its "
                     "chart")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(is_motion());
    command
        ->add_option(
            "--seeds", options->seeds,
            "measure each point with so many seeds: figures are medians, and the CSV and the page have "
            "the least and the largest error")
        ->check(CLI::Range(1, 100))
        ->capture_default_str();
    command->add_option("--frames", options->job.frames, "frames to measure")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command->add_option("--warmup", options->job.warmup, "frames to render before, not measured")
        ->check(CLI::Range(0, 100000))
        ->capture_default_str();
    command->add_option("--reference-spp", options->reference_spp, "samples a pixel of the references")
        ->check(CLI::Range(2, 1000000))
        ->capture_default_str();
    add_farm_options(*command, options->farm);
    command->add_option("--thumbnail", options->thumbnail, "width in pixels of the page's pictures")
        ->check(CLI::Range(8, 1024))
        ->capture_default_str();
    return [options] { return trade(*options); };
}

Command add_trade_point(CLI::App& app) {
    auto options = std::make_shared<PointOptions>();
    CLI::App* command = app.add_subcommand("trade-point", "One point of trade, in a process of its own.");
    command->group("");
    command->add_option("SCENE", options->point.scene)->required();
    const std::pair<const char*, std::string*> texts[] = {
        {"--technique", &options->point.technique}, {"--preset", &options->point.preset},
        {"--same", &options->references.same},      {"--all", &options->references.all},
        {"--final", &options->references.final},    {"-o", &options->stem}};
    for (const auto& [name, text] : texts) {
        command->add_option(name, *text)->required();
    }
    const std::pair<const char*, int*> numbers[] = {{"--width", &options->job.size.x},
                                                    {"--height", &options->job.size.y},
                                                    {"--frames", &options->job.frames},
                                                    {"--warmup", &options->job.warmup},
                                                    {"--thumbnail", &options->thumbnail}};
    for (const auto& [name, number] : numbers) {
        command->add_option(name, *number)->required()->check(CLI::PositiveNumber | CLI::Range(0, 0));
    }
    add_camera_option(*command, options->job.view.camera);
    command->add_option("--motion", options->motion)->required()->check(is_motion());
    add_moment_options(*command, options->job.view, "");
    command->add_option("--set", options->point.assignments)->allow_extra_args(false);
    return [options] { return measure_point(*options); };
}

}  // namespace lanthorn::tools

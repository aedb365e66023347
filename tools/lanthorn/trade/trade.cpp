// lanthorn trade SCENE... -o DIR: error against time for all techniques.
// lanthorn trade --from CHART --for-ms MS: what to set, by a chart that is finished.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <string_view>
#include <thread>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "engine/build_info/build_info.h"
#include "gi_module/reference/scene_hash.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/choice.h"
#include "lanthorn/core/progress.h"
#include "lanthorn/core/stop_signal.h"
#include "lanthorn/workbench/all_settings.h"
#include "lanthorn/workbench/load_scene.h"
#include "lanthorn/workbench/render_job.h"
#include "lanthorn/workbench/trade_measure.h"
#include "tools/lanthorn/commands.h"
#include "tools/lanthorn/common/common_options.h"
#include "tools/lanthorn/common/warnings.h"
#include "tools/lanthorn/common/workbench.h"
#include "tools/lanthorn/trade/advice_report.h"
#include "tools/lanthorn/trade/trade_report.h"
#include "tools/lanthorn/trade/trade_run.h"
#include "tools/workbench/scene/stopping.h"

namespace lanthorn::tools {

namespace fs = std::filesystem;

namespace {

constexpr int kReferenceSeed = 7001;  // of no point's photons or paths

struct Options {
    Sweep sweep;
    std::vector<std::string> knobs;
    std::string output, size = "512x512";
    TradeMeasurement job;
    int reference_spp = 256;
    int thumbnail = 96;
    int seeds = 1;
    std::string from;  // a finished chart; empty: one is made
    Wishes wishes;
    bool markdown = false, json = false;
};

struct PointOptions {
    TradePoint point;
    TradeMeasurement job;
    TradeReferences references;
    std::string stem;
    int thumbnail = 96;
};

const char* motion_name(TradeMotion motion) {
    return motion == TradeMotion::light ? "light" : "camera";
}

// Sets the motion when the command line has been read.
void add_motion_option(CLI::App& command, TradeMotion& motion) {
    command
        .add_option_function<std::string>(
            "--motion",
            [&motion](const std::string& name) {
                motion = name == motion_name(TradeMotion::camera) ? TradeMotion::camera : TradeMotion::light;
            },
            "what changes in each frame: light (default), or camera, which walks 2 cm sideways")
        ->check(CLI::IsMember({motion_name(TradeMotion::light), motion_name(TradeMotion::camera)}));
}

std::string hex_hash(const std::string& text) {
    return fmt::format("{:016x}", XXH3_64bits(text.data(), text.size()));
}

std::string processor() {
    std::ifstream stream("/proc/cpuinfo");
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with("model name")) {
            return line.substr(line.find(':') + 2);
        }
    }
    return "unknown processor";
}

// Settings of the path tracer that every point has hold for the references too where they say what light does
// at surfaces: not how many samples are taken, nor when it ends.
std::vector<std::string> of_references(const Options& options) {
    constexpr std::array<std::string_view, 2> kKept = {"path.transport=", "path.caustics="};
    std::vector<std::string> list;
    for (const std::string& assignment : options.sweep.common) {
        if (std::ranges::any_of(kKept, [&](std::string_view name) { return assignment.starts_with(name); })) {
            list.push_back(assignment);
        }
    }
    return list;
}

// In words.
std::string transport_of_references(const Options& options) {
    for (const std::string& assignment : of_references(options)) {
        if (assignment.starts_with("path.transport=")) {
            return assignment.substr(15) + " transport";
        }
    }
    return "diffuse transport (pictures: full)";
}

// The files of one run, and what tells one measurement from another.
class TradeFolder {
  public:
    explicit TradeFolder(const Options& options) : options_(options), folder_(options.output) {
        for (const fs::path& path : {folder_ / "points", folder_ / "references"}) {
            std::error_code error;
            fs::create_directories(path, error);
            if (error) {
                throw InputError(path.string(), "", "cannot be made: " + error.message());
            }
        }
        for (const char* name :
             {"trade.csv", "trade.svg", "trade.html", "points/probe", "references/probe"}) {
            check_writable(folder_ / name);
        }
        for (const std::string& scene : options.sweep.scenes) {
            const ListedScene listed = listed_scene(scene, options.job.view);
            ShownScene shown(tell_warnings(listed.file, load_scene(listed.file, listed.view)), listed.view);
            shown.show_at(options.job.view.time.value_or(0));
            hashes_[scene] = reference::scene_hash(shown.frame());
        }
    }

    fs::path file(const std::string& name) const { return folder_ / name; }

    // Where a point's figures are kept: another build's are not this one's.
    fs::path stem(const TradePoint& point, const SettingsSchema& schema) const {
        const TradeMeasurement& job = options_.job;
        const std::string key =
            fmt::format("{:x} {} {} {}x{} {} {} {} {} {} {} {} {}", hashes_.at(point.scene), point.technique,
                        point.settings(schema).to_json(), job.size.x, job.size.y, job.frames, job.warmup,
                        motion_name(job.motion), options_.reference_spp, options_.thumbnail, kCommit,
                        kBuildType, processor());
        return folder_ / "points" / (point.scene_name() + '-' + hex_hash(key));
    }

    // Without ending and AOV. `bounces` 0: all there are.
    fs::path reference(const std::string& scene, int bounces) const {
        std::string key = fmt::format("{:x} {}x{} {}", hashes_.at(scene), options_.job.size.x,
                                      options_.job.size.y, options_.reference_spp);
        for (const std::string& assignment : of_references(options_)) {
            key += ' ' + assignment;
        }
        return folder_ / "references" /
               fmt::format("{}-{}-{}", listed_scene(scene, {}).name,
                           bounces == 0 ? "all" : std::to_string(bounces), hex_hash(key));
    }
    TradeReferences references(const TradePoint& point, const SettingsSchema& schema) const {
        const std::string same = reference(point.scene, point.settings(schema).get<int>("gi.bounces"));
        const std::string all = reference(point.scene, 0);
        return {same + "-indirect.exr", all + "-indirect.exr", all + "-final.exr"};
    }

  private:
    const Options& options_;
    fs::path folder_;
    std::map<std::string, std::uint64_t> hashes_;
};

// As run_child(), for this program: its errors without the name that they start with.
ChildOutcome run_own(const std::vector<std::string>& arguments) {
    std::vector<std::string> command = {own_executable()};
    command.insert(command.end(), arguments.begin(), arguments.end());
    ChildOutcome outcome = run_child(command);
    constexpr std::string_view kName = "lanthorn: ";
    if (outcome.last_line.starts_with(kName)) {
        outcome.last_line.erase(0, kName.size());
    }
    return outcome;
}

// For a command that shows what `view` does; its time is given always.
std::vector<std::string> view_arguments(const SceneView& view) {
    std::vector<std::string> arguments = {"--time", fmt::format("{}", view.time.value_or(0))};
    if (!view.camera.empty()) {
        arguments.insert(arguments.end(), {"--camera", view.camera});
    }
    if (!view.animation.empty()) {
        arguments.insert(arguments.end(), {"--animation", view.animation});
    }
    if (!view.default_light) {
        arguments.emplace_back("--no-default-light");
    }
    if (!view.variant.empty()) {
        arguments.insert(arguments.end(), {"--variant", view.variant});
    }
    if (view.allow_outside) {
        arguments.emplace_back("--allow-outside");
    }
    if (!view.environment.empty()) {
        arguments.insert(arguments.end(), {"--environment", view.environment, "--environment-intensity",
                                           fmt::format("{}", view.environment_intensity)});
    }
    return arguments;
}

// Traces a reference unless it is there. An interrupted one is not kept.
void make_reference(const TradeFolder& folder, const Options& options, const std::string& scene, int bounces,
                    const StopSignal& stop) {
    const fs::path stem = folder.reference(scene, bounces);
    const ListedScene listed = listed_scene(scene, options.job.view);
    const std::vector<std::string> aovs =
        bounces == 0 ? std::vector<std::string>{"indirect", "final"} : std::vector<std::string>{"indirect"};
    if (std::ranges::all_of(
            aovs, [&](const std::string& aov) { return fs::exists(stem.string() + '-' + aov + ".exr"); })) {
        return;
    }
    for (const std::string& aov : aovs) {
        const std::string part = stem.string() + '-' + aov + ".part.exr";
        std::vector<std::string> command = {
            "render",
            listed.file,
            "-o",
            part,
            "--technique",
            "path",
            "--aov",
            aov,
            "--size",
            options.size,
            "--seed",
            std::to_string(kReferenceSeed),
            "--spp",
            std::to_string(options.reference_spp),
            "--set",
            bounces == 0 ? std::string("path.unlimited=true") : fmt::format("gi.bounces={}", bounces)};
        if (aov == "indirect") {
            command.insert(command.end(), {"--set", "path.transport=diffuse"});  // said on the chart
        }
        for (const std::string& assignment : of_references(options)) {
            command.insert(command.end(), {"--set", assignment});
        }
        const std::vector<std::string> view = view_arguments(listed.view);
        command.insert(command.end(), view.begin(), view.end());
        const ChildOutcome outcome = run_own(command);
        if (stop.asked() || !outcome.ok()) {
            std::error_code ignored;
            fs::remove(part, ignored);
        }
        if (stop.asked()) {
            return;
        }
        if (!outcome.ok()) {
            const int code = outcome.signal != 0 ? 1 : outcome.code;
            throw Error(static_cast<ExitCode>(code),
                        fmt::format("trade: reference of {}: {}", scene, outcome.why()));
        }
        const std::string whole = stem.string() + '-' + aov + ".exr";
        std::error_code error;
        fs::rename(part, whole, error);
        if (error) {
            throw InputError(whole, "", "cannot be written: " + error.message());
        }
    }
}

std::vector<std::string> point_command(const TradePoint& point, const Options& options,
                                       const TradeReferences& references, const fs::path& stem) {
    const TradeMeasurement& job = options.job;
    std::vector<std::string> command = {"trade-point",   point.scene, "--technique",
                                        point.technique, "--preset",  point.preset};
    const std::vector<std::string> view = view_arguments(job.view);
    command.insert(command.end(), view.begin(), view.end());
    const std::pair<const char*, int> numbers[] = {{"--width", job.size.x},
                                                   {"--height", job.size.y},
                                                   {"--frames", job.frames},
                                                   {"--warmup", job.warmup},
                                                   {"--thumbnail", options.thumbnail}};
    for (const auto& [name, number] : numbers) {
        command.insert(command.end(), {name, std::to_string(number)});
    }
    command.insert(command.end(), {"--motion", motion_name(job.motion), "--same", references.same, "--all",
                                   references.all, "--final", references.final, "-o", stem.string()});
    for (const auto* list : {&point.common, &point.assignments}) {
        for (const std::string& assignment : *list) {
            command.insert(command.end(), {"--set", assignment});
        }
    }
    return command;
}

TradeContext context_of(const Options& options, const std::vector<TradeResult>& results) {
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
    context.method = fmt::format(
        "{}; medians of {} frames after {}, {} in each", options.size, options.job.frames, options.job.warmup,
        options.job.motion == TradeMotion::light ? "under lights that move" : "a camera that walks 2 cm");
    context.reference = fmt::format(
        "references: path tracing, {}, {} samples a pixel, own relRMSE at most {:.2g}, its square taken off",
        transport_of_references(options), options.reference_spp, noise);
    return context;
}

void write_reports(const TradeFolder& folder, const Options& options, std::vector<TradeResult>& results) {
    const std::vector<bool> front = pareto_front(results, trade_measures().front().error);
    for (std::size_t i = 0; i < results.size(); ++i) {
        results[i].on_front = front[i];
    }
    const TradeContext context = context_of(options, results);
    write_file(folder.file("trade.csv"), trade_csv(results));
    write_file(folder.file("trade.svg"), trade_svg(results, context));
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

// Prints what to set; a wish that nothing keeps within fails the check.
ExitCode advise_by(const std::vector<ChartRow>& rows, const Options& options) {
    if (options.json) {
        fmt::print("{}\n", advice_json(rows, options.wishes).dump(2));
    } else if (options.markdown) {
        fmt::print("{}", advice_markdown(rows, options.wishes));
    } else {
        fmt::print("{}", advice_text(rows, options.wishes, scenes_of(rows).size() > 1));
    }
    const std::string missing = unmet(rows, options.wishes);
    if (!missing.empty()) {
        throw Error(ExitCode::check_failed, "trade: " + missing);
    }
    return ExitCode::ok;
}

ExitCode advise_from_chart(const Options& options) {
    if (!options.output.empty()) {
        throw InputError("trade: found --from and -o, expected one of them: a finished chart, or a new one");
    }
    if (!options.wishes.any()) {
        throw InputError("trade: found --from alone, expected --for-ms or --for-error with it");
    }
    const std::vector<ChartRow> rows = read_chart(options.from);
    return advise_by(options.sweep.scenes.empty() ? rows : of_scenes(rows, options.sweep.scenes), options);
}

ExitCode trade(Options options) {
    if (!options.from.empty()) {
        return advise_from_chart(options);
    }
    if (options.sweep.scenes.empty() || options.output.empty()) {
        throw InputError("trade: expected scenes and -o DIR, or --from with a finished chart");
    }
    SettingsSchema schema;
    declare_all_settings(schema);
    options.job.size = parse_size("--size", options.size, 1, kLargestPicture);
    for (const std::string& knob : options.knobs) {
        options.sweep.knobs.push_back(parse_knob(knob, schema));
    }
    const std::vector<TradePoint> points =
        with_seeds(sweep_points(options.sweep, schema), options.seeds, schema);
    const TradeFolder folder(options);

    const StopSignal stop;
    std::map<std::pair<std::string, int>, bool> references;
    std::vector<fs::path> stems;
    for (const TradePoint& point : points) {
        references[{point.scene, 0}] =
            references[{point.scene, point.settings(schema).get<int>("gi.bounces")}] = true;
        stems.push_back(folder.stem(point, schema));
    }
    Progress progress("measuring", references.size() + points.size());
    std::uint64_t done = 0;
    for (const auto& [reference, wanted] : references) {
        if (!stop.asked()) {
            make_reference(folder, options, reference.first, reference.second, stop);
        }
        progress.update(++done);
    }
    TradeRun run = run_points(
        points, stems,
        [&](const TradePoint& point, const fs::path& stem) {
            return run_own(point_command(point, options, folder.references(point, schema), stem));
        },
        [&](std::size_t n) { progress.update(done + n); }, [&] { return stop.asked(); });

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
    return options.wishes.any() ? advise_by(chart_rows(run.results), options) : ExitCode::ok;
}

void add_advice_options(CLI::App& command, Options& options) {
    command
        .add_option("--from", options.from,
                    "a finished chart, its folder or its CSV: measure nothing, advise from it")
        ->type_name("CHART");
    Wishes& wishes = options.wishes;
    command
        .add_option(
            "--for-ms", wishes.ms,
            "print what has the least error within so many milliseconds, separated by commas; exit code "
            "1 where nothing is as cheap")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(number_between(1e-3, 1e6));
    command
        .add_option("--for-error", wishes.errors,
                    "print what takes the least time up to such a relRMSE of indirect light, separated by "
                    "commas; exit code 1 where nothing is as good")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(number_between(1e-6, 1e6));
    command
        .add_option("--share", wishes.share,
                    "of the scenes in which that limit must hold: 1 is all of them, 0.75 three of four")
        ->check(number_between(1e-3, 1))
        ->capture_default_str();
    CLI::Option* markdown =
        command.add_flag("--markdown", options.markdown, "print that advice as a Markdown table");
    command.add_flag("--json", options.json, "print that advice as one JSON object")->excludes(markdown);
}

ExitCode measure_point(const PointOptions& options) {
    SettingsSchema schema;
    declare_all_settings(schema);
    TradeView view = view_point(options.point, options.job, schema);
    compare_with_references(view, options.references);
    write_image(options.stem + ".png", picture_of(view, options.references.same, options.thumbnail));
    write_file(options.stem + ".json", figures_json(view.figures));
    return ExitCode::ok;
}

}  // namespace

Command add_trade(CLI::App& app) {
    auto options = std::make_shared<Options>();
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
    command->add_option(
        "-o,--output", options->output,
        "folder for trade.csv, trade.svg, trade.html and, below it, what is finished: the same command "
        "again measures only what is missing");
    add_advice_options(*command, *options);
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
    command
        ->add_option(
            "--set", sweep.common,
            "KEY=VALUE, repeatable: a setting of every point; those of path (path.transport=full) of "
            "the references too")
        ->allow_extra_args(false);
    command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    add_camera_option(*command, options->job.view.camera);
    add_moment_options(*command, options->job.view, "that is shown, standing still (default: 0)");
    add_motion_option(*command, options->job.motion);
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
    add_motion_option(*command, options->job.motion);
    add_moment_options(*command, options->job.view, "");
    command->add_option("--set", options->point.assignments)->allow_extra_args(false);
    return [options] { return measure_point(*options); };
}

}  // namespace lanthorn::tools

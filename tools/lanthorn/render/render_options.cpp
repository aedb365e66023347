#include "tools/lanthorn/render/render_options.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <string_view>
#include <utility>

#include "engine/core/json.h"
#include "lanthorn/core/error.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/workbench/load_scene.h"
#include "tools/lanthorn/farm/farm_options.h"

namespace lanthorn::tools {

void add_render_options(CLI::App& command, RenderOptions& options) {
    add_scene_option(command, options.scene);
    command.add_option("-o,--output", options.output, "image to write (.exr, .png, .hdr, .tif, .jpg, ...)");
    command.add_option(
        "--technique", options.technique,
        fmt::format("indirect light: one of {} (gi.technique; default: emc); path is the reference",
                    fmt::join(gi::technique_names(), ", ")));
    command.add_option("--size", options.size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    add_camera_option(command, options.job.view.camera);
    command.add_option(
        "--pose", options.pose,
        "X,Y,Z,YAW,PITCH[,FOV]: look from there instead (metres; degrees: 0,0 along -Z, 90,0 along "
        "-X; 60 high); a default light stays where --camera has it");
    add_moment_options(command, options.job.view, "that the last frame shows (default: frames / 60)");
    command.add_option("--box", options.box,
                       "X,Y,Z,SIDE: put an upright grey box into the scene, its middle and its length in "
                       "metres; where trade --motion box ends");
    command
        .add_option("--frames", options.frames,
                    "frames to measure; the last is written (default: 1). With --turntable: pictures of the "
                    "turn, 2 to 1000 (default: 48)")
        ->check(CLI::Range(1, 1000000));
    command
        .add_option("--turntable", options.turntable,
                    "animated WebP to write instead of an image: the camera goes once round the scene, from "
                    "where it would stand without this")
        ->type_name("FILE.webp");
    command
        .add_option("--warmup", options.job.warmup,
                    "frames to render before, not measured; with --turntable: before each picture")
        ->check(CLI::Range(0, 1000000))
        ->capture_default_str();
    command
        .add_option("--aov", options.aovs,
                    "what to write, repeatable: final (default), indirect (irradiance, lux), direct and "
                    "radiance (nits), "
                    "albedo, normal, depth (metres), or a debug view of the technique (--list-aovs)")
        ->allow_extra_args(false);
    add_settings_options(command, options.settings);
    command.add_option("--seed", options.seed, "seed of the photons (gi.seed)");
    command.add_option("--spp", options.spp, "path: samples a pixel at most (path.spp)");
    command.add_option("--time-limit", options.time_limit, "path: seconds at most (path.time_limit)");
    command.add_option("--target-noise", options.target_noise,
                       "path: stop once the image's own relative noise is below this (path.target_noise)");
    command.add_option("--checkpoint", options.checkpoint,
                       "path: file to continue from if it is there, kept up to date and left behind");
    command
        .add_option("--budget-ms", options.job.budget.ms,
                    "milliseconds that a frame may take: settings, then pixels are spared to keep it; exit "
                    "code 1 where "
                    "the last frames do not")
        ->check(number_between(1e-6, 1e9));
    command
        .add_option("--target-error", options.job.budget.error,
                    "indirect relRMSE, as it is estimated, that suffices; with --budget-ms time comes first")
        ->check(number_between(1e-6, 1e6));
    command.add_flag("--budget-processor", options.job.budget.processor,
                     "--budget-ms is of processor time of all threads, which other programs hardly alter");
    command.add_option("--play-budget", options.play_budget,
                       "decide as a run before did, by the file that it wrote with --stats");
    add_farm_options(command, options.pieces.farm);
    command
        .add_option("--pieces", options.pieces.pieces,
                    "path: in how many pieces at least other processes trace it (default: 16)")
        ->check(CLI::Range(1, 1'000'000));
    command.add_option("--piece", options.pieces.piece)->group("");
    command.add_option("--stats", options.stats, "write times, photons, plan and memory as JSON");
    command.add_option("--trace", options.trace, "write the passes' times for chrome://tracing");
    command.add_flag("--list-aovs", options.list_aovs, "print the debug views of each technique");
    command.add_flag("--list-settings", options.list_settings,
                     "print every setting with type, unit, range, default and cost");
    command.add_flag("--print-schedule", options.print_schedule,
                     "print the systems of a step and of a frame, and why they are in that order (Graphviz)");
}

void configure(Settings& settings, const RenderOptions& options) {
    options.settings.apply_to(settings);
    if (!options.technique.empty()) {
        settings.set_from_text("gi.technique", options.technique);
    }
    if (options.seed) {
        settings.set<int>("gi.seed", *options.seed);
    }
    if (options.spp) {
        settings.set<int>("path.spp", *options.spp);
    }
    if (options.time_limit) {
        settings.set<float>("path.time_limit", *options.time_limit);
    }
    if (options.target_noise) {
        settings.set<float>("path.target_noise", *options.target_noise);
    }
}

const gi::TechniqueEntry& technique_of(const Settings& settings) {
    return gi::technique_entry(gi::gi_settings(settings).technique);
}

void check_path_options(const RenderOptions& options, bool path) {
    const std::pair<bool, const char*> given[] = {{options.spp.has_value(), "--spp"},
                                                  {options.time_limit.has_value(), "--time-limit"},
                                                  {options.target_noise.has_value(), "--target-noise"},
                                                  {!options.checkpoint.empty(), "--checkpoint"}};
    for (const auto& [is_given, name] : given) {
        if (is_given && !path) {
            throw InputError(fmt::format("{}: expected --technique path with it", name));
        }
        if (is_given && !options.job.debug_views.empty() && std::string_view(name) != "--spp") {
            throw InputError(fmt::format("{}: expected no --aov {} with it: debug views are of frames", name,
                                         options.job.debug_views.front()));
        }
    }
}

void check_budget(const RenderOptions& options, bool path) {
    if (options.job.budget.any() && path) {
        throw InputError(
            "--budget-ms, --target-error, --play-budget: found --technique path, expected one that makes "
            "frames; "
            "it has --time-limit and --target-noise");
    }
}

void check_pieces(const RenderOptions& options, const Settings& settings, bool path) {
    if (options.pieces.pieces && !options.pieces.by_others()) {
        throw InputError("--pieces: expected --executor or --jobs with it");
    }
    if (!options.pieces.by_others() && options.pieces.piece.empty()) {
        return;
    }
    if (!path || !options.job.debug_views.empty()) {
        throw InputError("--executor, --jobs: expected --technique path with it, and no debug views");
    }
    if (!options.checkpoint.empty() || settings.get<float>("path.time_limit") > 0 ||
        settings.get<float>("path.target_noise") > 0) {
        throw InputError(
            "--executor, --jobs: found a checkpoint, a time limit or a target noise, expected a number of "
            "samples alone (--spp)");
    }
}

void check_turntable_alone(const RenderOptions& options, bool path) {
    const std::pair<bool, const char*> others[] = {
        {!options.output.empty(), "-o"},
        {!options.aovs.empty(), "--aov"},
        {!options.stats.empty(), "--stats"},
        {!options.trace.empty(), "--trace"},
        {!options.checkpoint.empty(), "--checkpoint"},
        {options.job.budget.any() || !options.play_budget.empty(), "a budget"},
        {path, "--technique path"}};
    for (const auto& [is_given, name] : others) {
        if (is_given) {
            throw InputError(fmt::format("--turntable: found {} beside it, expected none", name));
        }
    }
}

PieceCommand piece_command(const RenderOptions& options, const Settings& settings) {
    SceneView view = options.job.view;
    if (!view.environment.empty()) {
        view.environment = std::filesystem::absolute(view.environment).string();
    }
    PieceCommand command{{std::filesystem::absolute(options.scene).string(), "--size", options.size},
                         settings.to_json()};
    const std::vector<std::string> shown = view_arguments(view, shown_time(options.job));
    command.arguments.insert(command.arguments.end(), shown.begin(), shown.end());
    if (!options.pose.empty()) {
        command.arguments.insert(command.arguments.end(), {"--pose", options.pose});
    }
    for (const std::string& aov : options.aovs) {
        command.arguments.insert(command.arguments.end(), {"--aov", aov});
    }
    return command;
}

void read_budget(BudgetWish& wish, const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) {
        throw InputError(file, "", "cannot be read, expected what --stats writes with --budget-ms");
    }
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const nlohmann::json root = parse_json(text, file);
    try {
        for (const auto& step : root.at("budget").at("steps")) {
            wish.played.emplace_back(step.at("frame").get<std::int64_t>(), step.at("to").get<std::size_t>());
        }
    } catch (const nlohmann::json::exception&) {
        throw InputError(file, "budget.steps", "found none, expected what --stats writes with --budget-ms");
    }
    if (wish.played.empty()) {
        wish.played.emplace_back(0, 0);  // nothing was decided
    }
}

}  // namespace lanthorn::tools

// lanthorn render SCENE -o IMG: a scene's picture, its parts (AOVs) and what they cost.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>

#include "engine/core/json.h"
#include "lanthorn/assets/image_io.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/choice.h"
#include "lanthorn/core/progress.h"
#include "lanthorn/core/stop_signal.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/workbench/all_settings.h"
#include "lanthorn/workbench/load_scene.h"
#include "lanthorn/workbench/path_job.h"
#include "lanthorn/workbench/render_job.h"
#include "tools/lanthorn/commands.h"
#include "tools/lanthorn/common/common_options.h"
#include "tools/lanthorn/common/warnings.h"
#include "tools/lanthorn/common/workbench.h"
#include "tools/lanthorn/farm/farm_options.h"
#include "tools/lanthorn/render/debug_views.h"
#include "tools/lanthorn/render/outputs.h"
#include "tools/lanthorn/render/path_pieces.h"
#include "tools/lanthorn/render/render_stats.h"
#include "tools/lanthorn/render/turntable.h"
#include "tools/workbench/scene/stopping.h"

namespace lanthorn::tools {

namespace {

struct RenderOptions {
    std::string scene, output, technique, pose, box, size = "512x512", stats, trace, checkpoint, turntable;
    std::vector<std::string> aovs;
    SettingsChoice settings;
    std::optional<int> seed, spp, frames;
    std::optional<float> time_limit, target_noise;
    std::string play_budget;
    RenderJob job;
    PieceChoice pieces;
    bool list_settings = false, list_aovs = false, print_schedule = false;
};

// The path tracer's options need it.
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

// A picture of pieces has a number of samples, and what is added up needs all of them.
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

// What other processes are told of this one's picture.
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

void check_budget(const RenderOptions& options, bool path) {
    if (options.job.budget.any() && path) {
        throw InputError(
            "--budget-ms, --target-error, --play-budget: found --technique path, expected one that makes "
            "frames; "
            "it has --time-limit and --target-noise");
    }
}

// Later wins: preset, file, --set, the options of their own.
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

// What of the scene's light a picture leaves out, if it does so unasked.
void tell_transport(const RenderOutcome& outcome, const Settings& settings) {
    const gi::TechniqueEntry& technique = technique_of(settings);
    const bool endless =
        technique.is_reference || (technique.name == "emc" && settings.get<bool>("gi.gather.endless") &&
                                   settings.text("gi.emc.final") == "gather");
    if (!endless && outcome.gi.plan.bounces > 0) {
        fmt::print("{}: light of {} bounces at most, as gi.bounces says; emc and path show all by default\n",
                   technique.name, outcome.gi.plan.bounces);
    }
    for (const ImageF& image : outcome.images) {
        const auto transport = image.metadata.find("transport");
        if (transport != image.metadata.end() && transport->second != settings.text("path.transport") &&
            transport->second == "diffuse") {
            fmt::print(
                "path: diffuse transport, {} bounces, as irradiance is measured; path.transport=full is "
                "all\n",
                image.metadata.at("bounces") == "unlimited" ? "all" : image.metadata.at("bounces"));
            return;
        }
    }
}

// Decisions that a run before wrote with --stats.
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

// A turntable is a file of its own, of frames.
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

// The scene as it is shown: with the camera of --pose, if there is one.
SceneData scene_of(const RenderOptions& options, SceneView& view) {
    const std::optional<CameraPose> pose =
        options.pose.empty() ? std::nullopt : std::optional(pose_of(options.pose));
    SceneData scene = tell_warnings(options.scene, load_scene(options.scene, view));
    if (pose) {
        view.camera = add_pose_camera(scene, *pose);
    }
    return scene;
}

// A piece is no picture: sums, in the file that -o names.
ExitCode render_piece(const RenderOptions& options, const Settings& settings) {
    RenderJob job = options.job;
    const reference::PathPiece piece =
        parse_piece(options.pieces.piece, job.size, settings.get<int>("path.spp"));
    const StopSignal stop;
    SceneData scene = scene_of(options, job.view);
    path_trace_piece(std::move(scene), settings, job, piece, options.output, [](double) {});
    return ExitCode::ok;
}

ExitCode turn(const RenderOptions& options, const Settings& settings) {
    TurntableJob job;
    job.size = options.job.size;
    job.view = options.job.view;
    job.pictures = options.frames.value_or(kTurntablePictures);
    job.warmup = options.job.warmup;
    check_turntable_alone(options, technique_of(settings).is_reference);
    check_path_options(options, false);
    check_turntable(options.turntable, job);
    const StopSignal stop;
    SceneData scene = scene_of(options, job.view);
    write_turntable(options.turntable, std::move(scene), settings, job);
    return ExitCode::ok;
}

RenderOutcome render_with(const RenderOptions& options, SceneData scene, const Settings& settings,
                          const PieceCommand& command) {
    const RenderJob& job = options.job;
    if (options.pieces.by_others()) {
        return path_trace_scene(std::move(scene), settings, job, [&](reference::PathTracer& tracer) {
            trace_in_pieces(tracer, job.size, settings.get<int>("path.spp"), command, options.pieces,
                            options.output + ".pieces");
        });
    }
    if (technique_of(settings).is_reference && job.debug_views.empty()) {
        constexpr double kSteps = 1e4;
        Progress progress("tracing paths", static_cast<std::uint64_t>(kSteps));
        return path_trace_scene(std::move(scene), settings, job, options.checkpoint, [&](double share) {
            progress.update(static_cast<std::uint64_t>(kSteps * share));
        });
    }
    Progress progress("rendering", static_cast<std::uint64_t>(job.warmup + job.frames));
    return render_scene(std::move(scene), settings, job,
                        [&](int done) { progress.update(static_cast<std::uint64_t>(done)); });
}

ExitCode render(RenderOptions options) {
    SettingsSchema schema;
    declare_all_settings(schema);
    if (options.list_settings) {
        fmt::print("{}", schema.list_text());
        return ExitCode::ok;
    }
    if (options.print_schedule) {
        App app;
        add_scene_plugins(app);
        gi::add_picture_plugins(app, Settings(schema));
        fmt::print("{}", app.schedule_dot());
        return ExitCode::ok;
    }
    if (options.list_aovs) {
        fmt::print("{}", list_debug_views());
        return ExitCode::ok;
    }
    if (options.scene.empty() || (options.output.empty() && options.turntable.empty())) {
        throw InputError(options.scene.empty()
                             ? "render: no scene given, expected SCENE -o IMG"
                             : "render: no output given, expected -o IMG or --turntable FILE.webp");
    }
    Settings settings(schema);
    configure(settings, options);
    RenderJob& job = options.job;
    job.size = parse_size("--size", options.size, 1, kLargestPicture);
    if (!options.box.empty()) {
        job.view.box = box_of(options.box);
    }
    if (!options.turntable.empty()) {
        return turn(options, settings);
    }
    job.frames = options.frames.value_or(1);
    if (options.aovs.empty()) {
        options.aovs = {"final"};
    }
    if (!options.play_budget.empty()) {
        read_budget(job.budget, options.play_budget);
    }
    job.timing = !options.stats.empty() || !options.trace.empty() || job.budget.any();
    const bool is_piece = !options.pieces.piece.empty();
    std::vector<Output> outputs =
        plan_outputs(options.aovs, is_piece ? "piece.exr" : options.output, technique_of(settings));
    std::stable_partition(outputs.begin(), outputs.end(), [](const Output& o) { return o.kind != nullptr; });
    job.aovs.clear();
    for (const Output& output : outputs) {
        if (output.kind != nullptr) {
            job.aovs.push_back(output.kind->aov);
        } else {
            job.debug_views.push_back(output.view->name);
        }
    }
    check_path_options(options, technique_of(settings).is_reference);
    check_budget(options, technique_of(settings).is_reference);
    check_pieces(options, settings, technique_of(settings).is_reference);
    if (is_piece) {
        return render_piece(options, settings);
    }
    for (const std::string& path : {options.stats, options.trace, options.checkpoint}) {
        if (!path.empty()) {
            check_writable(path);
        }
    }

    const StopSignal stop;
    const auto start = std::chrono::steady_clock::now();
    const PieceCommand command = piece_command(options, settings);  // before the pose's camera is in the view
    SceneData scene = scene_of(options, job.view);
    const std::chrono::duration<double, std::milli> load = std::chrono::steady_clock::now() - start;
    stop_if_asked("render", "nothing is written");
    RenderOutcome outcome = render_with(options, std::move(scene), settings, command);
    const std::string stats = stats_json(outcome, job, settings, options.settings.preset, load.count());
    tell_transport(outcome, settings);
    // A file that cannot be written takes no other with it: hours may lie in them.
    std::optional<Error> failure = outcome.checkpoint_failure;
    const auto attempt = [&failure](const auto& write) {
        try {
            write();
        } catch (const InputError& error) {
            failure = failure ? failure : error;
        }
    };
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        ImageF image = encode(std::move(outcome.images[i]), outputs[i]);
        if (outcome.interrupted) {
            image.metadata["unfinished"] = fmt::format("stopped by {}", StopSignal::name());
        }
        attempt([&] { write_image(outputs[i].path, image); });
    }
    if (!options.stats.empty()) {
        attempt([&] { write_file(options.stats, stats); });
    }
    if (!options.trace.empty()) {
        attempt([&] { write_file(options.trace, trace_json(outcome)); });
    }
    if (failure) {
        throw *failure;
    }
    if (outcome.nan_count > 0) {
        fmt::print(stderr, "lanthorn: warning: {} values were NaN or infinite and became 0\n",
                   outcome.nan_count);
    }
    if (job.budget.any()) {
        fmt::print("budget: {}\n", outcome.budget.verdict);
    }
    if (outcome.interrupted) {
        fmt::print(
            stderr,
            "lanthorn: warning: stopped by {}; what was done until then is written, marked as unfinished\n",
            StopSignal::name());
    }
    return outcome.interrupted     ? static_cast<ExitCode>(StopSignal::exit_code())
           : !outcome.budget.holds ? ExitCode::check_failed
                                   : ExitCode::ok;
}

}  // namespace

Command add_render(CLI::App& app) {
    auto options = std::make_shared<RenderOptions>();
    CLI::App* command = app.add_subcommand("render", "Render a scene to an image.");
    add_scene_option(*command, options->scene);
    command->add_option("-o,--output", options->output, "image to write (.exr, .png, .hdr, .tif, .jpg, ...)");
    command->add_option(
        "--technique", options->technique,
        fmt::format("indirect light: one of {} (gi.technique; default: emc); path is the reference",
                    fmt::join(gi::technique_names(), ", ")));
    command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    add_camera_option(*command, options->job.view.camera);
    command->add_option(
        "--pose", options->pose,
        "X,Y,Z,YAW,PITCH[,FOV]: look from there instead (metres; degrees: 0,0 along -Z, 90,0 along "
        "-X; 60 high); a default light stays where --camera has it");
    add_moment_options(*command, options->job.view, "that the last frame shows (default: frames / 60)");
    command->add_option("--box", options->box,
                        "X,Y,Z,SIDE: put an upright grey box into the scene, its middle and its length in "
                        "metres; where trade --motion box ends");
    command
        ->add_option("--frames", options->frames,
                     "frames to measure; the last is written (default: 1). With --turntable: pictures of the "
                     "turn, 2 to 1000 (default: 48)")
        ->check(CLI::Range(1, 1000000));
    command
        ->add_option("--turntable", options->turntable,
                     "animated WebP to write instead of an image: the camera goes once round the scene, from "
                     "where it would stand without this")
        ->type_name("FILE.webp");
    command
        ->add_option("--warmup", options->job.warmup,
                     "frames to render before, not measured; with --turntable: before each picture")
        ->check(CLI::Range(0, 1000000))
        ->capture_default_str();
    command
        ->add_option("--aov", options->aovs,
                     "what to write, repeatable: final (default), indirect (irradiance, lux), direct and "
                     "radiance (nits), "
                     "albedo, normal, depth (metres), or a debug view of the technique (--list-aovs)")
        ->allow_extra_args(false);
    add_settings_options(*command, options->settings);
    command->add_option("--seed", options->seed, "seed of the photons (gi.seed)");
    command->add_option("--spp", options->spp, "path: samples a pixel at most (path.spp)");
    command->add_option("--time-limit", options->time_limit, "path: seconds at most (path.time_limit)");
    command->add_option("--target-noise", options->target_noise,
                        "path: stop once the image's own relative noise is below this (path.target_noise)");
    command->add_option("--checkpoint", options->checkpoint,
                        "path: file to continue from if it is there, kept up to date and left behind");
    command
        ->add_option("--budget-ms", options->job.budget.ms,
                     "milliseconds that a frame may take: settings, then pixels are spared to keep it; exit "
                     "code 1 where "
                     "the last frames do not")
        ->check(number_between(1e-6, 1e9));
    command
        ->add_option("--target-error", options->job.budget.error,
                     "indirect relRMSE, as it is estimated, that suffices; with --budget-ms time comes first")
        ->check(number_between(1e-6, 1e6));
    command->add_flag("--budget-processor", options->job.budget.processor,
                      "--budget-ms is of processor time of all threads, which other programs hardly alter");
    command->add_option("--play-budget", options->play_budget,
                        "decide as a run before did, by the file that it wrote with --stats");
    add_farm_options(*command, options->pieces.farm);
    command
        ->add_option("--pieces", options->pieces.pieces,
                     "path: in how many pieces at least other processes trace it (default: 16)")
        ->check(CLI::Range(1, 1'000'000));
    command->add_option("--piece", options->pieces.piece)->group("");
    command->add_option("--stats", options->stats, "write times, photons, plan and memory as JSON");
    command->add_option("--trace", options->trace, "write the passes' times for chrome://tracing");
    command->add_flag("--list-aovs", options->list_aovs, "print the debug views of each technique");
    command->add_flag("--list-settings", options->list_settings,
                      "print every setting with type, unit, range, default and cost");
    command->add_flag(
        "--print-schedule", options->print_schedule,
        "print the systems of a step and of a frame, and why they are in that order (Graphviz)");
    return [options] { return render(*options); };
}

}  // namespace lanthorn::tools

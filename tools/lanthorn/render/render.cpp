// lanthorn render SCENE -o IMG: a scene's picture, its parts (AOVs) and what they cost.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

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
#include "tools/lanthorn/render/render_options.h"
#include "tools/lanthorn/render/render_stats.h"
#include "tools/lanthorn/render/turntable.h"
#include "tools/workbench/scene/stopping.h"

namespace lanthorn::tools {

namespace {

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

// The lists that are asked for instead of a picture.
bool print_list(const RenderOptions& options, const SettingsSchema& schema) {
    if (options.list_settings) {
        fmt::print("{}", schema.list_text());
    } else if (options.print_schedule) {
        App app;
        add_scene_plugins(app);
        gi::add_picture_plugins(app, Settings(schema));
        fmt::print("{}", app.schedule_dot());
    } else if (options.list_aovs) {
        fmt::print("{}", list_debug_views());
    } else {
        return false;
    }
    return true;
}

// What to write, in the order in which the job makes it: AOVs, then debug views.
std::vector<Output> plan_job(RenderJob& job, const RenderOptions& options,
                             const gi::TechniqueEntry& technique) {
    job.frames = options.frames.value_or(1);
    if (!options.play_budget.empty()) {
        read_budget(job.budget, options.play_budget);
    }
    job.timing = !options.stats.empty() || !options.trace.empty() || job.budget.any();
    const std::vector<std::string> aovs =
        options.aovs.empty() ? std::vector<std::string>{"final"} : options.aovs;
    std::vector<Output> outputs =
        plan_outputs(aovs, options.pieces.piece.empty() ? options.output : "piece.exr", technique);
    std::stable_partition(outputs.begin(), outputs.end(), [](const Output& o) { return o.kind != nullptr; });
    job.aovs.clear();
    for (const Output& output : outputs) {
        if (output.kind != nullptr) {
            job.aovs.push_back(output.kind->aov);
        } else {
            job.debug_views.push_back(output.view->name);
        }
    }
    return outputs;
}

// A file that cannot be written takes no other with it: hours may lie in them. Throws then what was wrong
// with the first.
void write_outcome(RenderOutcome& outcome, const std::vector<Output>& outputs, const RenderOptions& options,
                   const std::string& stats) {
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
}

// What is wrong with a picture that has been written, and whether its budget was kept.
ExitCode tell_outcome(const RenderOutcome& outcome, const RenderJob& job) {
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
        return static_cast<ExitCode>(StopSignal::exit_code());
    }
    return outcome.budget.holds ? ExitCode::ok : ExitCode::check_failed;
}

ExitCode render(RenderOptions options) {
    SettingsSchema schema;
    declare_all_settings(schema);
    if (print_list(options, schema)) {
        return ExitCode::ok;
    }
    if (options.scene.empty() || (options.output.empty() && options.turntable.empty())) {
        throw InputError(options.scene.empty()
                             ? "render: no scene given, expected SCENE -o IMG"
                             : "render: no output given, expected -o IMG or --turntable FILE.webp");
    }
    Settings settings(schema);
    configure(settings, options);
    const gi::TechniqueEntry& technique = technique_of(settings);
    RenderJob& job = options.job;
    job.size = parse_size("--size", options.size, 1, kLargestPicture);
    if (!options.box.empty()) {
        job.view.box = box_of(options.box);
    }
    if (!options.turntable.empty()) {
        return turn(options, settings);
    }
    const std::vector<Output> outputs = plan_job(job, options, technique);
    check_path_options(options, technique.is_reference);
    check_budget(options, technique.is_reference);
    check_pieces(options, settings, technique.is_reference);
    if (!options.pieces.piece.empty()) {
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
    write_outcome(outcome, outputs, options, stats);
    return tell_outcome(outcome, job);
}

}  // namespace

Command add_render(CLI::App& app) {
    auto options = std::make_shared<RenderOptions>();
    add_render_options(*app.add_subcommand("render", "Render a scene to an image."), *options);
    return [options] { return render(*options); };
}

}  // namespace lanthorn::tools

// lanthorn measure frames SCENE...: what frames cost while something moves, from frame to frame and by pass.
#include "tools/lanthorn/measure/frames_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "lanthorn/core/choice.h"
#include "lanthorn/core/progress.h"
#include "lanthorn/core/stop_signal.h"
#include "lanthorn/workbench/all_settings.h"
#include "lanthorn/workbench/load_scene.h"
#include "tools/lanthorn/common/common_options.h"
#include "tools/lanthorn/common/text_table.h"
#include "tools/lanthorn/common/warnings.h"
#include "tools/lanthorn/measure/frame_times.h"
#include "tools/workbench/scene/stopping.h"

namespace lanthorn::tools {

namespace {

const std::vector<std::string> kMotionsOfFrames = {"rest", "lamp", "walk", "pan", "box", "figure"};
constexpr double kNamedMs = 0.005;  // a pass that takes less is not printed

struct Options {
    std::vector<std::string> scenes, motions = kMotionsOfFrames;
    SettingsChoice settings;
    SceneView view;
    FramesJob job;
    std::string size = "1920x1080";
    bool json = false;
};

struct MeasuredScene {
    std::string name;
    std::vector<FrameTimes> motions;
};

std::string name_of(Motion motion) {
    return std::string(kMotionNames[static_cast<std::size_t>(motion)]);
}

void print_table(const MeasuredScene& scene) {
    TextTable frames({scene.name, "frames/s", "median ms", "p95 ms", "passes ms", "processor ms"});
    std::vector<std::string> heading = {"pass, ms"};
    std::map<std::string, std::vector<std::string>> passes;
    for (const FrameTimes& times : scene.motions) {
        if (!times.lacking.empty()) {
            frames.add({name_of(times.motion), times.lacking, "-", "-", "-", "-"});
            continue;
        }
        frames.add({name_of(times.motion), fmt::format("{:.1f}", times.fps()),
                    fmt::format("{:.2f}", times.median), fmt::format("{:.2f}", times.p95),
                    fmt::format("{:.2f}", times.gpu), fmt::format("{:.2f}", times.processor)});
        for (const auto& [name, ms] : times.passes) {
            if (ms >= kNamedMs) {
                auto& cells = passes[name];
                cells.resize(heading.size() - 1, "-");
                cells.push_back(fmt::format("{:.2f}", ms));
            }
        }
        heading.push_back(name_of(times.motion));
    }
    TextTable table(heading);
    for (auto& [name, cells] : passes) {
        cells.resize(heading.size() - 1, "-");
        cells.insert(cells.begin(), name);
        table.add(cells);
    }
    fmt::print("{}\n{}\n", frames.text(), table.text());
    std::fflush(stdout);
}

nlohmann::ordered_json scene_json(const MeasuredScene& scene) {
    nlohmann::ordered_json motions = nlohmann::ordered_json::array();
    for (const FrameTimes& times : scene.motions) {
        if (!times.lacking.empty()) {
            motions.push_back({{"motion", name_of(times.motion)}, {"lacking", times.lacking}});
            continue;
        }
        motions.push_back({{"motion", name_of(times.motion)},
                           {"fps", times.fps()},
                           {"ms", {{"median", times.median}, {"p95", times.p95}}},
                           {"passes_ms", times.gpu},
                           {"processor_ms", times.processor},
                           {"passes", times.passes},
                           {"nan_count", times.nan_count}});
    }
    return {{"scene", scene.name}, {"motions", std::move(motions)}};
}

Motion motion_of(const std::string& name) {
    return static_cast<Motion>(std::ranges::find(kMotionNames, name) - kMotionNames.begin());
}

ExitCode run(const Options& options) {
    SettingsSchema schema;
    declare_all_settings(schema);
    Settings settings(schema);
    options.settings.apply_to(settings);
    FramesJob job = options.job;
    job.size = parse_size("--size", options.size, 1, kLargestPicture);

    Progress progress("measuring", options.scenes.size() * options.motions.size());
    std::uint64_t done = 0;
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    std::string renderer;
    const StopSignal stop;
    std::optional<Stopped> stopped;
    for (const std::string& text : options.scenes) {
        const ListedScene listed = listed_scene(text, options.view);
        const SceneData data = tell_warnings(listed.file, load_scene(listed.file, listed.view));
        MeasuredScene scene{listed.name, {}};
        try {
            for (const std::string& motion : options.motions) {
                scene.motions.push_back(measure_frames(data, listed.view, motion_of(motion), settings, job));
                renderer = scene.motions.back().lacking.empty() ? scene.motions.back().renderer : renderer;
                progress.update(++done);
                stop_if_asked("measure", "what was measured until then is printed");
            }
        } catch (const Stopped& signal) {
            stopped = signal;
        }
        if (options.json) {
            list.push_back(scene_json(scene));
        } else {
            print_table(scene);
        }
        if (stopped) {
            break;
        }
    }
    if (options.json) {
        const nlohmann::ordered_json root{{"measure", "frames"},         {"size", {job.size.x, job.size.y}},
                                          {"frames", job.frames},        {"warmup", job.warmup},
                                          {"renderer", renderer},        {"preset", options.settings.preset},
                                          {"set", options.settings.set}, {"scenes", std::move(list)}};
        fmt::print("{}\n", root.dump(2));
    } else {
        fmt::print("{}, {} frames of {}x{}.\n", renderer, job.frames, job.size.x, job.size.y);
    }
    if (stopped) {
        throw *stopped;
    }
    return ExitCode::ok;
}

}  // namespace

Command add_measure_frames(CLI::App& measure) {
    auto options = std::make_shared<Options>();
    CLI::App* command = measure.add_subcommand(
        "frames",
        "What frames cost on this machine while something moves: from frame to frame, and by pass.");
    command
        ->add_option("SCENE", options->scenes,
                     "glTF 2.0 files (.gltf, .glb), FILE@CAMERA for one of its cameras")
        ->required();
    command
        ->add_option("--motion", options->motions,
                     "rest, lamp, walk, pan, box, figure (default: all), separated by commas")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember(kMotionsOfFrames));
    command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command->add_option("--frames", options->job.frames, "that are measured")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command->add_option("--warmup", options->job.warmup, "frames of the motion before")
        ->check(CLI::Range(0, 100000))
        ->capture_default_str();
    add_camera_option(*command, options->view.camera);
    add_moment_options(*command, options->view, "at which all stands but what moves (default: 0)");
    add_settings_options(*command, options->settings);
    command->add_flag("--json", options->json, "print one JSON object");
    return [options] { return run(*options); };
}

}  // namespace lanthorn::tools

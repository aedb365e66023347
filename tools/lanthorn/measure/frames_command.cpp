// lanthorn measure frames SCENE...: what frames cost while something moves, from frame to frame and by pass.
#include "tools/lanthorn/measure/frames_command.h"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "lanthorn/core/choice.h"
#include "tools/lanthorn/common/common_options.h"
#include "tools/lanthorn/common/text_table.h"
#include "tools/lanthorn/measure/frame_times.h"
#include "tools/lanthorn/measure/scene_list.h"
#include "tools/workbench/scene/stopping.h"

namespace lanthorn::tools {

namespace {

const std::vector<std::string> kMotionsOfFrames = {"rest", "lamp", "walk", "pan", "box", "figure"};
constexpr double kNamedMs = 0.005;  // a pass that takes less is not printed

struct FramesOptions {
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

ExitCode run(const FramesOptions& options) {
    const ChosenSettings chosen(options.settings);
    FramesJob job = options.job;
    job.size = parse_size("--size", options.size, 1, kLargestPicture);

    const std::vector<Motion> motions = motions_named(options.motions);

    MeasuredSteps work("measure", "what was measured until then is printed",
                       options.scenes.size() * motions.size());
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    std::string renderer;
    for (const std::string& text : options.scenes) {
        const MotionScene scene = open_scene(text, options.view);
        MeasuredScene measured{scene.name, {}};
        const bool whole = work.part([&] {
            for (const Motion motion : motions) {
                measured.motions.push_back(
                    measure_frames(scene.data, scene.view, motion, chosen.settings, job));
                const FrameTimes& times = measured.motions.back();
                renderer = times.lacking.empty() ? times.renderer : renderer;
                work.step();
            }
        });
        if (options.json) {
            list.push_back(scene_json(measured));
        } else {
            print_table(measured);
        }
        if (!whole) {
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
    work.finish();
    return ExitCode::ok;
}

}  // namespace

Command add_measure_frames(CLI::App& measure) {
    auto options = std::make_shared<FramesOptions>();
    CLI::App* command = measure.add_subcommand(
        "frames",
        "What frames cost on this machine while something moves: from frame to frame, and by pass.");
    add_scenes_option(*command, options->scenes);
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

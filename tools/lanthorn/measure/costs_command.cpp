// lanthorn measure costs SCENE... -o DIR: where each millisecond and megabyte goes.
#include "tools/lanthorn/measure/costs_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "engine/build_info/build_info.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/choice.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/gi/technique.h"
#include "lanthorn/workbench/load_scene.h"
#include "tools/lanthorn/common/common_options.h"
#include "tools/lanthorn/measure/costs_report.h"
#include "tools/lanthorn/measure/scene_list.h"
#include "tools/workbench/scene/stopping.h"

namespace lanthorn::tools {

namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kMotionsOfCosts = {"rest", "lamp", "dim", "walk", "pan", "box", "figure"};

struct CostsOptions {
    std::vector<std::string> scenes, motions;
    std::string technique, output, size = "512x512";
    SettingsChoice settings;
    SceneView view;
    CostsJob job;
    bool json = false;
};

// Rest first, each once.
std::vector<Motion> motions_of(const CostsOptions& options) {
    std::vector<Motion> motions = {Motion::rest};
    for (const Motion motion : motions_named(options.motions)) {
        if (std::ranges::find(motions, motion) == motions.end()) {
            motions.push_back(motion);
        }
    }
    return motions;
}

// The folder of both files, made where there is none.
fs::path folder_of(const CostsOptions& options) {
    fs::path folder = options.output;
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) {
        throw InputError(folder.string(), "", "cannot be made: " + error.message());
    }
    check_writable(folder / "costs.json");
    check_writable(folder / "costs.html");
    return folder;
}

// Both, or none.
void write(const fs::path& folder, const std::vector<SceneCosts>& scenes, const CostsHead& head) {
    AtomicFile json(folder / "costs.json"), page(folder / "costs.html");
    json.write(costs_json(scenes, head).dump(2) + '\n');
    page.write(costs_html(scenes, head));
    json.finish();
    page.finish();
    json.commit();
    page.commit();
}

ExitCode run(const CostsOptions& options) {
    ChosenSettings chosen(options.settings);
    Settings& settings = chosen.settings;
    if (!options.technique.empty()) {
        settings.set_from_text("gi.technique", options.technique);
    }
    CostsJob job = options.job;
    job.frames.size = parse_size("--size", options.size, 1, kLargestPicture);
    job.motions = motions_of(options);
    std::vector<MotionScene> scenes;
    for (const std::string& text : options.scenes) {
        scenes.push_back(open_scene(text, options.view));
    }
    for (const MotionScene& scene : scenes) {
        const MovingScene shown(scene.data, scene.view, Motion::rest, 1);  // refused before anything is made
    }
    const fs::path folder = folder_of(options);
    CostsHead head{job.frames.size,
                   job.frames.warmup,
                   job.frames.frames,
                   job.rounds,
                   gi::technique_entry(gi::gi_settings(settings).technique).name,
                   options.settings.preset,
                   options.settings.set,
                   "",
                   build_words(),
                   ""};

    // Lights come on top, which are not counted yet.
    const std::uint64_t steps = scenes.size() * job.motions.size() * static_cast<std::size_t>(job.rounds) *
                                (rule_switches().size() + 1);
    std::uint64_t done = 0;
    MeasuredSteps work("measure", "the scenes that are done are kept where -o says", steps);
    std::vector<SceneCosts> costs;
    for (const MotionScene& scene : scenes) {
        costs.push_back(measure_costs(scene, settings, job, [&] { work.step(done++ < steps ? 1 : 0); }));
        head.time = time_words(costs.back().motions.front().planned.software);
        head.renderer = costs.back().motions.front().planned.renderer;
        write(folder, costs, head);
        if (!options.json) {
            fmt::print("{}", costs_text(costs.back(), head));
            std::fflush(stdout);
        }
    }
    if (options.json) {
        fmt::print("{}\n", costs_json(costs, head).dump(2));
    }
    return ExitCode::ok;
}

}  // namespace

Command add_measure_costs(CLI::App& measure) {
    auto options = std::make_shared<CostsOptions>();
    CLI::App* command = measure.add_subcommand(
        "costs",
        "Where each millisecond and megabyte goes: by pass, by light, by asset; what the plan left out, and "
        "what that would have cost (docs/costs.md).");
    add_scenes_option(*command, options->scenes);
    command
        ->add_option("-o,--output", options->output,
                     "folder for costs.json and costs.html, which needs no network; made where there is none")
        ->type_name("DIR")
        ->required();
    command->add_option("--technique", options->technique,
                        fmt::format("indirect light: one of {} (gi.technique; default: emc)",
                                    fmt::join(gi::technique_names(), ", ")));
    command
        ->add_option("--motion", options->motions,
                     "beside rest: lamp, dim, walk, pan, box, figure, separated by commas; lights are muted "
                     "in the first of them, too, that is not dim")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember(kMotionsOfCosts));
    command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command->add_option("--frames", options->job.frames.frames, "that are measured, of each case")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command->add_option("--warmup", options->job.frames.warmup, "frames before, in motion too")
        ->check(CLI::Range(0, 100000))
        ->capture_default_str();
    command
        ->add_option("--rounds", options->job.rounds,
                     "how often all cases are measured, one after the other; times are medians")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command
        ->add_option("--lights", options->job.lights,
                     "lights that are muted in turn at most, those that give most")
        ->check(CLI::Range(0, 100000))
        ->capture_default_str();
    add_camera_option(*command, options->view.camera);
    add_moment_options(*command, options->view, "at which all stands but what moves (default: 0)");
    add_settings_options(*command, options->settings);
    command->add_flag("--json", options->json, "print what costs.json holds instead of tables");
    return [options] { return run(*options); };
}

}  // namespace lanthorn::tools

// lanthorn measure estimate SCENE... --held SCENE... -o DIR: errors that are estimated without a reference,
// beside the true ones.
#include "tools/lanthorn/measure/estimate_command.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/choice.h"
#include "lanthorn/workbench/all_settings.h"
#include "tools/lanthorn/common/common_options.h"
#include "tools/lanthorn/measure/estimate_report.h"
#include "tools/lanthorn/measure/scene_list.h"
#include "tools/workbench/scene/stopping.h"

namespace lanthorn::tools {

namespace {

struct EstimateOptions {
    std::vector<std::string> scenes, held, presets, motions;
    SettingsChoice settings;
    SceneView view;
    MotionJob job;
    std::string size = "256x256", references, output;
    int spp = 128;
    bool fit = false;
};

MotionCase preset_case(const std::string& preset, const EstimateOptions& options,
                       const SettingsSchema& schema) {
    SettingsChoice choice = options.settings;
    choice.preset = preset;
    return case_of(preset, choice, schema);
}

ExitCode run(EstimateOptions options) {
    SettingsSchema schema;
    declare_all_settings(schema);
    MotionJob& job = options.job;
    job.size = parse_size("--size", options.size, 1, kLargestPicture);
    job.motions = motions_named(options.motions);
    std::vector<MotionCase> cases;
    for (const std::string& preset : options.presets) {
        cases.push_back(preset_case(preset, options, schema));
    }
    if (!options.output.empty()) {
        std::filesystem::create_directories(options.output);
    }
    ReferencePairs references(options.references, options.spp);
    MeasuredSteps work("measure", "nothing is written",
                       (options.scenes.size() + options.held.size()) * cases.size() * job.motions.size());
    std::vector<EstimatePoint> points;
    const auto measure = [&](const std::string& text, bool held) {
        const MotionScene scene = open_scene(text, options.view);
        for (EstimatePoint& point : measure_estimates(scene, cases, job, references, [&] { work.step(); })) {
            point.held = held;
            points.push_back(std::move(point));
        }
    };
    for (const std::string& scene : options.scenes) {
        measure(scene, false);
    }
    for (const std::string& scene : options.held) {
        measure(scene, true);
    }
    fmt::print("{}", estimate_table(points));
    if (options.fit) {
        fmt::print("{}", fit_text(points));
    }
    if (!options.output.empty()) {
        const std::filesystem::path folder = options.output;
        write_file(folder / "estimate.csv", estimate_csv(points));
        write_file(folder / "estimate.svg", estimate_svg(points));
    }
    return ExitCode::ok;
}

}  // namespace

Command add_measure_estimate(CLI::App& measure) {
    auto options = std::make_shared<EstimateOptions>();
    options->presets = {"low", "medium", "high"};
    options->motions = {"rest", "lamp", "walk", "box", "figure"};
    CLI::App* command = measure.add_subcommand("estimate",
                                               "How near the error that a picture is estimated to have, "
                                               "without a reference, comes to the true one.");
    command->add_option("SCENE", options->scenes, "glTF 2.0 files, FILE@CAMERA for one of its cameras")
        ->required();
    command->add_option("--held", options->held, "repeatable: more scenes, which --fit does not look at")
        ->allow_extra_args(false);
    command->add_option("-o,--output", options->output, "folder for estimate.csv and estimate.svg")
        ->type_name("DIR");
    command->add_option("--presets", options->presets, "presets that are measured, separated by commas")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember({"low", "medium", "high", "ultra"}))
        ->capture_default_str();
    command
        ->add_option("--motion", options->motions,
                     "rest, lamp, dim, walk, pan, cut, box, figure, separated by commas")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember({"rest", "lamp", "dim", "walk", "pan", "cut", "box", "figure"}))
        ->capture_default_str();
    options->job.frames = 20;
    command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command->add_option("--frames", options->job.frames, "frames of each motion; the last one is judged")
        ->check(CLI::Range(kChanges + 1, 100000))
        ->capture_default_str();
    command->add_option("--spp", options->spp, "samples a pixel of the references")
        ->check(CLI::Range(2, 1000000))
        ->capture_default_str();
    command
        ->add_option("--references", options->references, "folder that keeps the references for the next run")
        ->type_name("DIR");
    command->add_flag("--fit", options->fit,
                      "print the weights that fit the scenes best, as error_model.cpp has them");
    add_moment_options(*command, options->view, "at which all stands but what moves (default: 0)");
    add_settings_options(*command, options->settings);
    return [options] { return run(*options); };
}

}  // namespace lanthorn::tools

// lanthorn measure motions SCENE...: indirect light while things move, settings side by side.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "lanthorn/core/choice.h"
#include "lanthorn/workbench/all_settings.h"
#include "lanthorn/workbench/measure_motions.h"
#include "tools/lanthorn/common/common_options.h"
#include "tools/lanthorn/common/workbench.h"
#include "tools/lanthorn/measure/measure_report.h"
#include "tools/lanthorn/measure/motions_command.h"
#include "tools/lanthorn/measure/scene_list.h"
#include "tools/workbench/scene/stopping.h"

namespace lanthorn::tools {

namespace {

constexpr int kLeastFrames = kChanges + 1;

struct MotionsOptions {
    std::vector<std::string> scenes, cases, motions;
    SettingsChoice settings;
    SceneView view;
    MotionJob job;
    std::string size = "512x512", references;
    int spp = 256;
    bool json = false;
};

// "KEY=VALUE ...", "preset=NAME" among them, over what all cases have.
MotionCase open_case(const std::string& text, const SettingsChoice& common, const SettingsSchema& schema) {
    SettingsChoice choice = common;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find_first_of(" ,", start), text.size());
        const std::string word = text.substr(start, end - start);
        if (word.starts_with("preset=")) {
            choice.preset = word.substr(7);
        } else if (!word.empty()) {
            choice.set.push_back(word);
        }
        start = end + 1;
    }
    return case_of(text, choice, schema);
}

ExitCode run(MotionsOptions options) {
    SettingsSchema schema;
    declare_all_settings(schema);
    MotionJob& job = options.job;
    job.size = parse_size("--size", options.size, 1, kLargestPicture);
    job.motions = motions_named(options.motions);
    std::vector<MotionCase> cases;
    for (const std::string& text : options.cases) {
        cases.push_back(open_case(text, options.settings, schema));
    }
    if (cases.empty()) {
        cases.push_back(open_case("", options.settings, schema));
        cases.back().name = "as set";
    }
    std::vector<MotionScene> scenes;
    for (const std::string& text : options.scenes) {
        scenes.push_back(open_scene(text, options.view));
    }
    ReferencePairs references(options.references, options.spp);

    MeasuredSteps work("measure", "the scenes that are done are printed",
                       scenes.size() * cases.size() * job.motions.size());
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const MotionScene& scene : scenes) {
        const bool whole = work.part([&] {
            const auto figures = measure_motions(scene, cases, job, references, [&] { work.step(); });
            if (options.json) {
                list.push_back(motions_json(scene, cases, figures));
            } else {
                fmt::print("{}\n", motions_table(scene, cases, figures, job, references.spp()));
                std::fflush(stdout);
            }
        });
        if (!whole) {
            break;
        }
    }
    if (options.json) {
        nlohmann::ordered_json root{{"measure", "motions"},
                                    {"size", {job.size.x, job.size.y}},
                                    {"frames", job.frames},
                                    {"reference_spp", references.spp()},
                                    {"references_traced", references.traced()},
                                    {"preset", options.settings.preset},
                                    {"set", options.settings.set},
                                    {"scenes", std::move(list)}};
        fmt::print("{}\n", root.dump(2));
    }
    work.finish();
    return ExitCode::ok;
}

}  // namespace

Command add_measure_motions(CLI::App& measure) {
    auto options = std::make_shared<MotionsOptions>();
    options->motions = {"rest", "lamp", "dim", "walk", "pan", "cut", "box", "figure"};
    const std::vector<std::string> all = options->motions;
    CLI::App* command = measure.add_subcommand("motions",
                                               "Error, flicker and time of indirect light while lamp, camera "
                                               "and things move; settings side by side.");
    add_scenes_option(*command, options->scenes);
    command
        ->add_option("--case", options->cases,
                     "repeatable: settings that are measured beside the others, \"KEY=VALUE KEY=VALUE\", "
                     "preset=NAME among them (default: one case, as --preset and --set have it)")
        ->allow_extra_args(false);
    command
        ->add_option("--motion", options->motions,
                     "rest, lamp, dim, walk, pan, cut, box, figure (default: all), separated by commas")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember(all));
    command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command->add_option("--frames", options->job.frames, "frames of each motion; the last one is compared")
        ->check(CLI::Range(kLeastFrames, 100000))
        ->capture_default_str();
    command->add_option("--spp", options->spp, "samples a pixel of the references")
        ->check(CLI::Range(2, 1000000))
        ->capture_default_str();
    command
        ->add_option("--references", options->references,
                     "folder that keeps the references for the next run; default: they are forgotten")
        ->type_name("DIR");
    command
        ->add_option("--reference-bounces", options->job.reference_bounces,
                     "bounces of the references; default: gi.bounces of each case")
        ->check(CLI::Range(1, 64));
    add_camera_option(*command, options->view.camera);
    add_moment_options(*command, options->view, "at which all stands but what moves (default: 0)");
    add_settings_options(*command, options->settings);
    command->add_flag("--json", options->json, "print one JSON object");
    return [options] { return run(*options); };
}

}  // namespace lanthorn::tools

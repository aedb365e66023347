// lanthorn measure plan SCENE... -o DIR: each rule of the plan on and off.
#include "tools/lanthorn/measure/plan_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>

#include "engine/build_info/build_info.h"
#include "engine/core/json.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/choice.h"
#include "lanthorn/workbench/all_settings.h"
#include "lanthorn/workbench/measure_motions.h"
#include "tools/lanthorn/common/common_options.h"
#include "tools/lanthorn/common/workbench.h"
#include "tools/lanthorn/measure/plan_figures.h"
#include "tools/lanthorn/measure/scene_list.h"
#include "tools/workbench/scene/median.h"
#include "tools/workbench/scene/stopping.h"

namespace lanthorn::tools {

namespace fs = std::filesystem;

namespace {

using nlohmann::ordered_json;

struct PlanOptions {
    std::vector<std::string> scenes, motions = {"rest", "lamp", "walk", "box"}, rules;
    SettingsChoice settings;
    SceneView view;
    std::string size = "192x192", output;
    int frames = 24, rounds = 3, spp = 128;
    bool json = false;
};

MotionJob job_of(const PlanOptions& options) {
    MotionJob job;
    job.size = parse_size("--size", options.size, 1, kLargestPicture);
    job.frames = options.frames;
    job.motions = motions_named(options.motions);
    return job;
}

// Those that are asked for, or all.
std::vector<std::string> rules_of(const PlanOptions& options) {
    std::vector<std::string> rules;
    if (options.rules.empty()) {
        std::ranges::transform(rule_switches(), std::back_inserter(rules), &RuleSwitch::setting);
    }
    for (const std::string& rule : options.rules) {
        rules.push_back(rule_named(rule).setting);
    }
    return rules;
}

// All rules on; each off; all off, unless some were asked for.
std::vector<MotionCase> cases_of(const PlanOptions& options, const SettingsSchema& schema) {
    std::vector<MotionCase> cases = {case_of("planned", options.settings, schema)};
    Settings everything = cases.front().settings;
    for (const std::string& rule : rules_of(options)) {
        Settings off = cases.front().settings;
        off.set<bool>(rule, false);
        everything.set<bool>(rule, false);
        cases.push_back({rule, std::move(off)});
    }
    if (options.rules.empty()) {
        cases.push_back({"everything on", std::move(everything)});
    }
    return cases;
}

// Of what each round found: medians of times; errors and memory are the same in all.
PlanScene over_rounds(const std::string& name, const std::vector<std::string>& rules,
                      const std::vector<std::vector<std::vector<MotionFigures>>>& rounds) {
    PlanScene scene;
    scene.name = name;
    scene.rules = rules;
    const auto& first = rounds.front();
    scene.cases.resize(first.size());
    for (std::size_t m = 0; m < first.front().size(); ++m) {
        if (!first.front()[m].lacking.empty()) {
            continue;
        }
        scene.motions.push_back(name_of(first.front()[m].motion));
        for (std::size_t c = 0; c < first.size(); ++c) {
            const auto all = [&](double MotionFigures::*member) {
                std::vector<double> values;
                values.reserve(rounds.size());
                for (const auto& round : rounds) {
                    values.push_back(round[c][m].*member);
                }
                return median(std::move(values));
            };
            const MotionFigures& f = first[c][m];
            scene.cases[c].push_back({all(f.software ? &MotionFigures::gi_cpu : &MotionFigures::gi),
                                      all(f.software ? &MotionFigures::direct_cpu : &MotionFigures::direct),
                                      f.error.relrmse, f.gpu_mb});
        }
    }
    if (scene.motions.empty()) {
        throw InputError(name, "", "has nothing that moves, expected one of the motions to be possible");
    }
    return scene;
}

// The files of a run: what is measured of a scene is kept.
class PlanFolder {
  public:
    PlanFolder(const PlanOptions& options, const MotionJob& job) : folder_(options.output) {
        key_ = ordered_json{{"size", {job.size.x, job.size.y}},
                            {"frames", job.frames},
                            {"rounds", options.rounds},
                            {"spp", options.spp},
                            {"motions", options.motions},
                            {"rules", options.rules},
                            {"preset", options.settings.preset},
                            {"set", options.settings.set},
                            {"commit", kCommit},
                            {"build", kBuildType}};
        if (!folder_.empty()) {
            std::error_code error;
            fs::create_directories(folder_, error);
            if (error) {
                throw InputError(folder_.string(), "", "cannot be made: " + error.message());
            }
        }
    }

    std::string references() const {
        return folder_.empty() ? std::string() : (folder_ / "references").string();
    }
    // What an earlier run found, by the same measurement.
    std::optional<PlanScene> kept(const std::string& name) const {
        std::ifstream stream(file(name), std::ios::binary);
        if (folder_.empty() || !stream) {
            return {};
        }
        const std::string text{std::istreambuf_iterator<char>(stream), {}};
        try {
            const ordered_json json = parse_ordered_json(text, file(name).string());
            return json.value("measurement", ordered_json()) == key_
                       ? std::optional(plan_from_json(json, file(name).string()))
                       : std::nullopt;
        } catch (const InputError&) {
            return {};  // damaged: measured again
        }
    }
    void keep(const PlanScene& scene) const {
        if (!folder_.empty()) {
            ordered_json json = plan_json(scene);
            json["measurement"] = key_;
            write_file(file(scene.name), json.dump(2) + '\n');
        }
    }
    void write(const std::vector<PlanScene>& scenes) const {
        if (!folder_.empty()) {
            write_file(folder_ / "plan.md", plan_markdown(scenes));
            write_file(folder_ / "plan.json", plan_json(scenes).dump(2) + '\n');
        }
    }

  private:
    fs::path file(const std::string& name) const { return folder_ / ("scene-" + name + ".json"); }

    fs::path folder_;
    ordered_json key_;
};

ExitCode run(const PlanOptions& options) {
    SettingsSchema schema;
    declare_all_settings(schema);
    const MotionJob job = job_of(options);
    const std::vector<MotionCase> cases = cases_of(options, schema);
    const PlanFolder folder(options, job);
    ReferencePairs references(folder.references(), options.spp);
    const auto rounds = static_cast<std::size_t>(options.rounds);
    const std::uint64_t steps = rounds * cases.size() * job.motions.size();  // of a scene
    MeasuredSteps work("measure", "the scenes that are done are kept where -o says",
                       options.scenes.size() * steps);
    std::vector<PlanScene> scenes;
    for (const std::string& text : options.scenes) {
        if (std::optional<PlanScene> kept = folder.kept(listed_scene(text, options.view).name)) {
            scenes.push_back(std::move(*kept));
            work.step(steps);
            continue;
        }
        const MotionScene scene = open_scene(text, options.view);
        std::vector<std::vector<std::vector<MotionFigures>>> of_rounds;
        of_rounds.reserve(rounds);
        for (int round = 0; round < options.rounds; ++round) {
            of_rounds.push_back(measure_motions(scene, cases, job, references, [&] { work.step(); }));
        }
        scenes.push_back(over_rounds(scene.name, rules_of(options), of_rounds));
        folder.keep(scenes.back());
    }
    folder.write(scenes);
    if (options.json) {
        fmt::print("{}\n", plan_json(scenes).dump(2));
    } else {
        fmt::print("{}", plan_markdown(scenes));
    }
    return ExitCode::ok;
}

}  // namespace

Command add_measure_plan(CLI::App& measure) {
    auto options = std::make_shared<PlanOptions>();
    CLI::App* command = measure.add_subcommand("plan",
                                               "Each rule by which the plan leaves work out, on and off: "
                                               "milliseconds of processor time, error against "
                                               "path, memory; and all on against all off (docs/plan.md).");
    add_scenes_option(*command, options->scenes);
    command->add_option("-o,--output", options->output,
                        "folder for plan.md, plan.json and, beside them, each scene's figures and "
                        "references: the same command "
                        "again measures only what is missing");
    command
        ->add_option(
            "--motion", options->motions,
            "rest, lamp, dim, walk, pan, box, figure (default: rest, lamp, walk, box), separated by commas")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember({"rest", "lamp", "dim", "walk", "pan", "box", "figure"}));
    command
        ->add_option(
            "--rule", options->rules,
            "rules to measure, by their settings, separated by commas (default: all, and all of them "
            "off at once)")
        ->delimiter(',')
        ->allow_extra_args(false);
    command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command->add_option("--frames", options->frames, "frames of each motion; the second half is measured")
        ->check(CLI::Range(kChanges + 1, 100000))
        ->capture_default_str();
    command
        ->add_option("--rounds", options->rounds,
                     "how often all cases are measured, one after the other; times are medians")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_option("--spp", options->spp, "samples a pixel of the references")
        ->check(CLI::Range(2, 1000000))
        ->capture_default_str();
    add_moment_options(*command, options->view, "at which all stands but what moves (default: 0)");
    add_settings_options(*command, options->settings);
    command->add_flag("--json", options->json, "print each scene's figures as one JSON object");
    return [options] { return run(*options); };
}

}  // namespace lanthorn::tools

// lanthorn measure budget SCENE --budget-ms X -o DIR: how a budget is kept while things happen.
#include "tools/lanthorn/measure/budget_command.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/choice.h"
#include "lanthorn/core/progress.h"
#include "lanthorn/core/stop_signal.h"
#include "tools/lanthorn/common/common_options.h"
#include "tools/lanthorn/measure/budget_report.h"
#include "tools/lanthorn/measure/scene_list.h"
#include "tools/workbench/scene/stopping.h"

namespace lanthorn::tools {

namespace {

struct BudgetOptions {
    std::string scene, output, motion = "walk", size = "512x512";
    SettingsChoice settings;
    SceneView view;
    BudgetRunJob job;
};

ExitCode run(BudgetOptions options) {
    const ChosenSettings chosen(options.settings);
    BudgetRunJob& job = options.job;
    job.size = parse_size("--size", options.size, 1, kLargestPicture);
    job.motion = motion_named(options.motion);
    const MotionScene scene = open_scene(options.scene, options.view);
    if (!options.output.empty()) {
        std::filesystem::create_directories(options.output);
    }
    const StopSignal stop;
    Progress progress("rendering", static_cast<std::uint64_t>(job.frames));
    std::uint64_t done = 0;
    const BudgetRecord record = measure_budget(scene, chosen.settings, job, [&] {
        progress.update(++done);
        stop_if_asked("measure", "nothing is written");
    });
    fmt::print("{}", budget_text(record, job));
    if (!options.output.empty()) {
        const std::filesystem::path folder = options.output;
        const std::string title = fmt::format("{}, {} of {}x{}: {:g} ms", scene.name, options.motion,
                                              job.size.x, job.size.y, job.wish.ms) +
                                  (job.wish.error > 0 ? fmt::format(", error {:g}", job.wish.error) : "");
        write_file(folder / "budget.csv", budget_csv(record));
        write_file(folder / "budget.svg", budget_svg(record, job, title));
    }
    return ExitCode::ok;
}

}  // namespace

Command add_measure_budget(CLI::App& measure) {
    auto options = std::make_shared<BudgetOptions>();
    CLI::App* command = measure.add_subcommand(
        "budget",
        "How a time or an error is kept while things begin to move and another program takes a core: times, "
        "errors, pixels and decisions by frame.");
    add_scene_option(*command, options->scene)->required();
    command->add_option("--budget-ms", options->job.wish.ms, "milliseconds that a frame may take")
        ->check(number_between(1e-6, 1e9));
    command->add_option("--target-error", options->job.wish.error, "indirect relRMSE that suffices")
        ->check(number_between(1e-6, 1e6));
    command->add_flag("--budget-processor", options->job.wish.processor,
                      "by processor time of all threads, which other programs hardly alter");
    command->add_option("-o,--output", options->output, "folder for budget.csv and budget.svg")
        ->type_name("DIR");
    command->add_option("--motion", options->motion, "lamp, dim, walk, pan, box or figure")
        ->check(CLI::IsMember({"lamp", "dim", "walk", "pan", "box", "figure"}))
        ->capture_default_str();
    command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command->add_option("--frames", options->job.frames, "frames of the run")
        ->check(CLI::Range(20, 100000))
        ->capture_default_str();
    add_moment_options(*command, options->view, "at which all stands but what moves (default: 0)");
    add_settings_options(*command, options->settings);
    return [options] { return run(*options); };
}

}  // namespace lanthorn::tools

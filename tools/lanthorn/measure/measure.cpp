// lanthorn measure
// hits|coverage|flicker|energy|effects|motions|frames|costs|estimate|budget|photons|plan|why|contracts SCENE:
// what an image cannot tell of the indirect light.
#include <fmt/format.h>

#include <memory>
#include <utility>
#include <vector>

#include "lanthorn/core/choice.h"
#include "lanthorn/core/progress.h"
#include "lanthorn/core/stop_signal.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/gi/technique.h"
#include "lanthorn/workbench/all_settings.h"
#include "lanthorn/workbench/load_scene.h"
#include "tools/lanthorn/commands.h"
#include "tools/lanthorn/common/common_options.h"
#include "tools/lanthorn/common/warnings.h"
#include "tools/lanthorn/common/workbench.h"
#include "tools/lanthorn/measure/budget_command.h"
#include "tools/lanthorn/measure/contracts_command.h"
#include "tools/lanthorn/measure/costs_command.h"
#include "tools/lanthorn/measure/estimate_command.h"
#include "tools/lanthorn/measure/frames_command.h"
#include "tools/lanthorn/measure/measure_report.h"
#include "tools/lanthorn/measure/motions_command.h"
#include "tools/lanthorn/measure/photons_command.h"
#include "tools/lanthorn/measure/plan_command.h"
#include "tools/lanthorn/measure/why_command.h"
#include "tools/workbench/scene/stopping.h"

namespace lanthorn::tools {

namespace {

struct MeasureOptions {
    std::string scene;
    SettingsChoice settings;
    FlickerJob flicker;  // its view is every measure's
    std::string size = "256x256", motion = "light";
    int points = 20000;
    EffectsJob effects;
    bool json = false;
};

std::uint64_t flight_count(const PhotonFlights& flights) {
    std::uint64_t count = 0;
    for (const auto& bounce : flights.bounces) {
        count += bounce.size();
    }
    return count;
}

// Throws Stopped if somebody wants no more.
void go_on(Progress& progress, std::uint64_t done) {
    progress.update(done);
    stop_if_asked("measure", "a part of a measurement tells nothing");
}

// Settings, scene and photons of a measurement, as its options ask.
// Of the photons that splats would show, whichever stage makes the picture.
PhotonFlights flights_of(const MeasureOptions& options, Settings& settings) {
    options.settings.apply_to(settings);
    settings.set_from_text("gi.emc.final=splat");
    SceneView view = options.flicker.view;
    SceneData scene = tell_warnings(options.scene, load_scene(options.scene, view));
    view.camera = "auto";  // photons do not depend on it
    return trace_photons(std::move(scene), settings, view);
}

MeasureReport run_hits(const MeasureOptions& options, Settings& settings) {
    const PhotonFlights flights = flights_of(options, settings);
    Progress progress("tracing exact rays", flight_count(flights));
    return report(measure_hits(flights, [&](std::uint64_t done) { go_on(progress, done); }));
}

MeasureReport run_coverage(const MeasureOptions& options, Settings& settings) {
    const PhotonFlights flights = flights_of(options, settings);
    Progress progress("asking points", static_cast<std::uint64_t>(options.points));
    const CoverageFigures figures = measure_coverage(flights, options.points, gi::gi_settings(settings).seed,
                                                     [&](std::uint64_t done) { go_on(progress, done); });
    if (figures.reached == 0) {
        throw InputError(options.scene, "", "found no surface that reflected light reaches, expected some");
    }
    return report(figures);
}

MeasureReport run_energy(const MeasureOptions& options, Settings& settings) {
    const PhotonFlights flights = flights_of(options, settings);
    Progress progress("tracing exact rays", flight_count(flights));
    return report(measure_energy(flights, [&](std::uint64_t done) { go_on(progress, done); }));
}

MeasureReport run_flicker(const MeasureOptions& options, Settings& settings) {
    FlickerJob job = options.flicker;
    job.size = parse_size("--size", options.size, 1, kLargestPicture);
    job.motion = options.motion == "pan" ? FlickerMotion::pan : FlickerMotion::light;
    options.settings.apply_to(settings);
    Progress progress("rendering", static_cast<std::uint64_t>(job.warmup + job.frames + 1));
    MeasureReport result =
        report(measure_flicker(tell_warnings(options.scene, load_scene(options.scene, job.view)), settings,
                               job, [&](std::uint64_t done) { go_on(progress, done); }));
    result.table +=
        fmt::format("irradiance, against path by {} transport\n", settings.text("path.transport"));
    result.figures["transport"] = settings.text("path.transport");
    result.figures["technique"] = gi::technique_entry(gi::gi_settings(settings).technique).name;
    result.figures["motion"] = options.motion;
    result.figures["step"] = job.step;
    result.figures["frames"] = job.frames;
    return result;
}

MeasureReport run_effects(const MeasureOptions& options, Settings& settings) {
    EffectsJob job = options.effects;
    job.size = parse_size("--size", options.size, 1, kLargestPicture);
    job.view = options.flicker.view;
    options.settings.apply_to(settings);
    Progress progress("pictures", 8);
    return report(
        measure_effects([&] { return tell_warnings(options.scene, load_scene(options.scene, job.view)); },
                        settings, job, [&](std::uint64_t done) { go_on(progress, done); }));
}

struct Measure {
    const char* name;
    const char* about;
    MeasureReport (*run)(const MeasureOptions&, Settings&);
};
constexpr Measure kMeasures[] = {
    {"hits", "Share of photon segments whose image-space hit lies within 2 % of the diagonal of Embree's.",
     run_hits},
    {"coverage", "Area share of what reflected light reaches that a selected map sees, by Embree.",
     run_coverage},
    {"flicker", "Change from frame to frame of indirect light in a slow motion, over the reference's own.",
     run_flicker},
    {"energy", "Where the lights' flux goes: stored, absorbed, lost, by bounce.", run_energy},
    {"effects", "Diffuse light, caustics, sky, what metal and glass show: each beside the path tracer's.",
     run_effects}};

ExitCode run(const Measure& measure, const MeasureOptions& options) {
    SettingsSchema schema;
    declare_all_settings(schema);
    Settings settings = measured_settings(schema);
    const StopSignal stop;
    const MeasureReport result = measure.run(options, settings);
    if (!options.json) {
        fmt::print("{}", result.table);
        return ExitCode::ok;
    }
    const SettingsChoice& choice = options.settings;
    nlohmann::ordered_json root{
        {"measure", measure.name}, {"scene", options.scene}, {"preset", nullptr}, {"set", choice.set}};
    if (!choice.preset.empty()) {
        root["preset"] = choice.preset;
    }
    root.update(result.figures);
    fmt::print("{}\n", root.dump(2));
    return ExitCode::ok;
}

void add_common(CLI::App& command, MeasureOptions& options) {
    add_scene_option(command, options.scene)->required();
    add_moment_options(command, options.flicker.view, "that is measured, standing still (default: 0)");
    add_settings_options(command, options.settings);
    command.add_flag("--json", options.json, "print one JSON object");
}

void add_coverage_options(CLI::App& command, MeasureOptions& options) {
    command.add_option("--points", options.points, "points asked, spread evenly over all surfaces")
        ->check(CLI::Range(1, 100000000))
        ->capture_default_str();
}

void add_effects_options(CLI::App& command, MeasureOptions& options) {
    EffectsJob& job = options.effects;
    command.add_option("--size", options.size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    add_camera_option(command, options.flicker.view.camera);
    command.add_option("--frames", job.frames, "frames of the technique before it is looked at")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command.add_option("--spp", job.spp, "samples a pixel of the reference")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
}

void add_flicker_options(CLI::App& command, MeasureOptions& options) {
    FlickerJob& job = options.flicker;
    command.add_option("--motion", options.motion, "light or pan")
        ->check(CLI::IsMember({"light", "pan"}))
        ->capture_default_str();
    command.add_option("--size", options.size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    add_camera_option(command, job.view.camera);
    command.add_option("--frames", job.frames, "changes from frame to frame to measure")
        ->check(CLI::Range(2, 100000))
        ->capture_default_str();
    command.add_option("--warmup", job.warmup, "frames of the motion before")
        ->check(CLI::Range(0, 100000))
        ->capture_default_str();
    command.add_option("--step", job.step, "motion a frame: share of the scene's diagonal; radians of turns")
        ->check(number_between(1e-6, 1))
        ->capture_default_str();
    command.add_option("--spp", job.spp, "samples a pixel of the reference, in each frame")
        ->check(CLI::Range(2, 1000000))
        ->capture_default_str();
}

}  // namespace

Command add_measure(CLI::App& app) {
    auto options = std::make_shared<MeasureOptions>();
    CLI::App* command =
        app.add_subcommand("measure", "What an image cannot tell of a scene's indirect light.");
    for (const Measure& measure : kMeasures) {
        add_common(*command->add_subcommand(measure.name, measure.about), *options);
    }
    add_coverage_options(*command->get_subcommand("coverage"), *options);
    add_effects_options(*command->get_subcommand("effects"), *options);
    add_flicker_options(*command->get_subcommand("flicker"), *options);
    const std::vector<std::pair<const char*, Command>> others = {
        {"motions", add_measure_motions(*command)},    {"frames", add_measure_frames(*command)},
        {"costs", add_measure_costs(*command)},        {"estimate", add_measure_estimate(*command)},
        {"budget", add_measure_budget(*command)},      {"photons", add_measure_photons(*command)},
        {"plan", add_measure_plan(*command)},          {"why", add_measure_why(*command)},
        {"contracts", add_measure_contracts(*command)}};
    return [options, command, others] {
        for (const auto& [name, measure] : others) {
            if (command->got_subcommand(name)) {
                return measure();
            }
        }
        for (const Measure& measure : kMeasures) {
            if (command->got_subcommand(measure.name)) {
                return run(measure, *options);
            }
        }
        throw InputError(
            "measure: found no measure, expected hits, coverage, flicker, energy, effects, motions, frames, "
            "costs, estimate, budget, photons, plan, why or contracts");
    };
}

}  // namespace lanthorn::tools
